#pragma once

#include <array>
#include <numbers>

#include "quadline/point.hpp"

namespace quadline {

/// An angle in (0, 2 pi] as a vector of any length, its cosine and sine times that: compared by products, so that no
/// decision rests on the rounding of an arc tangent.
struct Angle {
  double cosine = 1, sine = 0;  ///< the full turn

  /// Compares to the rounding of the products.
  friend constexpr bool operator<(Angle a, Angle b) {
    const bool a_is_reflex = a.is_reflex(), b_is_reflex = b.is_reflex();
    return a_is_reflex != b_is_reflex ? b_is_reflex : a.cosine * b.sine - a.sine * b.cosine > 0;
  }
  friend constexpr bool operator>(Angle a, Angle b) { return b < a; }
  friend constexpr bool operator<=(Angle a, Angle b) { return !(b < a); }
  friend constexpr bool operator>=(Angle a, Angle b) { return !(a < b); }

  /// Above a half turn.
  constexpr bool is_reflex() const { return sine < 0 || (sine == 0 && cosine >= 0); }
};

/// The angle of so many degrees, 1 to 360, at compile time; by quarter turns, and the power series for the rest.
consteval Angle degrees(int n) {
  const int quarters = (n + 45) / 90;
  const double x = (n - 90 * quarters) * (std::numbers::pi / 180);
  double c = 1, s = 1;
  for (int k = 20; k >= 2; k -= 2) {
    c = 1 - c * x * x / (k * (k - 1));
    s = 1 - s * x * x / (k * (k + 1));
  }
  s *= x;
  for (int i = 0; i < quarters; ++i) {
    const double old = c;
    c = -s;
    s = old;
  }
  return {c, s};
}

/// Interior angle of a counter-clockwise polygon at `corner`: from the direction of `next` counter-clockwise to that of
/// `previous`.
constexpr Angle angle_at(Point previous, Point corner, Point next) {
  const Point u = next - corner, v = previous - corner;
  return {dot(u, v), cross(u, v)};
}

/// In radians, (0, 2 pi].
double radians(Angle angle);

/// A vector turned counter-clockwise by so many radians.
Point turned(Point v, double angle_rad);

/// The angles at which a corner takes two, three and four quads instead of one less.
using QuadSwitches = std::array<Angle, 3>;

/// Between "nearest to a square" (120, 216, 308.6) and plain rounding (135, 225, 315).
constexpr QuadSwitches kQuadSwitches{degrees(125), degrees(218), degrees(310)};

/// Number of quads, 1 to 4, that fit best into a corner of the angle.
constexpr int quads_for_angle(Angle angle, const QuadSwitches& switches = kQuadSwitches) {
  int quads = 1;
  for (const Angle& at : switches) quads += angle >= at;
  return quads;
}

}  // namespace quadline
