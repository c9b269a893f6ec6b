#include "geom/element.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "geom/angles.hpp"

namespace quadline {

double triangle_distortion(Point a, Point b, Point c) {
  const double edges = norm2(a - c) + norm2(b - a) + norm2(b - c);
  return edges > 0 ? 2 * std::numbers::sqrt3 * twice_area(a, b, c) / edges : 0;
}

double quad_distortion(const QuadPoints& q) {
  std::array<double, 4> alpha{triangle_distortion(q[0], q[1], q[2]), triangle_distortion(q[0], q[2], q[3]),
                              triangle_distortion(q[0], q[1], q[3]), triangle_distortion(q[1], q[2], q[3])};
  std::sort(alpha.begin(), alpha.end());
  return alpha[0] > 0 ? alpha[0] * alpha[1] / (alpha[2] * alpha[3]) : 0;
}

double scaled_jacobian(const QuadPoints& q) {
  double least = 1;
  for (int i = 0; i < 4; ++i) {
    const Point u = q[(i + 1) % 4] - q[i], v = q[(i + 3) % 4] - q[i];
    const double lengths = std::sqrt(norm2(u) * norm2(v));
    least = std::fmin(least, lengths > 0 ? cross(u, v) / lengths : 0);
  }
  return least;
}

double corner_angle(Point previous, Point corner, Point next) { return radians(angle_at(previous, corner, next)); }

double inverse_mean_ratio(const QuadPoints& q) {
  double sum = 0;
  for (int i = 0; i < 4; ++i) {
    const Point u = q[(i + 1) % 4] - q[i], v = q[(i + 3) % 4] - q[i];
    const double det = cross(u, v);
    if (det <= 0) return std::numeric_limits<double>::infinity();
    sum += (norm2(u) + norm2(v)) / (2 * det);
  }
  return 0.25 * sum;
}

}  // namespace quadline
