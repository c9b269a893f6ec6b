#include "cli/estimate.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include "cli/console.hpp"
#include "domain/arrange.hpp"
#include "quadline/errors.hpp"

namespace quadline {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kFullTurn = 2 * std::numbers::pi;

/// Twice the area between the curve and `origin`; positive where it runs counter-clockwise round it.
double twice_area_under(const CurvePiece& piece, Point origin) {
  const double chord = cross(piece.a - origin, piece.b - origin);
  return chord + piece.radius * piece.radius * (piece.sweep - std::sin(piece.sweep));
}

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

/// More than any mesh of the model can take: all of its box at its least size.
class UpperBound {
 public:
  UpperBound(const Model& model, const Options& options)
      : least_(options.size.value_or(model.size)), per_circle_(options.edges_per_circle) {
    for (const Path& path : model.outer) add(path);
    for (const Path& path : model.holes) add(path);
    for (const Line& line : model.lines) {
      add(line.path);
      shrink(line.size);
    }
    for (const NamedPoint& point : model.points) shrink(point.size);
    for (const Region& region : model.regions) shrink(region.size);
  }

  double quads() const {
    const Point extent = box_.hi - box_.lo;
    return extent.x * extent.y / (least_ * least_);
  }

 private:
  void shrink(std::optional<double> size) { least_ = std::min(least_, size.value_or(kInfinity)); }

  void add(const Box& box) {
    box_.lo = {std::min(box_.lo.x, box.lo.x), std::min(box_.lo.y, box.lo.y)};
    box_.hi = {std::max(box_.hi.x, box.hi.x), std::max(box_.hi.y, box.hi.y)};
  }

  void add(const Path& path) {
    if (path.circle) {
      const Point reach{path.circle->radius, path.circle->radius};
      add({path.circle->center - reach, path.circle->center + reach});
      shrink(kFullTurn * path.circle->radius / per_circle_);
    }
    for (std::size_t i = 0; i < path.items.size(); ++i) {
      const PathItem& item = path.items[i];
      add({item.to, item.to});
      if (!item.via) continue;
      const CurvePiece arc = arc_through(path.items[i - 1].to, *item.via, item.to);
      add(box(arc));
      if (arc.is_arc()) shrink(kFullTurn * arc.radius / per_circle_);
    }
  }

  Box box_{{kInfinity, kInfinity}, {-kInfinity, -kInfinity}};
  double least_, per_circle_;
};

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
  return quads;
}

void check_size_given(const Model& model, const Options& options) {
  if (options.size || model.size > 0) return;
  throw InputError("the model gives no target size: give --size H", Where{model.file, {}, {}});
}

void refuse_too_large(const Model& model, const Options& options, double most, Context& context) {
  if (UpperBound(model, options).quads() <= most) return;
  const double expected = expected_quads(arrange(model, options, context), options);
  if (expected <= most) return;
  throw InputError("about " + rounded(expected, 2) + " quads are expected, more than " + rounded(most, 6) +
                       ": choose a larger size, or raise --max-quads",
                   Where{model.file, {}, {}});
}

}  // namespace quadline
