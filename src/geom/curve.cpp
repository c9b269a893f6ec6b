// Straight segments and circular arcs.
//
// An arc goes through both of its ends even where they lie a rounding error off its circle: the distance from the
// centre goes over evenly from one end's to the other's. So pieces that share a vertex stay joined, and where both ends
// lie on the circle every point does.
#include "geom/curve.hpp"

#include <algorithm>
#include <array>
#include <numbers>

#include "base/elementary.hpp"
#include "geom/angles.hpp"

namespace quadline {

namespace {

constexpr double kPi = std::numbers::pi;

/// Turn from u to v in the direction of `sign`, in [0, 2 pi).
double turn(Point u, Point v, double sign) {
  const double angle = arc_tangent(sign * cross(u, v), dot(u, v));
  return angle < 0 ? angle + 2 * kPi : angle;
}

double sign_of(const CurvePiece& arc) { return arc.sweep < 0 ? -1.0 : 1.0; }

}  // namespace

CurvePiece arc_through(Point a, Point via, Point b) {
  const CurvePiece straight{.a = a, .b = b};
  const Point u = a - via;
  const Point v = b - via;
  const double area = cross(u, v);
  if (area == 0) return straight;
  const Point to_center = (0.5 / area) * Point{v.y * norm2(u) - u.y * norm2(v), u.x * norm2(v) - v.x * norm2(u)};
  const Point center = via + to_center;
  const double radius = norm(to_center);
  if (!std::isfinite(radius) || !std::isfinite(center.x) || !std::isfinite(center.y)) return straight;
  // The angle at `via` sees the chord from the circle: the turn is twice what it lacks to a half turn.
  const double sweep = 2 * arc_tangent(std::abs(area), -dot(u, v));
  return {.a = a, .b = b, .center = center, .radius = radius, .sweep = area < 0 ? sweep : -sweep};
}

CurvePiece reversed(const CurvePiece& piece) {
  CurvePiece back = piece;
  std::swap(back.a, back.b);
  back.sweep = piece.is_arc() ? -piece.sweep : 0;
  return back;
}

double length(const CurvePiece& piece) {
  return piece.is_arc() ? piece.radius * std::abs(piece.sweep) : distance(piece.a, piece.b);
}

Box box(const CurvePiece& piece) {
  Box out{{std::min(piece.a.x, piece.b.x), std::min(piece.a.y, piece.b.y)},
          {std::max(piece.a.x, piece.b.x), std::max(piece.a.y, piece.b.y)}};
  if (!piece.is_arc()) return out;
  const Point start = piece.a - piece.center;
  const double sign = sign_of(piece);
  const auto passes = [&](Point axis) { return turn(start, axis, sign) <= std::abs(piece.sweep); };
  if (passes({1, 0})) out.hi.x = std::max(out.hi.x, piece.center.x + piece.radius);
  if (passes({-1, 0})) out.lo.x = std::min(out.lo.x, piece.center.x - piece.radius);
  if (passes({0, 1})) out.hi.y = std::max(out.hi.y, piece.center.y + piece.radius);
  if (passes({0, -1})) out.lo.y = std::min(out.lo.y, piece.center.y - piece.radius);
  return out;
}

Point point_at(const CurvePiece& piece, double s) {
  const double total = length(piece);
  if (s <= 0) return piece.a;
  if (s >= total) return piece.b;
  const double f = s / total;
  if (!piece.is_arc()) return piece.a + f * (piece.b - piece.a);
  // From the nearer end, so that the angle and its error stay small.
  const bool from_a = f <= 0.5;
  const Point spoke = (from_a ? piece.a : piece.b) - piece.center;
  const double here = norm(spoke);
  const double other = distance(from_a ? piece.b : piece.a, piece.center);
  const double share = from_a ? f : 1 - f;
  const double angle = (from_a ? f : f - 1) * piece.sweep;
  return piece.center + ((here + share * (other - here)) / here) * turned(spoke, angle);
}

Point tangent_at(const CurvePiece& piece, double s) {
  const Point chord = piece.b - piece.a;
  if (!piece.is_arc()) return (1 / norm(chord)) * chord;
  const double f = std::clamp(s / length(piece), 0.0, 1.0);
  const Point spoke = f <= 0.5 ? turned(piece.a - piece.center, f * piece.sweep)
                               : turned(piece.b - piece.center, (f - 1) * piece.sweep);
  return (sign_of(piece) / norm(spoke)) * left_normal(spoke);
}

double project(const CurvePiece& piece, Point p) {
  const double total = length(piece);
  if (!piece.is_arc()) {
    const Point chord = piece.b - piece.a;
    const double f = norm2(chord) > 0 ? dot(p - piece.a, chord) / norm2(chord) : 0;
    return std::clamp(f, 0.0, 1.0) * total;
  }
  const Point spoke = p - piece.center;
  if (norm2(spoke) == 0) return 0;
  const double s = turn(piece.a - piece.center, spoke, sign_of(piece)) * piece.radius;
  if (s <= total) return s;
  return distance(p, piece.a) <= distance(p, piece.b) ? 0 : total;
}

double twice_area_under(const CurvePiece& piece, Point origin) {
  double twice = cross(piece.a - origin, piece.b - origin);
  if (piece.is_arc()) twice += norm2(piece.a - piece.center) * (piece.sweep - sine(piece.sweep));
  return twice;
}

CurvePiece sub_piece(const CurvePiece& piece, double s0, double s1, Point start, Point end) {
  CurvePiece part{.a = start, .b = end};
  if (!piece.is_arc()) return part;
  const double expected = std::copysign((s1 - s0) / piece.radius, piece.sweep);
  const Point u = start - piece.center;
  const Point v = end - piece.center;
  double sweep = arc_tangent(cross(u, v), dot(u, v));
  // The ends tell the turn up to full turns; the arc lengths tell how many.
  if (sweep - expected > kPi) sweep -= 2 * kPi;
  if (expected - sweep > kPi) sweep += 2 * kPi;
  if (sweep * piece.sweep <= 0) return part;  // shorter than the rounding of its ends
  part.center = piece.center;
  part.radius = piece.radius;
  part.sweep = sweep;
  return part;
}

}  // namespace quadline
