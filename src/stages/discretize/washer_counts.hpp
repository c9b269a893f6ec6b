#pragma once

#include "domain/domain.hpp"
#include "stages/discretize/count_target.hpp"

namespace quadline {

/// Gives the curves of every washer exact counts: those that are asked for, or one number for all its circles near what
/// their sizes ask for, a multiple of four. Curves between the same rays get the same count.
/// @param all_halved  the counts are those before all edges are halved.
/// O(n log n).
void set_washer_counts(const Domain& domain, bool all_halved, IdVector<CurveId, CountTarget>& targets);

}  // namespace quadline
