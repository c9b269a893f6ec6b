#pragma once

#include "quadline/point.hpp"

namespace quadline {

// Exact as long as nothing overflows or underflows: for coordinates that are 0 or between 1e-60 and 1e60 in size.

/// Sign of the area of the triangle a b c: > 0 counter-clockwise, 0 collinear. Exact [Shewchuk1997].
int orientation(Point a, Point b, Point c);

/// > 0 where d lies inside the circle through the counter-clockwise triangle a b c, 0 on it; the opposite sign where
/// the triangle is clockwise. Exact [Shewchuk1997].
int in_circle(Point a, Point b, Point c, Point d);

}  // namespace quadline
