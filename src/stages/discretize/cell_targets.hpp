#pragma once

#include "domain/domain.hpp"
#include "stages/discretize/count_target.hpp"

namespace quadline {

/// A cell with three corners wants two edges or more on each side: with one, a quad would have a flat corner.
void widen_triangles(const Domain& domain, IdVector<CurveId, CountTarget>& targets);

/// A cell with five corners or more wants more edges than the sizes ask for along its curves, as its rows fan out
/// inside. Raises the targets, by `kMostCrowded` at most, until the quads that fit are those that its area asks for.
void crowd_polygons(const Domain& domain, IdVector<CurveId, CountTarget>& targets);

inline constexpr double kMostCrowded = 1.35;

}  // namespace quadline
