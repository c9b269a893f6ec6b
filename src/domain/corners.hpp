#pragma once

#include <vector>

#include "domain/domain.hpp"
#include "quadline/quality.hpp"

namespace quadline {

/// The corners of all cells in which quads cannot all have right angles: bound below 1, in the order of the walks.
/// Cost O(curves).
std::vector<CellCorner> corners_of(const Domain& domain);

}  // namespace quadline
