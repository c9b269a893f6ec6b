#include "quality/criteria_values.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/elementary.hpp"

namespace quadline {

namespace {

constexpr double kDegrees = 180 / std::numbers::pi;
constexpr double kLeastScale = 0.1;  // for limits of about zero

double skew_deg(const QuadPoints& p) {
  const Point u = p[1] + p[2] - p[3] - p[0], v = p[2] + p[3] - p[0] - p[1];
  return 90 - arc_tangent(std::abs(cross(u, v)), std::abs(dot(u, v))) * kDegrees;
}

}  // namespace

std::array<double, 13> criteria_values(const QuadPoints& p, const std::array<double, 4>& size, double growth) {
  double low = 360, high = 0, shortest = distance(p[0], p[1]), longest = 0;
  double least_to_size = shortest / size[0], most_to_size = 0;
  std::array<double, 4> area{};  // twice that of the triangle at each corner: the Jacobian there
  for (std::size_t i = 0; i < 4; ++i) {
    const Point before = p[(i + 3) % 4], after = p[(i + 1) % 4];
    const double angle = corner_angle(before, p[i], after) * kDegrees, length = distance(p[i], after);
    low = std::min(low, angle);
    high = std::max(high, angle);
    shortest = std::min(shortest, length);
    longest = std::max(longest, length);
    least_to_size = std::min(least_to_size, length / size[i]);
    most_to_size = std::max(most_to_size, length / size[i]);
    area[i] = twice_area(before, p[i], after);
  }
  const auto [least, most] = std::minmax_element(area.begin(), area.end());
  const double quad_area = area[0] + area[2];  // twice
  return {low,
          high,
          shortest > 0 ? longest / shortest : 1e12,
          scaled_jacobian(p),
          *most > 0 ? *least / *most : -1,
          skew_deg(p),
          quad_area > 0 ? 1 - 2 * *least / quad_area : 1,
          quad_distortion(p),
          growth,
          shortest,
          longest,
          least_to_size,
          most_to_size};
}

double criteria_excess(const Criteria& criteria, const QuadPoints& p, double size) {
  const auto values = criteria_values(p, {size, size, size, size}, 1);
  const auto& fields = criteria_fields();
  double sum = 0;
  for (std::size_t i = 0; i < fields.size(); ++i) {
    const auto& limit = criteria.*fields[i].limit;
    if (!limit || fields[i].limit == &Criteria::max_growth) continue;
    const double beyond = fields[i].is_least ? *limit - values[i] : values[i] - *limit;
    sum += std::max(beyond, 0.0) / std::max(std::abs(*limit), kLeastScale);
  }
  return sum;
}

}  // namespace quadline
