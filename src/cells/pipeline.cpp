#include "cells/pipeline.hpp"

#include <array>
#include <string_view>
#include <utility>
#include <vector>

#include "base/stage_clock.hpp"
#include "cells/cell_mesher.hpp"
#include "cells/flatten.hpp"
#include "cells/thin_quads.hpp"
#include "domain/size/edge_sizes.hpp"
#include "domain/size/size_field.hpp"
#include "stages/smooth/smooth.hpp"
#include "stages/verify/verify.hpp"

namespace quadline {

namespace {

// Sizes from a spoiled place to what is frozen the next time; the first time there is none, the last time it is all.
constexpr std::array<double, 4> kReaches{0, 4, 16, 1e9};

// One way through the stages, from the size field to the verifier.
class Pipeline {
 public:
  Pipeline(const FallbackPlan& plan, const Options& options, CellCache& cache, Report& report, Context& context)
      : domain_(plan.domain()),
        plan_(plan),
        options_(options),
        cache_(cache),
        report_(report),
        context_(context),
        clock_(report, context) {}

  Attempt run() {
    const SizeField size = clock_.run("sizing", [&] { return make_size_field(domain_, options_, context_); });
    CellMesher cells(domain_, size, plan_, options_, cache_, context_, clock_, observer());
    cells.place_nodes();
    Attempt none;
    if (none.too_many = cells.least_quads(); none.too_many > options_.max_quads) return none;
    cells.make_triangles();
    cells.make_quads();
    const std::size_t n_given = note_raw(cells);
    cells.clean_up();
    if (options_.method == Method::QMorph) cells.try_triangles();
    report_.qmorph = cells.morph_counts();
    const WorkMesh mesh = finished(cells, size, n_given);
    if (std::vector<Trouble> troubles = cells.troubles(); !troubles.empty()) return failed(std::move(troubles));
    return judged(mesh, size);
  }

 private:
  CellMesher::Observe observer() const {
    if (!context_.on_snapshot) return {};
    return [this](std::string_view name, const WorkMesh& mesh) { context_.on_snapshot(name, flatten(mesh, domain_)); };
  }

  // Number of quads of the cells that have fallen back that are not sound from the start.
  std::size_t note_raw(const CellMesher& cells) {
    const WorkMesh raw = cells.mesh();
    report_.before_smoothing = measure(flatten(raw, domain_));
    return unsound_of(raw, cells.fallen_back()).size();
  }

  // Smooths the cells together. As a fall-back, halving leaves sound quads where the triangles were, however thin.
  // Where clean-up and smoothing spoil them, more and more of what is round the place stays as it was, until no more
  // than the `n_given` quads are left that were not sound before either.
  WorkMesh finished(CellMesher& cells, const SizeField& size, std::size_t n_given) {
    std::vector<Point> spoiled;
    CellSet to_clean;  // those with spoiled quads
    WorkMesh mesh;
    for (const double reach : kReaches) {
      const auto freeze = [&](WorkMesh& some) {
        freeze_thin_quads(some);
        freeze_near(some, spoiled, reach, size);
      };
      if (!spoiled.empty()) cells.clean_up_again(to_clean, freeze);
      if (!cells.troubles().empty()) break;
      mesh = cells.cleaned_mesh();
      if (context_.on_snapshot) context_.on_snapshot("clean-up", flatten(mesh, domain_));
      clock_.run("smooth", [&] { smooth(mesh, domain_, size, {.criteria = options_.criteria}, context_); });
      mesh.thaw();
      const std::vector<FaceId> faces = unsound_of(mesh, cells.fallen_back());
      if (faces.size() <= n_given) break;
      to_clean = {};
      for (const FaceId f : faces) {
        spoiled.push_back(centre_of(mesh, f));
        to_clean.insert(mesh.cell(f));
      }
    }
    return mesh;
  }

  static std::vector<FaceId> unsound_of(const WorkMesh& mesh, const CellSet& cells) {
    std::vector<FaceId> faces = unsound_faces(mesh);
    std::erase_if(faces, [&](FaceId f) { return !cells.contains(mesh.cell(f)); });
    return faces;
  }

  static Attempt failed(std::vector<Trouble> troubles) {
    Attempt attempt;
    attempt.result.failure = Failure{"internal", troubles[0].reason, troubles[0].at};
    attempt.troubles = std::move(troubles);
    return attempt;
  }

  Attempt judged(const WorkMesh& mesh, const SizeField& size) {
    Attempt attempt;
    MeshResult& result = attempt.result;
    result.mesh = flatten(mesh, domain_);
    result.failure = clock_.run("verify", [&] { return verify(result.mesh, domain_, context_); });
    if (context_.on_snapshot) context_.on_snapshot("smoothed", result.mesh);
    if (result.failure) {
      attempt.troubles = unsound_cells(mesh);
      if (attempt.troubles.empty()) attempt.troubles = troubles_at(domain_, result.failure->at, result.failure->reason);
      return attempt;
    }
    result.edge_sizes = edge_sizes(result.mesh, size);
    report_.quality = measure(result.mesh, result.edge_sizes);
    report_.lines = measure_lines(result.mesh, result.edge_sizes);
    report_.worst = worst_quads(result.mesh, report_.corners);
    attempt.findings = plan_.findings(mesh);
    return attempt;
  }

  const Domain domain_;  // with the sizes of the plan
  const FallbackPlan& plan_;
  const Options& options_;
  CellCache& cache_;
  Report& report_;
  Context& context_;
  StageClock clock_;
};

}  // namespace

Attempt attempt_mesh(const FallbackPlan& plan, const Options& options, CellCache& cache, Report& report,
                     Context& context) {
  try {
    return Pipeline(plan, options, cache, report, context).run();
  } catch (const InternalError& error) {
    Attempt attempt;
    attempt.result.failure = Failure{"internal", error.what(), error.where().point.value_or(Point{})};
    attempt.troubles = troubles_at(plan.domain(), error.where().point, error.what());
    return attempt;
  }
}

}  // namespace quadline
