#include "inspect/fill_report.hpp"

#include <algorithm>

#include "domain/corners.hpp"

namespace quadline {

DomainCounts counts_of(const Domain& domain) {
  const auto is_of_ring = [](const Domain::Cell& cell) { return cell.rings > 0; };
  const auto is_auxiliary = [](const Domain::Curve& curve) { return curve.is_auxiliary; };
  const auto n_rings = static_cast<std::size_t>(std::count_if(domain.cells.begin(), domain.cells.end(), is_of_ring));
  const auto n_auxiliary =
      static_cast<std::size_t>(std::count_if(domain.curves.begin(), domain.curves.end(), is_auxiliary));
  // Circles have as many vertices as curves.
  return {domain.cells.count() - n_rings, domain.curves.count() - n_auxiliary, domain.vertices.count() - n_auxiliary};
}

void describe_domain(const Domain& domain, Report& report) {
  report.tolerance = domain.tolerance;
  const DomainCounts counts = counts_of(domain);
  report.n_cells = counts.n_cells;
  report.n_curves = counts.n_curves;
  report.n_vertices = counts.n_vertices;
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
