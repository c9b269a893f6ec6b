#include "stages/grid/grid_frame.hpp"

#include <cmath>

#include "base/constants.hpp"
#include "base/elementary.hpp"
#include "geom/angles.hpp"

namespace quadline {

Point GridFrame::to_frame(Point p) const {
  const Point v = p - origin;
  const double along = dot(axis, v), across = cross(axis, v);
  if (!is_polar) return {along, across};
  const double angle = arc_tangent(across, along);
  return {logarithm(norm(v)), angle < 0 ? angle + kFullTurn : angle};
}

Point GridFrame::to_plane(Point q) const {
  if (!is_polar) return origin + q.x * axis + q.y * left_normal(axis);
  return origin + exponential(q.x) * turned(axis, q.y);
}

}  // namespace quadline
