#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "geom/element.hpp"
#include "quadline/mesh.hpp"

namespace quadline {

inline QuadPoints corners(const Mesh& mesh, const std::array<NodeIndex, 4>& quad) {
  return {mesh.points[quad[0]], mesh.points[quad[1]], mesh.points[quad[2]], mesh.points[quad[3]]};
}

/// The scaled Jacobian of a triangle: its least sine, over that of an equilateral one; signed, 0 for a collapsed one.
inline double scaled_jacobian(const std::array<Point, 3>& t) {
  const double u = distance(t[0], t[1]), v = distance(t[1], t[2]), w = distance(t[2], t[0]);
  const double longest_two = std::max({u * v, v * w, w * u});
  return longest_two > 0 ? 2 / std::sqrt(3.0) * twice_area(t[0], t[1], t[2]) / longest_two : 0.0;
}

inline std::array<Point, 3> corners(const Mesh& mesh, const std::array<NodeIndex, 3>& triangle) {
  return {mesh.points[triangle[0]], mesh.points[triangle[1]], mesh.points[triangle[2]]};
}

}  // namespace quadline
