#include "domain/expected_quads.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace quadline {

namespace {

constexpr double kFullTurn = 2 * std::numbers::pi;
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

}  // namespace

double area_of(const Domain& domain) {
  double area = 0;
  for (const Domain::Cell& cell : domain.cells) area += area_of(domain, cell);
  return area;
}

double expected_quads(const Domain& domain, const Options& options) {
  double quads = 0;
  for (const Domain::Cell& cell : domain.cells) quads += area_of(domain, cell) / (cell.size * cell.size);
  for (const Domain::Curve& curve : domain.curves) {
    double size = curve.size;
    if (curve.piece.is_arc()) size = std::min(size, kFullTurn * curve.piece.radius / options.edges_per_circle);
    for (const CellId side : {curve.left, curve.right})
      if (side.valid()) quads += added_along(length(curve.piece), size, domain.cells[side].size, options.growth - 1);
  }
  return options.method == Method::Split ? kQuadsOfSplit * quads : quads;
}

}  // namespace quadline
