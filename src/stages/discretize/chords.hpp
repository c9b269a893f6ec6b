#pragma once

#include <vector>

#include "domain/domain.hpp"

namespace quadline {

/// The nodes of each curve in its direction: tail, nodes inside, head.
using Polylines = IdVector<CurveId, std::vector<Point>>;

/// Arcs whose chords cross or touch another chord, or have a node between them and the arc: a node that would lie on
/// the wrong side of the arc. They need more nodes. By exact predicates; in id order. O(n log n), O(n) without arcs.
std::vector<CurveId> too_coarse_arcs(const Domain& domain, const Polylines& lines);

}  // namespace quadline
