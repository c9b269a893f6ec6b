#pragma once

#include "quadline/point.hpp"

namespace quadline {

/// Sign of the area of the triangle a b c: > 0 counter-clockwise, 0 collinear. Exact [Shewchuk1997].
int orientation(Point a, Point b, Point c);

/// > 0 where d lies inside the circle through the counter-clockwise triangle a b c, 0 on it. Exact [Shewchuk1997].
int in_circle(Point a, Point b, Point c, Point d);

}  // namespace quadline
