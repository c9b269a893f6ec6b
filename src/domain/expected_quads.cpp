#include "domain/expected_quads.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

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

/// Of every curve the size that its lines, its bend or the edges of its circle ask for; infinity: none.
IdVector<CurveId, double> sizes_along(const Domain& domain, const Options& options) {
  IdVector<CurveId, double> sizes;
  for (const Domain::Curve& curve : domain.curves) {
    const double bend = kFullTurn * curve.piece.radius / options.edges_per_circle;
    sizes.push_back(curve.piece.is_arc() ? std::min(curve.size, bend) : curve.size);
  }
  for (const Domain::Washer& washer : domain.washers)
    for (const std::vector<DirectedCurve>& circle : washer.circles)
      for (const DirectedCurve& d : circle)
        if (washer.edges > 0) sizes[d.curve] = kFullTurn * domain.curves[d.curve].piece.radius / washer.edges;
  return sizes;
}

/// By the sizes; but no fewer than a row one quad wide has with the edges on its curves.
double expected_quads(const Domain& domain, const Domain::Cell& cell, const IdVector<CurveId, double>& sizes,
                      const Options& options) {
  const double area = area_of(domain, cell), size = cell.size;
  double quads = area / (size * size), edges = 0;
  for (const auto& walk : cell.walks)
    for (const DirectedCurve& step : walk) {
      const Domain::Curve& curve = domain.curves[step.curve];
      const double along = length(curve.piece), h = std::min(size, sizes[step.curve]);
      edges += std::max(1.0, along / h);
      quads += std::min(added_along(along, h, size, options.growth - 1), area / (h * h));
    }
  if (cell.is_ring) return 0.5 * edges;
  return std::max(quads, 0.5 * (edges - 2));
}

}  // namespace

double area_of(const Domain& domain) {
  double area = 0;
  for (const Domain::Cell& cell : domain.cells) area += area_of(domain, cell);
  return area;
}

double expected_quads(const Domain& domain, const Options& options) {
  const IdVector<CurveId, double> sizes = sizes_along(domain, options);
  double quads = 0;
  for (const Domain::Cell& cell : domain.cells) quads += expected_quads(domain, cell, sizes, options);
  const double area = area_of(domain);
  for (const Domain::PointUse& point : domain.points)
    quads += added_round(point.size, domain.size, options.growth - 1, area);
  return options.method == Method::Split ? kQuadsOfSplit * quads : quads;
}

}  // namespace quadline
