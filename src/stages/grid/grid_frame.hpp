#pragma once

#include "quadline/point.hpp"

namespace quadline {

/// Coordinates in which the rows of a grid are straight and parallel to an axis: turned ones, or polar ones. Both keep
/// the orientation of the plane.
struct GridFrame {
  Point origin{};         ///< polar: the centre
  Point axis{1, 0};       ///< unit vector: direction of the first coordinate; polar: where the angle is 0
  bool is_polar = false;  ///< coordinates are the logarithm of the radius, and the angle in radians, [0, 2 pi)

  Point to_frame(Point p) const;
  Point to_plane(Point q) const;
};

}  // namespace quadline
