#pragma once

#include <vector>

#include "mesh/work_mesh.hpp"

namespace quadline {

/// What an edge that should be made runs into; at most one is valid.
struct Obstacle {
  NodeId node;  ///< lies exactly on the way
  EdgeId edge;  ///< crosses the way, and may not be swapped
};

/// The straight way from a node to another through triangles.
struct Way {
  std::vector<EdgeId> crossed;  ///< from the first node on
  Obstacle obstacle;            ///< where the way ends early
};

/// Edges that the segment a-b crosses. Exact.
/// @param held          an edge that counts as an obstacle; may be invalid.
/// @param most_crossed  the walk gives up beyond it (no obstacle then, and no edges).
/// @pre  a and b are not joined by an edge.
Way way_between(const WorkMesh& mesh, NodeId a, NodeId b, EdgeId held, std::size_t most_crossed);

/// Makes the edge a-b by swapping the edges that it crosses [Sloan1993].
///
/// @param way   of `way_between(a, b)`, without an obstacle; empty afterwards.
/// @param made  gets the edges that were swapped, but a-b itself.
/// @return  the half-edge from a to b; invalid where the swaps go round in a circle (given up after 16 for each edge).
HalfId recover_edge(WorkMesh& mesh, NodeId a, NodeId b, std::vector<EdgeId>& way, std::vector<EdgeId>& made);

}  // namespace quadline
