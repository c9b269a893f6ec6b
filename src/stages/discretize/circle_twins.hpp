#pragma once

#include "domain/domain.hpp"

namespace quadline {

/// The other half of each half circle, where the two make a whole one and want about the same number of edges; invalid
/// for all other curves. Which lines meet the circle at the two vertices does not matter. O(n log n).
///
/// @param lengths  edges that the sizes ask for along each curve.
IdVector<CurveId, CurveId> circle_twins(const Domain& domain, const IdVector<CurveId, double>& lengths);

}  // namespace quadline
