// Measures and meetings of two pieces.
//
// Floating-point signs are enough here: ends nearer than the tolerance to the other piece were dealt with before, so
// the signs that decide stand millions of rounding errors from zero.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "domain/arrange/work.hpp"

namespace quadline::arrangement {

namespace {

/// Meets of the pieces' supports, as far as they lie on both pieces.
class Meetings {
 public:
  Meetings(const Piece& p, const Piece& q, double tolerance)
      : p_(p), q_(q), tolerance_(tolerance), touch_(kTouch * tolerance) {}

  std::vector<Point> find() {
    if (!p_.curve.is_arc() && !q_.curve.is_arc()) {
      segments();
    } else if (p_.curve.is_arc() && q_.curve.is_arc()) {
      arcs();
    } else if (p_.curve.is_arc()) {
      segment_and_arc(q_.curve, p_.curve);
    } else {
      segment_and_arc(p_.curve, q_.curve);
    }
    return std::move(found_);
  }

 private:
  void segments() {
    const CurvePiece *s = &p_.curve, *t = &q_.curve;
    // The point is found along the shorter one, where it is surest.
    if (norm2(t->b - t->a) < norm2(s->b - s->a)) std::swap(s, t);
    const Point u = s->b - s->a;
    const Point v = t->b - t->a;
    const double a = cross(v, s->a - t->a);
    const double b = cross(v, s->b - t->a);
    const double c = cross(u, t->a - s->a);
    const double d = cross(u, t->b - s->a);
    const auto opposite = [](double x, double y) { return (x < 0 && y > 0) || (x > 0 && y < 0); };
    if (opposite(a, b) && opposite(c, d)) keep(s->a + (a / (a - b)) * u);
  }

  void segment_and_arc(const CurvePiece& segment, const CurvePiece& arc) {
    const double chord = distance(segment.a, segment.b);
    const Point along = (1 / chord) * (segment.b - segment.a);
    const Point to_center = arc.center - segment.a;
    const double foot = dot(along, to_center);
    const double off = cross(along, to_center);
    const double depth = arc.radius - std::abs(off);
    if (depth < -touch_) return;
    const auto add = [&](double at, Point p) {
      if (at > 0 && at < chord && is_beside(arc, p)) keep(p);
    };
    if (depth <= touch_) {
      return add(foot, arc.center - std::copysign(arc.radius, off) * left_normal(along));
    }
    const double half = std::sqrt(depth * (arc.radius + std::abs(off)));
    for (const double at : {foot - half, foot + half}) add(at, segment.a + at * along);
  }

  void arcs() {
    const CurvePiece& a = p_.curve;
    const CurvePiece& b = q_.curve;
    const Point axis = b.center - a.center;
    const double apart = norm(axis);
    const double outer_depth = a.radius + b.radius - apart;
    const double inner_depth = apart - std::abs(a.radius - b.radius);
    // One circle lies on the other within the tolerance: they meet at ends only.
    if (apart + std::abs(a.radius - b.radius) <= touch_) return;
    if (outer_depth < -touch_ || inner_depth < -touch_) return;
    const auto add = [&](Point p) {
      if (is_beside(a, p) && is_beside(b, p)) keep(p);
    };
    const Point unit = (1 / apart) * axis;
    if (outer_depth <= touch_) return add(a.center + a.radius * unit);
    if (inner_depth <= touch_) return add(a.center + std::copysign(a.radius, a.radius - b.radius) * unit);
    const double foot = 0.5 * (apart + (a.radius - b.radius) * (a.radius + b.radius) / apart);
    const double half = std::sqrt(std::max(0.0, (a.radius - foot) * (a.radius + foot)));
    for (const double at : {-half, half}) add(a.center + foot * unit + at * left_normal(unit));
  }

  void keep(Point p) {
    for (const VertexId v : {p_.tail, p_.head}) {
      const bool is_shared = v == q_.tail || v == q_.head;
      // A vertex here would merge with the shared one.
      if (is_shared && (distance(p, v == p_.tail ? p_.curve.a : p_.curve.b) <= tolerance_ || is_together(v, p))) return;
    }
    for (const Point end : {p_.curve.a, p_.curve.b, q_.curve.a, q_.curve.b}) {
      if (distance(p, end) <= touch_) return;
    }
    found_.push_back(p);
  }

  /// Do the pieces touch all along from a shared end to p?
  bool is_together(VertexId shared, Point p) const {
    const double from = shared == p_.tail ? 0 : length(p_.curve);
    const double to = project(p_.curve, p);
    for (const double f : {0.25, 0.5, 0.75}) {
      if (distance_to(q_.curve, point_at(p_.curve, from + f * (to - from))) > touch_) return false;
    }
    return true;
  }

  const Piece& p_;
  const Piece& q_;
  double tolerance_, touch_;
  std::vector<Point> found_;
};

}  // namespace

bool is_beside(const CurvePiece& arc, Point p) {
  const double sign = arc.sweep < 0 ? -1 : 1;
  const Point spoke = p - arc.center;
  const bool is_past_a = sign * cross(arc.a - arc.center, spoke) >= 0;
  const bool is_before_b = sign * cross(spoke, arc.b - arc.center) >= 0;
  return std::abs(arc.sweep) <= std::numbers::pi ? is_past_a && is_before_b : is_past_a || is_before_b;
}

double distance_to(const CurvePiece& piece, Point p) {
  if (!piece.is_arc()) {
    const Point chord = piece.b - piece.a;
    const Point to = p - piece.a;
    const double along = dot(to, chord);
    if (along <= 0) return norm(to);
    if (along >= norm2(chord)) return distance(p, piece.b);
    return std::abs(cross(chord, to)) / norm(chord);
  }
  const Point spoke = p - piece.center;
  const double off = norm(spoke);
  if (is_beside(piece, p)) return std::abs(off - piece.radius);
  return std::min(distance(p, piece.a), distance(p, piece.b));
}

std::vector<Point> meetings(const Piece& p, const Piece& q, double tolerance) {
  return Meetings(p, q, tolerance).find();
}

}  // namespace quadline::arrangement
