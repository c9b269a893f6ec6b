#include "inspect/fill_report.hpp"

#include <algorithm>

#include "domain/corners.hpp"

namespace quadline {

std::size_t cell_count(const Domain& domain) {
  return static_cast<std::size_t>(
      std::count_if(domain.cells.begin(), domain.cells.end(), [](const Domain::Cell& c) { return !c.is_ring; }));
}

std::size_t curve_count(const Domain& domain) {
  return static_cast<std::size_t>(std::count_if(domain.curves.begin(), domain.curves.end(),
                                                [](const Domain::Curve& c) { return !c.is_auxiliary; }));
}

void describe_domain(const Domain& domain, Report& report) {
  report.tolerance = domain.tolerance;
  report.n_cells = cell_count(domain);
  report.n_curves = curve_count(domain);
  report.n_vertices = domain.vertices.count();
  report.findings.insert(report.findings.begin(), domain.findings.begin(), domain.findings.end());
  report.corners = corners_of(domain);
}

void measure_result(MeshResult& result) {
  Report& report = result.report;
  report.quality = measure(result.mesh, result.edge_sizes);
  report.lines = measure_lines(result.mesh, result.edge_sizes);
  report.worst = worst_quads(result.mesh, report.corners);
}

}  // namespace quadline
