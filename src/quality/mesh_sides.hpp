#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "quadline/mesh.hpp"

namespace quadline {

/// A side of a face.
struct Side {
  NodeIndex a, b;       ///< a < b
  std::uint32_t face;   ///< quads first, then triangles
  std::uint8_t corner;  ///< of the face, where the side starts
  bool forward;         ///< the face walks from a to b
};

inline bool same_edge(const Side& s, const Side& t) { return s.a == t.a && s.b == t.b; }

/// All sides of all faces, ascending by their nodes, so that equal edges stand beside each other. Cost O(sides).
std::vector<Side> sorted_sides(const Mesh& mesh);

/// Every edge once, in the order of the sides: that of `edges_of`.
std::vector<std::array<NodeIndex, 2>> unique_edges(const std::vector<Side>& sides);

/// Finds edges by their nodes.
class EdgeNumbers {
 public:
  /// @param edges  ascending, the smaller node first, as `edges_of` gives them.
  EdgeNumbers(std::vector<std::array<NodeIndex, 2>> edges, std::size_t n_nodes);

  std::size_t count() const { return edges_.size(); }

  /// Index of the edge between two nodes, in either order; `count()` where the mesh has none.
  std::size_t find(NodeIndex p, NodeIndex q) const;

 private:
  std::vector<std::array<NodeIndex, 2>> edges_;
  std::vector<std::size_t> first_;  // by node: its first edge as the smaller node
};

}  // namespace quadline
