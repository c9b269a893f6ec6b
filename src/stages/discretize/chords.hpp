#pragma once

#include <cstdint>
#include <vector>

#include "domain/domain.hpp"

namespace quadline {

/// The nodes of each curve in its direction: tail, nodes inside, head.
using Polylines = IdVector<CurveId, std::vector<Point>>;

/// What becomes of the edges on a curve: they stay, or get a node in the middle, on the curve.
enum class EdgeUse : std::uint8_t { Whole, Halved };

/// Arcs whose chords cross or touch another chord, or have a node between them and the arc: a node that would lie on
/// the wrong side of the arc. Where chords are halved, also those with a node so near outside the arc that the
/// middle of the chord, on the arc, would lie behind it. They need more nodes. By exact predicates, but for nearness;
/// in id order. O(n log n), O(n) without arcs.
std::vector<CurveId> too_coarse_arcs(const Domain& domain, const Polylines& lines,
                                     const IdVector<CurveId, EdgeUse>& uses);

}  // namespace quadline
