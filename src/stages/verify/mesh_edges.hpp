#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "quadline/mesh.hpp"

namespace quadline {

/// The edges of the quads of a flat mesh, each with how the faces use it.
class MeshEdges {
 public:
  struct Edge {
    NodeIndex a, b;              ///< a < b
    std::uint32_t forward = 0;   ///< faces that walk it from a to b
    std::uint32_t backward = 0;  ///< faces that walk it from b to a
  };

  /// @pre the nodes of the quads exist. Cost O(n).
  explicit MeshEdges(const Mesh& mesh);

  const std::vector<Edge>& edges() const { return edges_; }
  /// Index of the edge between p and q, either way round; -1: there is none.
  std::int64_t find(NodeIndex p, NodeIndex q) const;

 private:
  std::vector<std::uint32_t> first_;  // of each node: its edges to nodes of higher index
  std::vector<Edge> edges_;
};

}  // namespace quadline
