#include "domain/expected_quads.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/constants.hpp"
#include "base/elementary.hpp"

namespace quadline {

namespace {

constexpr double kQuadsOfSplit = 1.15;  // measured; see docs/methods.md

double area_of(const Domain& domain, const Domain::Cell& cell) {
  double twice = 0;
  for (const auto& walk : cell.walks)
    for (const DirectedCurve& step : walk)
      twice += (step.reversed ? -1 : 1) * twice_area_under(domain.curves[step.curve].piece, domain.box.lo);
  return 0.5 * twice;
}

/// The quads that one side of a curve adds where its size h grows to that of the cell, H, by `slope` per unit of
/// distance: the integral of 1 / h^2 - 1 / H^2.
double added_along(double curve_length, double h, double H, double slope) {
  return h < H ? curve_length * (H - h) * (H - h) / (slope * h * H * H) : 0;
}

/// The same all round a point: the integral of 1 / h^2 up to the radius where h is H, or that of the whole domain.
double added_round(double h, double H, double slope, double area) {
  if (!(h < H)) return 0;
  const double far = h + std::min(H - h, slope * std::sqrt(area / std::numbers::pi));
  return kFullTurn / (slope * slope) * (logarithm(far / h) + h / far - 1);
}

double size_along(const Domain::Curve& curve, const Options& options) {
  if (curve.edges > 0) return length(curve.piece) / curve.edges;
  if (!curve.piece.is_arc()) return curve.size;
  return std::min(curve.size, kFullTurn * curve.piece.radius / options.edges_per_circle);
}

/// By the sizes; but no fewer than a row one quad wide has with the edges on its curves.
double expected_quads(const Domain& domain, const Domain::Cell& cell, const Options& options) {
  const double area = area_of(domain, cell), size = cell.size;
  double quads = area / (size * size), edges = 0;
  for (const auto& walk : cell.walks)
    for (const DirectedCurve& step : walk) {
      const Domain::Curve& curve = domain.curves[step.curve];
      const double along = length(curve.piece), h = std::min(size, size_along(curve, options));
      edges += std::max(1.0, along / h);
      quads += std::min(added_along(along, h, size, options.growth - 1), area / (h * h));
    }
  if (cell.rings > 0) return cell.rings * 0.5 * edges;
  return std::max(quads, 0.5 * (edges - 2));
}

}  // namespace

double area_of(const Domain& domain) {
  double area = 0;
  for (const Domain::Cell& cell : domain.cells) area += area_of(domain, cell);
  return area;
}

double expected_quads(const Domain& domain, const Options& options) {
  double quads = 0;
  for (const Domain::Cell& cell : domain.cells) quads += expected_quads(domain, cell, options);
  const double area = area_of(domain);
  for (const Domain::PointUse& point : domain.points)
    quads += added_round(point.size, domain.size, options.growth - 1, area);
  return options.method == Method::Split ? kQuadsOfSplit * quads : quads;
}

}  // namespace quadline
