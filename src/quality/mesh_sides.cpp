#include "quality/mesh_sides.hpp"

#include <algorithm>
#include <utility>

namespace quadline {

// By the lower node through counting, then each node's few.
std::vector<Side> sorted_sides(const Mesh& mesh) {
  const auto for_each_side = [&](auto visit) {
    std::uint32_t face = 0;
    const auto walk = [&](const auto& nodes) {
      for (std::size_t i = 0; i < nodes.size(); ++i) {
        const NodeIndex p = nodes[i], q = nodes[(i + 1) % nodes.size()];
        visit(Side{std::min(p, q), std::max(p, q), face, static_cast<std::uint8_t>(i), p < q});
      }
      ++face;
    };
    for (const auto& q : mesh.quads) walk(q);
    for (const auto& t : mesh.triangles) walk(t);
  };
  std::vector<std::size_t> first(mesh.points.size() + 1, 0);
  for_each_side([&](const Side& s) { ++first[s.a + 1]; });
  for (std::size_t i = 1; i < first.size(); ++i) first[i] += first[i - 1];
  std::vector<Side> sides(first.back());
  std::vector<std::size_t> fill = first;
  for_each_side([&](const Side& s) { sides[fill[s.a]++] = s; });
  for (std::size_t v = 0; v + 1 < first.size(); ++v) {
    std::sort(sides.data() + first[v], sides.data() + first[v + 1],
              [](const Side& s, const Side& t) { return s.b != t.b ? s.b < t.b : s.face < t.face; });
  }
  return sides;
}

std::vector<std::array<NodeIndex, 2>> unique_edges(const std::vector<Side>& sides) {
  std::vector<std::array<NodeIndex, 2>> edges;
  for (std::size_t i = 0; i < sides.size(); ++i)
    if (i == 0 || !same_edge(sides[i], sides[i - 1])) edges.push_back({sides[i].a, sides[i].b});
  return edges;
}

EdgeNumbers::EdgeNumbers(std::vector<std::array<NodeIndex, 2>> edges, std::size_t n_nodes)
    : edges_(std::move(edges)), first_(n_nodes + 1, 0) {
  for (const auto& [a, b] : edges_) ++first_[a + 1];
  for (std::size_t i = 1; i < first_.size(); ++i) first_[i] += first_[i - 1];
}

std::size_t EdgeNumbers::find(NodeIndex p, NodeIndex q) const {
  const NodeIndex a = std::min(p, q), b = std::max(p, q);
  for (std::size_t i = first_[a]; i < first_[a + 1]; ++i)
    if (edges_[i][1] == b) return i;
  return count();
}

}  // namespace quadline
