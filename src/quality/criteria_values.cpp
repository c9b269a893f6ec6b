#include "quality/criteria_values.hpp"

#include <algorithm>
#include <cmath>

#include "base/constants.hpp"
#include "base/elementary.hpp"

namespace quadline {

namespace {

constexpr double kLeastScale = 0.1;  // for limits of about zero

double skew_deg(const QuadPoints& p) {
  const Point u = p[1] + p[2] - p[3] - p[0], v = p[2] + p[3] - p[0] - p[1];
  return 90 - arc_tangent(std::abs(cross(u, v)), std::abs(dot(u, v))) * kDegreesPerRadian;
}

void set_angles(const QuadPoints& p, Criteria& values) {
  double low = 360, high = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    const double angle = corner_angle(p[(i + 3) % 4], p[i], p[(i + 1) % 4]) * kDegreesPerRadian;
    low = std::min(low, angle);
    high = std::max(high, angle);
  }
  values.min_angle_deg = low;
  values.max_angle_deg = high;
}

void set_lengths(const QuadPoints& p, const std::array<double, 4>& size, Criteria& values) {
  double shortest = kInfinity, longest = 0, least_to_size = kInfinity, most_to_size = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    const double length = distance(p[i], p[(i + 1) % 4]);
    shortest = std::min(shortest, length);
    longest = std::max(longest, length);
    least_to_size = std::min(least_to_size, length / size[i]);
    most_to_size = std::max(most_to_size, length / size[i]);
  }
  values.max_aspect = shortest > 0 ? longest / shortest : 1e12;
  values.min_edge = shortest;
  values.max_edge = longest;
  values.min_edge_to_size = least_to_size;
  values.max_edge_to_size = most_to_size;
}

void set_areas(const QuadPoints& p, Criteria& values) {
  std::array<double, 4> area{};  // twice that of the triangle at each corner: the Jacobian there
  for (std::size_t i = 0; i < 4; ++i) area[i] = twice_area(p[(i + 3) % 4], p[i], p[(i + 1) % 4]);
  const auto [least, most] = std::minmax_element(area.begin(), area.end());
  const double quad_area = area[0] + area[2];  // twice
  values.min_jacobian_ratio = *most > 0 ? *least / *most : -1;
  values.max_taper = quad_area > 0 ? 1 - 2 * *least / quad_area : 1;
}

}  // namespace

// Only what is asked for: smoothing asks for every place that it tries, and angles are dear.
Criteria criteria_values(const Criteria& limits, const QuadPoints& p, const std::array<double, 4>& size,
                         double growth) {
  Criteria values;
  if (limits.min_angle_deg || limits.max_angle_deg) set_angles(p, values);
  if (limits.max_aspect || limits.min_edge || limits.max_edge || limits.min_edge_to_size || limits.max_edge_to_size)
    set_lengths(p, size, values);
  if (limits.min_jacobian_ratio || limits.max_taper) set_areas(p, values);
  if (limits.min_scaled_jacobian) values.min_scaled_jacobian = scaled_jacobian(p);
  if (limits.max_skew_deg) values.max_skew_deg = skew_deg(p);
  if (limits.min_beta) values.min_beta = quad_distortion(p);
  if (limits.max_growth) values.max_growth = growth;
  return values;
}

double criteria_excess(const Criteria& criteria, const QuadPoints& p, double size) {
  const Criteria values = criteria_values(criteria, p, {size, size, size, size}, 1);
  double sum = 0;
  for (const CriteriaField& field : criteria_fields()) {
    const auto& limit = criteria.*field.limit;
    if (!limit || field.limit == &Criteria::max_growth) continue;
    const double value = *(values.*field.limit), beyond = field.is_least ? *limit - value : value - *limit;
    sum += std::max(beyond, 0.0) / std::max(std::abs(*limit), kLeastScale);
  }
  return sum;
}

}  // namespace quadline
