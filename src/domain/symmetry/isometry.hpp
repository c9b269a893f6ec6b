#pragma once

#include "quadline/point.hpp"

namespace quadline {

/// A motion of the plane that keeps lengths: a mirror image first where asked (x to -x), then a turn, about `from`;
/// `from` comes to lie at `to`.
struct Isometry {
  Point from{}, to{};
  double cos = 1, sin = 0;  ///< of the turn
  bool is_mirrored = false;

  Point operator()(Point p) const { return to + turned(p - from); }
  /// A vector.
  Point turned(Point v) const {
    if (is_mirrored) v.x = -v.x;
    return {cos * v.x - sin * v.y, sin * v.x + cos * v.y};
  }
  /// A vector back.
  Point turned_back(Point v) const {
    const Point back{cos * v.x + sin * v.y, cos * v.y - sin * v.x};
    return {is_mirrored ? -back.x : back.x, back.y};
  }
};

}  // namespace quadline
