#pragma once

#include <cstdint>
#include <vector>

#include "domain/domain.hpp"

namespace quadline {

/// Gives each curve of a whole circle its part of a number of edges, by its turn, one at least: so circles with
/// vertices on the same rays have nodes on the same rays. O(n).
/// @pre there are as many edges as curves.
void share_edges(Domain& domain, const std::vector<DirectedCurve>& circle, std::uint32_t edges);

/// Edges that the curves of a circle are to have together; 0 where a curve has no number of its own.
std::uint32_t given_edges(const Domain& domain, const std::vector<DirectedCurve>& circle);

}  // namespace quadline
