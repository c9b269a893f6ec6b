#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

namespace quadline {

/// How many quads too many a sector has (too few: negative), by the report's rule: a sector is regular with round(angle
/// / 90 degrees) quads, at least one; within 2 degrees of a rounding limit either number is right.
/// @param angle  of the sector between two constraints, radians, > 0.
inline int quads_off(double angle, int quads) {
  constexpr double kTie = 2.0 / 90;  // in right angles
  const double right_angles = angle / (std::numbers::pi / 2);
  const int least = static_cast<int>(std::max(1.0, std::round(right_angles - kTie))),
            most = static_cast<int>(std::max(1.0, std::round(right_angles + kTie)));
  return quads > most ? quads - most : quads < least ? quads - least : 0;
}

}  // namespace quadline
