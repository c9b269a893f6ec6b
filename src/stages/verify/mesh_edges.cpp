#include "stages/verify/mesh_edges.hpp"

#include <algorithm>

namespace quadline {

MeshEdges::MeshEdges(const Mesh& mesh) {
  // Sides in the order of their lower node by counting, then each node's few by their higher node.
  std::vector<std::uint32_t> count(mesh.points.size() + 1, 0);
  const auto for_each_side = [&](auto visit) {
    for (const auto& q : mesh.quads)
      for (int i = 0; i < 4; ++i) visit(q[i], q[(i + 1) % 4]);
  };
  for_each_side([&](NodeIndex p, NodeIndex q) { ++count[std::min(p, q) + 1]; });
  for (std::size_t i = 1; i < count.size(); ++i) count[i] += count[i - 1];
  struct Side {
    NodeIndex to;
    bool forward;
  };
  std::vector<Side> sides(count.back());
  std::vector<std::uint32_t> fill(count.begin(), count.end() - 1);
  for_each_side([&](NodeIndex p, NodeIndex q) { sides[fill[std::min(p, q)]++] = {std::max(p, q), p < q}; });
  first_.reserve(count.size());
  for (NodeIndex v = 0; v + 1 < count.size(); ++v) {
    first_.push_back(static_cast<std::uint32_t>(edges_.size()));
    const auto begin = sides.begin() + count[v], end = sides.begin() + count[v + 1];
    std::sort(begin, end, [](const Side& s, const Side& t) { return s.to < t.to; });
    for (auto s = begin; s != end; ++s) {
      if (s == begin || edges_.back().b != s->to) edges_.push_back({v, s->to});
      ++(s->forward ? edges_.back().forward : edges_.back().backward);
    }
  }
  first_.push_back(static_cast<std::uint32_t>(edges_.size()));
}

std::int64_t MeshEdges::find(NodeIndex p, NodeIndex q) const {
  if (p > q) std::swap(p, q);
  for (std::uint32_t i = first_[p]; i < first_[p + 1]; ++i)
    if (edges_[i].b == q) return i;
  return -1;
}

}  // namespace quadline
