#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "quadline/mesh.hpp"

namespace quadline {

/// One kind of fault that a mesh may have.
struct MeshFault {
  std::string what;       ///< "hanging nodes"
  std::size_t count = 0;  ///< 0: the mesh is free of it
  Point first;            ///< where the first of them is
};

/// Looks for what a solver would choke on: elements that repeat a node, are inverted, flat or not convex; elements that
/// are there twice or lie on the same side of an edge; nodes at the same place; nodes that hang on an edge. Geometry is
/// exact, but for the last two, which take 1e-9 of the extent of the mesh for nothing.
///
/// @return  all kinds, in this order, with their counts. Cost O(n log n).
std::vector<MeshFault> find_faults(const Mesh& mesh);

}  // namespace quadline
