// The pipeline of [Lee2003, Fig. 3], cell by cell, and round it the chain of attempts: all as asked; then, in the cells
// where that breaks the promise and only there, otherwise.
#include "quadline/generate.hpp"

#include <optional>
#include <utility>

#include "cells/attempt.hpp"
#include "cells/cell_meshes.hpp"
#include "cells/chain_attempts.hpp"
#include "cells/flatten.hpp"
#include "cells/missed_edges.hpp"
#include "cells/node_orbits.hpp"
#include "cells/quad_limit.hpp"
#include "domain/arrange/arrange.hpp"
#include "domain/size/edge_sizes.hpp"
#include "inspect/fill_report.hpp"
#include "stages/smooth/smooth.hpp"
#include "stages/verify/verify.hpp"

namespace quadline {

namespace {

Attempt failed(std::vector<Trouble> troubles, Failure failure, Attempt attempt = {}) {
  attempt.result.failure = std::move(failure);
  attempt.troubles = std::move(troubles);
  return attempt;
}

Attempt run_stages(const FallbackPlan& plan, const Options& options, CellCache& cache, StageClock& clock,
                   Context& context) {
  const Domain& domain = plan.domain();
  const QuadLimit limit(options);
  Attempt attempt;
  MeshResult& result = attempt.result;
  if (attempt.too_many = limit.refuse_expected(domain); !attempt.too_many.empty()) return attempt;

  const SizeField size = clock.run("sizing", context, [&] { return make_size_field(domain, options, context); });
  const CurveNodes nodes = clock.run("discretize", context, [&] {
    return CurveNodes(domain, size, plan.wished_counts(), plan.symmetries(), plan.halved_cells(), context);
  });
  if (attempt.too_many = limit.refuse_at_least(nodes.least_quads()); !attempt.too_many.empty()) return attempt;

  CellMeshes cells(plan, nodes, size, cache, clock, context);  // mesh_cell for each
  result.report.qmorph = cells.morph_counts();
  result.report.before_smoothing =
      clock.run("measure", context, [&] { return measure(flatten(cells.take_raw(), domain)); });
  WorkMesh mesh;
  do {
    if (const auto troubles = cells.troubles(); !troubles.empty())
      return failed(troubles, {"internal", troubles[0].reason, troubles[0].at}, std::move(attempt));
    result.report.cells = cells.origins();
    mesh = clock.run("join", context, [&] { return cells.take_joined(); });
    if (context.on_snapshot) context.on_snapshot("clean-up", flatten(mesh, domain));
    clock.run("smooth", context, [&] { smooth(mesh, domain, size, {.criteria = options.criteria}, context); });
    mesh.thaw();
    NodeOrbits(mesh, domain, plan.symmetries()).even_out(mesh);
  } while (cells.mesh_spoiled_again(mesh));

  result.mesh = flatten(mesh, domain);
  if (attempt.too_many = limit.refuse_made(result.mesh.quads.size()); !attempt.too_many.empty()) return attempt;
  result.failure = clock.run("verify", context, [&] { return verify(result.mesh, plan.model(), context); });
  if (context.on_snapshot) context.on_snapshot("smoothed", result.mesh);
  if (result.failure) {
    attempt.troubles = unsound_cells(mesh);
    if (attempt.troubles.empty()) attempt.troubles = troubles_at(domain, result.failure->at, result.failure->reason);
  } else {
    result.edge_sizes = edge_sizes(result.mesh, size);
    result.report.findings = plan.findings(mesh);
    append_missed_edges(plan.model(), result.mesh, result.report.findings);
  }
  return attempt;
}

}  // namespace

Attempt attempt_mesh(const FallbackPlan& plan, const Options& options, CellCache& cache, StageClock& clock,
                     Context& context) {
  try {
    return run_stages(plan, options, cache, clock, context);
  } catch (const InternalError& error) {
    const std::optional<Point> at = error.where().point;
    return failed(troubles_at(plan.domain(), at, error.what()), {"internal", error.what(), at.value_or(Point{})});
  }
}

MeshResult generate(const Model& model, const Options& options, Context& context) {
  check(options);
  StageClock clock;
  Domain domain = clock.run("arrange", context, [&] { return arrange(model, options, context); });
  FallbackPlan plan = clock.run("layout", context, [&] { return FallbackPlan(std::move(domain), options, context); });
  const auto mesh_by = [&](FallbackPlan& way) {
    return chain_attempts(way, model.file,
                          [&](CellCache& cache) { return attempt_mesh(way, options, cache, clock, context); });
  };
  MeshResult result = mesh_by(plan);
  if (result.failure && plan.is_cut()) {  // what cannot be meshed in halves may be as a whole
    FallbackPlan uncut(plan.model(), options, context, false);
    MeshResult other = mesh_by(uncut);
    if (!other.failure) result = std::move(other);
  }
  describe_domain(plan.model(), result.report);
  clock.run("measure", context, [&] { measure_result(result); });
  result.report.stages = std::move(clock.times());
  return result;
}

}  // namespace quadline
