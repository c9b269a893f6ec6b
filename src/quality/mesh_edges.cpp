#include "quality/mesh_edges.hpp"

#include <algorithm>

namespace quadline {

// By the smaller node through counting, then each node's few.
MeshEdges::MeshEdges(const Mesh& mesh) {
  sides_.fill(mesh.points.size(), [&](const auto& visit) {
    std::uint32_t face = 0;
    const auto walk = [&](const auto& nodes) {
      for (std::size_t i = 0; i < nodes.size(); ++i) {
        const NodeIndex p = nodes[i], q = nodes[(i + 1) % nodes.size()];
        const NodeIndex a = std::min(p, q), b = std::max(p, q);
        visit(a, Side{a, b, face, static_cast<std::uint8_t>(i), p < q});
      }
      ++face;
    };
    for (const auto& quad : mesh.quads) walk(quad);
    for (const auto& triangle : mesh.triangles) walk(triangle);
  });
  first_side_.reserve(sides_.items().size() / 2 + 1);  // nearly all edges have two
  first_edge_.reserve(sides_.count() + 1);
  std::uint32_t n_sides = 0;
  for (std::size_t v = 0; v < sides_.count(); ++v) {
    first_edge_.push_back(static_cast<std::uint32_t>(first_side_.size()));
    const std::span<Side> row = sides_[v];
    std::sort(row.begin(), row.end(),
              [](const Side& s, const Side& t) { return s.b != t.b ? s.b < t.b : s.face < t.face; });
    for (std::size_t i = 0; i < row.size(); ++i, ++n_sides)
      if (i == 0 || row[i].b != row[i - 1].b) first_side_.push_back(n_sides);
  }
  first_edge_.push_back(static_cast<std::uint32_t>(first_side_.size()));
  first_side_.push_back(n_sides);
}

std::size_t MeshEdges::find(NodeIndex p, NodeIndex q) const {
  const NodeIndex a = std::min(p, q), b = std::max(p, q);
  if (a >= sides_.count()) return count();
  for (std::size_t e = first_edge_[a]; e < first_edge_[a + 1]; ++e)
    if (sides_.items()[first_side_[e]].b == b) return e;
  return count();
}

}  // namespace quadline
