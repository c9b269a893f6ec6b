#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "geom/curve.hpp"
#include "quadline/inspect.hpp"

namespace quadline {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kFullTurn = 2 * std::numbers::pi;

/// All of the model's box and of its curves at its least size, and all cells that its curves can make.
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
    return extent.x * extent.y / (least_ * least_) + 2 * length_ / least_ + n_curves_ * n_curves_;
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
      add_curve(kFullTurn * path.circle->radius);
      shrink(kFullTurn * path.circle->radius / per_circle_);
    }
    for (std::size_t i = 0; i < path.items.size(); ++i) {
      const PathItem& item = path.items[i];
      add({item.to, item.to});
      if (i > 0 && !item.via) add_curve(distance(path.items[i - 1].to, item.to));
      if (!item.via) continue;
      const CurvePiece arc = arc_through(path.items[i - 1].to, *item.via, item.to);
      add_curve(length(arc));
      add(box(arc));
      if (arc.is_arc()) shrink(kFullTurn * arc.radius / per_circle_);
    }
  }

  void add_curve(double length) {
    length_ += length;
    ++n_curves_;
  }

  Box box_{{kInfinity, kInfinity}, {-kInfinity, -kInfinity}};
  double least_, per_circle_, length_ = 0, n_curves_ = 0;
};

}  // namespace

double estimate_at_most(const Model& model, const Options& options) {
  check(options);
  if (options.size_at) return kInfinity;
  const double quads = UpperBound(model, options).quads();
  return std::isnan(quads) ? kInfinity : quads;
}

}  // namespace quadline
