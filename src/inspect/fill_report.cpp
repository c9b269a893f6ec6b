#include "inspect/fill_report.hpp"

#include "domain/corners.hpp"

namespace quadline {

void describe_domain(const Domain& domain, Report& report) {
  report.tolerance = domain.tolerance;
  report.n_cells = domain.cells.count();
  report.n_curves = domain.curves.count();
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
