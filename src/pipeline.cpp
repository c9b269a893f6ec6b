#include "pipeline.hpp"

#include <array>
#include <string>
#include <string_view>
#include <utility>

#include "better_cells.hpp"
#include "domain/size_field.hpp"
#include "edge_sizes.hpp"
#include "flatten.hpp"
#include "slivers.hpp"
#include "stages/cleanup/cleanup.hpp"
#include "stages/discretize/discretize.hpp"
#include "stages/field_points/field_points.hpp"
#include "stages/halve/halve.hpp"
#include "stages/pair/pair.hpp"
#include "stages/qmorph/qmorph.hpp"
#include "stages/smooth/smooth.hpp"
#include "stages/triangulate/triangulate.hpp"
#include "stages/verify/verify.hpp"

namespace quadline {

namespace {

// Sizes from a spoiled place to what is frozen the next time; the first time there is none, the last time it is all.
constexpr std::array<double, 4> kReaches{0, 4, 16, 1e9};

// Triangles that are tried after the first, at a part of the sizes.
struct OtherTriangles {
  Triangles triangles;
  double spacing;
};
constexpr std::array<OtherTriangles, 2> kOthers{{{Triangles::Delaunay, 1}, {Triangles::Front, 0.93}}};

// One way through the stages, from the size field to the verifier.
class Pipeline {
 public:
  Pipeline(const FallbackPlan& plan, const Options& options, Report& report, Context& context)
      : domain_(plan.domain()),
        plan_(plan),
        options_(options),
        report_(report),
        context_(context),
        clock_(report, context) {}

  Attempt run() {
    const SizeField size = clock_.run("sizing", [&] { return make_size_field(domain_, options_, context_); });
    const SizeField of_triangles = halves() ? size.doubled() : size;
    WorkMesh mesh = triangles(of_triangles);
    const WorkMesh start = tries_both() ? mesh : WorkMesh();
    merge(mesh, of_triangles);
    snapshot("before-smoothing", mesh);
    report_.before_smoothing = measure(flatten(mesh, domain_));
    if (plan_.halves()) {
      improve_with_care(mesh, size);
    } else {
      clock_.run("clean-up", [&] { clean_up(mesh, size, context_); });
      if (tries_both()) clock_.run("other triangles", [&] { try_other_triangles(start, mesh, size); });
      finish(mesh, size);
    }
    return judged(mesh, size);
  }

 private:
  bool tries_both() const { return options_.triangles == Triangles::Both && !halves(); }
  bool halves() const { return options_.method != Method::QMorph || plan_.halves(); }

  void snapshot(std::string_view name, const WorkMesh& mesh) {
    if (context_.on_snapshot) context_.on_snapshot(name, flatten(mesh, domain_));
  }

  // Between the nodes on the curves.
  WorkMesh triangles(const SizeField& size) {
    const EdgeUse use = halves() ? EdgeUse::Halved : EdgeUse::Whole;
    WorkMesh mesh = clock_.run("discretize", [&] { return discretize(domain_, size, use, context_); });
    clock_.run("triangulate", [&] { triangulate(mesh, domain_, context_); });
    snapshot("triangulation", mesh);
    return mesh;
  }

  // From there to quads of all kinds.
  void merge(WorkMesh& mesh, const SizeField& size) {
    clock_.run("field points",
               [&] { insert_field_points(mesh, size, options_.triangles, plan_.other_triangles(), context_); });
    snapshot("field-points", mesh);
    if (options_.method == Method::QMorph) {
      const auto observe = [this](std::string_view name, const WorkMesh& now) { snapshot(name, now); };
      const FrontOptions front{.lines = options_.lines, .left_out = plan_.halved()};
      clock_.run("qmorph", [&] { merge_to_quads(mesh, size, front, observe, context_); });
    }
    if (halves()) {
      if (options_.method != Method::Split) clock_.run("pair", [&] { pair_triangles(mesh, context_); });
      snapshot("before-halving", mesh);
      clock_.run("halve", [&] { halve(mesh, domain_, context_); });
    }
  }

  // No triangles win everywhere. Where the first leave something to wish for, others may do better.
  void try_other_triangles(const WorkMesh& start, WorkMesh& mesh, const SizeField& size) {
    for (std::size_t i = 0; i < kOthers.size(); ++i) {
      const CellSet cells = improvable_cells(mesh, plan_.changed());
      if (cells.empty()) return;
      WorkMesh other = start;
      keep_cells(other, cells);
      Context context = part_of_other_triangles(i);
      try {
        insert_field_points(other, size.scaled(kOthers[i].spacing), kOthers[i].triangles, {}, context);
        merge_to_quads(other, size, {.lines = options_.lines}, {}, context);
        clean_up(other, size, context);
        if (const CellSet better = better_cells(mesh, other); !better.empty()) mesh = joined(mesh, other, better);
      } catch (const InternalError&) {
        continue;  // what is there stays
      }
    }
  }

  // Tells the progress of all its stages as that of one.
  Context part_of_other_triangles(std::size_t i) const {
    Context context;
    context.is_cancelled = context_.is_cancelled;
    context.on_progress = [this, i](std::string_view stage, double done) {
      const double before = stage == "clean-up" ? 0.5 : stage == "qmorph" ? 0.2 : 0, after = before == 0.5 ? 0.5 : 0.25;
      if (context_.on_progress)
        context_.on_progress("other triangles", (static_cast<double>(i) + before + after * done) / kOthers.size());
    };
    return context;
  }

  void finish(WorkMesh& mesh, const SizeField& size) {
    snapshot("clean-up", mesh);
    clock_.run("smooth", [&] { smooth(mesh, domain_, size, {.criteria = options_.criteria}, context_); });
  }

  // Halving leaves sound quads where the triangles were, however thin. Where clean-up and smoothing spoil them, more
  // and more of what is round the place stays as it was.
  void improve_with_care(WorkMesh& mesh, const SizeField& size) {
    const WorkMesh raw = mesh;
    std::vector<Point> spoiled;
    const std::size_t n_given = unsound_faces(raw).size();  // which freezing does not mend
    for (const double reach : kReaches) {
      mesh = raw;
      freeze_slivers(mesh);
      freeze_near(mesh, spoiled, reach, size);
      clock_.run("clean-up", [&] { clean_up(mesh, size, context_); });
      finish(mesh, size);
      mesh.thaw();
      const std::vector<FaceId> faces = unsound_faces(mesh);
      if (faces.size() <= n_given) return;
      for (const FaceId f : faces) spoiled.push_back(centre_of(mesh, f));
    }
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
  Report& report_;
  Context& context_;
  StageClock clock_;
};

}  // namespace

Attempt attempt_mesh(const FallbackPlan& plan, const Options& options, Report& report, Context& context) {
  try {
    return Pipeline(plan, options, report, context).run();
  } catch (const InternalError& error) {
    Attempt attempt;
    attempt.result.failure = Failure{"internal", error.what(), error.where().point.value_or(Point{})};
    attempt.troubles = troubles_at(plan.domain(), error.where().point, error.what());
    return attempt;
  }
}

}  // namespace quadline
