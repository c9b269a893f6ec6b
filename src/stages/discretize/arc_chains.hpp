#pragma once

#include <array>

#include "domain/domain.hpp"

namespace quadline {

/// By curve: the arcs that go on smoothly beyond its tail and its head; invalid where none does, and for straight
/// curves. Whether lines meet there does not matter.
using ArcChains = IdVector<CurveId, std::array<CurveId, 2>>;

/// O(n).
ArcChains arc_chains(const Domain& domain);

/// The other half of each half circle, where the two make a whole one and want about the same number of edges; invalid
/// for all other curves. O(n).
///
/// @param lengths  edges that the sizes ask for along each curve.
IdVector<CurveId, CurveId> circle_twins(const Domain& domain, const ArcChains& chains,
                                        const IdVector<CurveId, double>& lengths);

}  // namespace quadline
