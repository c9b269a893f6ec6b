#pragma once

#include "domain/domain.hpp"
#include "stages/grid/plan_grids.hpp"

namespace quadline {

/// What a grid that is proposed is worth, with the nodes on its curves as it wishes them and the cell's size
/// everywhere: its cost in the measure of `cell_cost` for each quad, infinity where the cell would not keep it. O(n log
/// n).
double rehearsed_cost(const Domain& domain, CellId c, const GridProposal& proposal);

}  // namespace quadline
