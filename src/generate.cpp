// The chain of attempts: all as asked; then, in the cells where that breaks the promise and only there, otherwise.
#include "quadline/generate.hpp"

#include <cmath>
#include <string>
#include <utility>

#include "base/stage_clock.hpp"
#include "cells/fallback.hpp"
#include "cells/pipeline.hpp"
#include "domain/arrange/arrange.hpp"
#include "domain/corners.hpp"
#include "domain/expected_quads.hpp"

namespace quadline {

MeshResult generate(const Model& model, const Options& options, Context& context) {
  check(options);
  Report report;
  const Domain domain = StageClock(report, context).run("arrange", [&] { return arrange(model, options, context); });
  report.tolerance = domain.tolerance;
  report.n_cells = domain.cells.count();
  report.n_curves = domain.curves.count();
  report.n_vertices = domain.vertices.count();
  report.findings = domain.findings;
  report.corners = corners_of(domain);

  FallbackPlan plan(domain);
  CellCache cache(domain.cells.count());
  Attempt last = attempt_mesh(plan, options, cache, report, context);
  if (last.too_many > 0) {
    throw InputError("at least " + std::to_string(std::llround(last.too_many)) +
                         " quads are needed, more than allowed: choose a larger size, or raise --max-quads",
                     Where{model.file, {}, {}});
  }
  MeshResult first;
  if (last.result.failure) first = last.result;
  bool is_limited = false;
  while (last.result.failure && plan.advance(last.troubles)) {
    const bool is_expected = expected_quads(plan.domain(), options) > options.max_quads;
    Attempt next = is_expected ? Attempt{} : attempt_mesh(plan, options, cache, report, context);
    if (is_expected || next.too_many > 0 || static_cast<double>(next.result.mesh.quads.size()) > options.max_quads) {
      is_limited = true;
      continue;
    }
    last = std::move(next);
  }
  std::vector<Finding>& found = last.findings;
  if (last.result.failure) {
    found = plan.failures(last.troubles);
    if (is_limited) found.push_back({"what may help needs more quads than allowed", {}, first.failure->at});
    last.result = std::move(first);
    report.quality = measure(last.result.mesh);
    report.lines = measure_lines(last.result.mesh);
    report.worst = worst_quads(last.result.mesh, report.corners);
  }
  report.findings.insert(report.findings.end(), found.begin(), found.end());
  last.result.report = std::move(report);
  return std::move(last.result);
}

}  // namespace quadline
