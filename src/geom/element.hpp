#pragma once

#include <array>

#include "quadline/point.hpp"

namespace quadline {

/// Four corners, counter-clockwise.
using QuadPoints = std::array<Point, 4>;

/// Twice the signed area of the triangle a b c.
constexpr double twice_area(Point a, Point b, Point c) { return cross(b - a, c - a); }

/// Triangle distortion coefficient alpha [Lee2003 eq 1]: 1 for an equilateral triangle, negative for an inverted one.
double triangle_distortion(Point a, Point b, Point c);

/// Quad distortion coefficient beta [Lee2003 eq 2] with signed alphas: 0 where a triangle of the quad is inverted.
double quad_distortion(const QuadPoints& q);

/// Least sine of a corner, signed; negative for a reflex corner, 0 for a flat or collapsed one.
double scaled_jacobian(const QuadPoints& q);

/// The interior angle of `angle_at` in radians, (0, 2 pi]; for decisions that is the better one.
double corner_angle(Point previous, Point corner, Point next);

/// Mean over the corners of (|u|^2 + |v|^2) / (2 det(u, v)) [Knupp2000]: 1 for a square; infinite where a corner is not
/// convex.
double inverse_mean_ratio(const QuadPoints& q);

}  // namespace quadline
