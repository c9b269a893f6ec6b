// The pipeline, in the order of [Lee2003].
#include "quadline/generate.hpp"

#include <array>
#include <chrono>
#include <string>
#include <utility>

#include "domain/arrange.hpp"
#include "domain/corners.hpp"
#include "domain/size_field.hpp"
#include "flatten.hpp"
#include "stages/cleanup/cleanup.hpp"
#include "stages/discretize/discretize.hpp"
#include "stages/field_points/field_points.hpp"
#include "stages/qmorph/qmorph.hpp"
#include "stages/smooth/smooth.hpp"
#include "stages/triangulate/triangulate.hpp"
#include "stages/verify/verify.hpp"

namespace quadline {

namespace {

// Runs the stages by name and notes how long each took.
class Clock {
 public:
  Clock(Report& report, Context& context) : report_(report), context_(context) {}

  template <class Stage>
  auto run(const char* name, Stage stage) {
    context_.progress(name, 0);
    const auto start = std::chrono::steady_clock::now();
    struct Note {  // on the way out, whatever the stage returns
      Report& report;
      const char* name;
      std::chrono::steady_clock::time_point start;
      ~Note() {
        const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
        report.stages.push_back({name, elapsed.count()});
      }
    } note{report_, name, start};
    return stage();
  }

 private:
  Report& report_;
  Context& context_;
};

// Target sizes at the middles of the edges, for the measure of edge length over size.
std::vector<double> sizes_at_edges(const Mesh& mesh, const SizeField& size) {
  std::vector<double> sizes;
  for (const auto& [a, b] : edges_of(mesh)) sizes.push_back(size.at(midpoint(mesh.points[a], mesh.points[b])));
  return sizes;
}

/// How a model is meshed: as asked; where that breaks the promise, with the other triangles, then finer.
struct Attempt {
  bool other_triangles;
  double refinement;  // of all sizes
  const char* what;
};
constexpr std::array<Attempt, 5> kAttempts{{{false, 1, "as asked"},
                                            {true, 1, "with the other triangles"},
                                            {false, 0.75, "with sizes 0.75 of those asked"},
                                            {true, 0.5, "with the other triangles and half the sizes"},
                                            {false, 0.35, "with sizes 0.35 of those asked"}}};

Domain refined(Domain domain, double factor) {
  domain.size *= factor;
  for (Domain::Cell& cell : domain.cells) cell.size *= factor;
  for (Domain::Curve& curve : domain.curves) curve.size *= factor;
  for (Domain::PointUse& point : domain.points) point.size *= factor;
  return domain;
}

// The stages that make the mesh of a domain.
MeshResult mesh_domain(const Domain& domain, const Options& options, Report& report, Context& context) {
  MeshResult result;
  Clock clock(report, context);
  const auto snapshot = [&](std::string_view name, const WorkMesh& mesh) {
    if (context.on_snapshot) context.on_snapshot(name, flatten(mesh, domain));
  };
  const SizeField size = clock.run("sizing", [&] { return make_size_field(domain, options, context); });
  WorkMesh mesh = clock.run("discretize", [&] { return discretize(domain, size, context); });
  clock.run("triangulate", [&] { triangulate(mesh, domain, context); });
  snapshot("triangulation", mesh);
  clock.run("field points", [&] { insert_field_points(mesh, size, options.triangles, context); });
  snapshot("field-points", mesh);
  clock.run("qmorph", [&] { merge_to_quads(mesh, size, options.lines, snapshot, context); });
  snapshot("before-smoothing", mesh);
  report.before_smoothing = measure(flatten(mesh, domain));
  clock.run("clean-up", [&] { clean_up(mesh, size, context); });
  snapshot("clean-up", mesh);
  clock.run("smooth", [&] { smooth(mesh, domain, size, {}, context); });

  result.mesh = flatten(mesh, domain);
  result.failure = clock.run("verify", [&] { return verify(result.mesh, domain, context); });
  result.edge_sizes = sizes_at_edges(result.mesh, size);
  report.quality = measure(result.mesh, result.edge_sizes);
  report.lines = measure_lines(result.mesh, result.edge_sizes);
  report.worst = worst_quads(result.mesh, report.corners);
  if (context.on_snapshot) context.on_snapshot("smoothed", result.mesh);
  return result;
}

}  // namespace

MeshResult generate(const Model& model, const Options& options, Context& context) {
  Report report;
  const Domain domain = Clock(report, context).run("arrange", [&] { return arrange(model, options, context); });
  report.tolerance = domain.tolerance;
  report.n_cells = domain.cells.count();
  report.n_curves = domain.curves.count();
  report.n_vertices = domain.vertices.count();
  report.findings = domain.findings;
  report.corners = corners_of(domain);

  MeshResult first;
  for (const Attempt& attempt : kAttempts) {
    Options now = options;
    if (attempt.other_triangles)
      now.triangles = options.triangles == Triangles::Delaunay ? Triangles::Front : Triangles::Delaunay;
    MeshResult result;
    try {
      result =
          mesh_domain(attempt.refinement == 1 ? domain : refined(domain, attempt.refinement), now, report, context);
    } catch (const InternalError& error) {
      result.failure = Failure{"internal", error.what(), error.where().point.value_or(domain.box.lo)};
    }
    if (!result.failure) {
      result.report = std::move(report);
      return result;
    }
    report.findings.push_back(
        {std::string("no valid mesh ") + attempt.what + ": " + result.failure->reason, {}, result.failure->at});
    if (!first.failure || first.mesh.quads.empty()) first = std::move(result);
  }
  report.quality = measure(first.mesh);
  report.lines = measure_lines(first.mesh);
  report.worst = worst_quads(first.mesh, report.corners);
  first.report = std::move(report);
  return first;
}

}  // namespace quadline
