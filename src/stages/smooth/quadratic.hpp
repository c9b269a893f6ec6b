#pragma once

#include <cmath>

#include "quadline/point.hpp"

namespace quadline::smoothing {

/// An energy near the place of one node: value, gradient and Hessian.
struct Quadratic {
  double value = 0;
  Point gradient;
  double xx = 0, xy = 0, yy = 0;

  /// Adds weight * g g' to the Hessian.
  void add_square(double weight, Point g) {
    xx += weight * g.x * g.x;
    xy += weight * g.x * g.y;
    yy += weight * g.y * g.y;
  }
  /// Adds -weight * (f g' + g f') to the Hessian.
  void subtract_product(double weight, Point f, Point g) {
    xx -= 2 * weight * f.x * g.x;
    xy -= weight * (f.x * g.y + f.y * g.x);
    yy -= 2 * weight * f.y * g.y;
  }
  void add_identity(double weight) {
    xx += weight;
    yy += weight;
  }

  /// Newton's step; where the Hessian is not positive, downhill by `fallback`.
  Point step(double fallback) const {
    const double det = xx * yy - xy * xy;
    if (xx > 0 && det > kFlat * (xx * xx + yy * yy))
      return {(xy * gradient.y - yy * gradient.x) / det, (xy * gradient.x - xx * gradient.y) / det};
    const double slope = norm(gradient);
    return slope > 0 ? (-fallback / slope) * gradient : Point{};
  }
  /// The same along the unit vector t.
  Point step_along(Point t, double fallback) const {
    const double slope = dot(gradient, t), bend = xx * t.x * t.x + 2 * xy * t.x * t.y + yy * t.y * t.y;
    const double way = bend > 0 ? -slope / bend : (slope > 0 ? -fallback : fallback);
    return way * t;
  }

 private:
  static constexpr double kFlat = 1e-12;
};

}  // namespace quadline::smoothing
