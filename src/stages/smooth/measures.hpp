#pragma once

#include "geom/element.hpp"
#include "stages/smooth/stars.hpp"

namespace quadline {

/// The quads round star i with its node at p.
inline QuadPoints quad_of(const Stars& stars, const Spoke& s, Point p) {
  return {p, stars.point(s.next), stars.point(s.opposite), stars.point(s.previous)};
}

/// Least scaled Jacobian round star i with its node at p.
inline double worst_jacobian(const Stars& stars, std::size_t i, Point p) {
  double least = 1;
  for (const Spoke& s : stars.spokes(i)) least = std::fmin(least, scaled_jacobian(quad_of(stars, s, p)));
  return least;
}

// The steps of smoothing, in their order; each keeps or raises the least scaled Jacobian of every star it changes.

/// [Lee2003 section 6]: a node goes to the centroid of its neighbours if that improves its elements.
void laplacian(Stars& stars, int passes, double min_move);
/// Minimises the inverse mean ratio of the corners, to the power `power` [Knupp2000]; where a star has a corner that is
/// not convex, a barrier that lets it pass through zero untangles it [Garanzha2021].
void optimize(Stars& stars, int passes, double min_move, int power);
/// Raises the geometric mean of beta without lowering the worst corner below what it is, or a floor.
void polish(Stars& stars, int passes, double min_move);

}  // namespace quadline
