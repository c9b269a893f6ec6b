#pragma once

#include "quadline/point.hpp"

namespace quadline {

struct Box {
  Point lo, hi;
};

/// A straight segment, or a circular arc of less than a full turn. A place on it is the arc length `s` from `a`.
struct CurvePiece {
  Point a{}, b{};
  Point center{};     ///< arcs only
  double radius = 0;  ///< arcs only
  double sweep = 0;   ///< signed turn from a to b in radians, positive counter-clockwise; 0: straight

  bool is_arc() const { return sweep != 0; }
};

/// The arc from a to b through `via`; a straight piece where the three are collinear (exactly).
CurvePiece arc_through(Point a, Point via, Point b);

CurvePiece reversed(const CurvePiece& piece);
double length(const CurvePiece& piece);
Box box(const CurvePiece& piece);

/// The point at arc length s in [0, length]; exactly `a` at 0 and `b` at the length.
Point point_at(const CurvePiece& piece, double s);

/// Unit tangent in the direction of growing s.
Point tangent_at(const CurvePiece& piece, double s);

/// Arc length of the point of the piece that is nearest to p.
double project(const CurvePiece& piece, Point p);

/// Twice the signed area that the line from `origin` sweeps as its other end goes along the piece.
double twice_area_under(const CurvePiece& piece, Point origin);

/// The part of the piece from s0 to s1, 0 <= s0 < s1 <= length; its ends are given, so that pieces stay joined.
CurvePiece sub_piece(const CurvePiece& piece, double s0, double s1, Point start, Point end);

}  // namespace quadline
