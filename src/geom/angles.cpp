#include "geom/angles.hpp"

#include "base/elementary.hpp"

namespace quadline {

double radians(Angle angle) {
  const double turn = arc_tangent(angle.sine, angle.cosine);
  return turn > 0 ? turn : turn + 2 * std::numbers::pi;
}

Point turned(Point v, double angle_rad) {
  const double c = cosine(angle_rad), s = sine(angle_rad);
  return {c * v.x - s * v.y, s * v.x + c * v.y};
}

}  // namespace quadline
