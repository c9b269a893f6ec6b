#pragma once

#include <cstdint>
#include <vector>

#include "domain/domain.hpp"
#include "geom/curve.hpp"
#include "quadline/options.hpp"

namespace quadline {

/// A place that asks for a size: the straight piece from a to b, or a point where they are equal.
struct SizeSource {
  Point a, b;
  double size;             ///< model units, > 0
  bool is_border = false;  ///< another base size holds on its other side
};

/// Edges that a full circle gets at least: `edges_per_circle`, fewer where it is small against the size around it, in
/// steps of four so that the edges suit its four quarters, and 8 (or `edges_per_circle`, if less) where it is tiny.
double circle_edges(double radius, double size_around, double edges_per_circle);

/// Size at a circle of so many edges, model units.
double curvature_size(double radius, double edges);

/// Least size of the cells beside a curve.
double base_size(const Domain& domain, const Domain::Curve& curve);

/// What the curves ask, each all along itself.
struct CurveSizes {
  IdVector<CurveId, double> sizes;               ///< by its own size, bend or shortness; at most the base size
  IdVector<CurveId, std::uint32_t> least_edges;  ///< that show the bend; 1 where it is straight
};
CurveSizes curve_sizes(const Domain& domain, const Options& options);

/// Appends one source per chord of a part of a curve, from arc length s0 to s1.
void append_sources(const CurvePiece& piece, double s0, double s1, double size, bool is_border,
                    std::vector<SizeSource>& sources);

/// Appends the places where two features of a cell lie closer than the size there: both sides of the gap ask for a
/// size in proportion to it.
/// @param sizes  of `curve_sizes`: wider gaps than what a curve asks itself are not looked for.
/// Cost O(m log n) for m samples, two per edge of the base size.
void append_gaps(const Domain& domain, const IdVector<CurveId, double>& sizes, std::vector<SizeSource>& sources);

}  // namespace quadline
