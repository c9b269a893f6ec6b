#pragma once

#include <cstddef>
#include <vector>

#include "domain/domain.hpp"
#include "mesh/work_mesh.hpp"

namespace quadline {

/// A node as a walk round a cell meets it.
struct WalkNode {
  NodeId node;
  int turn;  ///< quarter turns to the left here, as the quads in the corner count them: 0 along a side, -2 at a tip
};

/// A closed walk round a cell, node by node, the cell on its left.
struct NodeWalk {
  std::vector<WalkNode> nodes;
  int turns = 0;  ///< their sum: 4 round a rectangle, -4 round a rectangular hole, 0 round a whole circle
};

/// The walks of a cell in the order of the domain. @param mesh  has the segments of the cell. O(n).
std::vector<NodeWalk> walks_of(const WorkMesh& mesh, const Domain& domain, CellId c);

}  // namespace quadline
