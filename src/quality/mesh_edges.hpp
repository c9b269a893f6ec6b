#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "base/csr.hpp"
#include "quadline/mesh.hpp"

namespace quadline {

/// A side of a face.
struct Side {
  NodeIndex a, b;       ///< a < b
  std::uint32_t face;   ///< quads first, then triangles
  std::uint8_t corner;  ///< of the face, where the side starts
  bool forward;         ///< the face walks from a to b
};

/// The edges of a flat mesh, ascending by their nodes, each with the sides of the faces at it: the order of `edges_of`.
class MeshEdges {
 public:
  /// @pre  the nodes of the faces exist. Cost O(sides).
  explicit MeshEdges(const Mesh& mesh);

  std::size_t count() const { return first_side_.size() - 1; }
  /// By face, ascending; two where the edge is inside a sound mesh, one on its boundary.
  std::span<const Side> sides(std::size_t edge) const {
    return sides_.items().subspan(first_side_[edge], first_side_[edge + 1] - first_side_[edge]);
  }
  /// The smaller one first.
  std::array<NodeIndex, 2> nodes(std::size_t edge) const {
    const Side& side = sides_.items()[first_side_[edge]];
    return {side.a, side.b};
  }
  /// Index of the edge between two nodes, in either order; `count()` where the mesh has none. O(edges at a node).
  std::size_t find(NodeIndex p, NodeIndex q) const;

 private:
  Rows<Side> sides_;                       // by their smaller node
  std::vector<std::uint32_t> first_side_;  // of each edge, and the end
  std::vector<std::uint32_t> first_edge_;  // of each node as the smaller one, and the end
};

}  // namespace quadline
