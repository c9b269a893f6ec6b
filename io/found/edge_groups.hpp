#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "quadline/mesh.hpp"

namespace quadline {

/// Mesh edges that belong to the same curves. Where a line runs along another, or along the boundary, an edge belongs
/// to both; files name each edge once.
struct EdgeGroup {
  std::vector<std::uint32_t> curves;            ///< indices into `Mesh::curves`, ascending
  std::vector<std::array<NodeIndex, 2>> edges;  ///< in the order and direction of the first of the curves
};

/// Splits the edges of all curves (or of the lines alone) into groups; each edge is in exactly one of them.
/// Groups come in the order of their first edge. O(n log n).
std::vector<EdgeGroup> edge_groups(const Mesh& mesh, bool lines_only);

}  // namespace quadline
