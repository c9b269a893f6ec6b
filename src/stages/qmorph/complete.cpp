// Completion: turns whatever triangles the front left behind into quads, always. Every connected set of them is even in
// number (its loops are), so a set J of edges exists that meets each triangle once or three times (a T-join of the
// dual graph): pairs joined by one edge of J merge, all other edges of J are halved. Boundaries and lines stay.
#include <algorithm>
#include <numeric>

#include "base/check.hpp"
#include "stages/qmorph/morph.hpp"

namespace quadline {

namespace {

struct DualEdge {
  EdgeId edge;
  double worth;  // scaled Jacobian of the quad that merging gives
};

class Completion {
 public:
  Completion(WorkMesh& mesh, const std::vector<FaceId>& triangles) : mesh_(mesh), triangles_(triangles) {}

  // Picks J: `mark` says which edges are in it.
  void choose() {
    const Topology& topo = mesh_.topo();
    degree_.assign(topo.face_capacity(), 0);
    in_join_.assign(topo.edge_capacity(), 0);
    std::vector<DualEdge> edges;
    for (const FaceId f : triangles_)
      topo.for_each_half(f, [&](HalfId h) {
        if (h < twin(h) && is_dual(h)) edges.push_back({edge_of(h), worth(h)});
      });
    std::sort(edges.begin(), edges.end(), [](const DualEdge& a, const DualEdge& b) {
      return a.worth != b.worth ? a.worth > b.worth : a.edge < b.edge;
    });
    join(edges);
  }

  // The clusters of triangles that J ties together, each with its quads.
  template <class Emit>
  void realize(Emit emit) {
    const Topology& topo = mesh_.topo();
    IdVector<FaceId, std::uint8_t> done(topo.face_capacity(), 0);
    IdVector<EdgeId, NodeId> middle(topo.edge_capacity());
    for (const FaceId seed : triangles_) {
      if (done[seed]) continue;
      std::vector<FaceId> cluster{seed};
      done[seed] = 1;
      for (std::size_t i = 0; i < cluster.size(); ++i)
        topo.for_each_half(cluster[i], [&](HalfId h) {
          const FaceId g = topo.face(twin(h));
          if (!is_dual(h) || !in_join_[edge_of(h)] || done[g]) return;
          done[g] = 1;
          cluster.push_back(g);
        });
      std::vector<Polygon> quads;
      if (cluster.size() == 2) {
        quads.push_back(merged(cluster[0]));
      } else {
        for (const FaceId f : cluster) cut(f, middle, quads);
      }
      emit(cluster, quads);
    }
  }

 private:
  bool is_dual(HalfId h) const { return mesh_.can_merge(edge_of(h)) == Refusal::None; }
  int& degree(EdgeId e, int side) { return degree_[mesh_.topo().face(half_of(e, side))]; }
  void flip(EdgeId e) {
    const int change = in_join_[e] ? -1 : 1;
    in_join_[e] ^= 1;
    degree(e, 0) += change;
    degree(e, 1) += change;
  }
  double worth(HalfId h) const {
    const Topology& topo = mesh_.topo();
    const auto p = [&](HalfId g) { return mesh_.point(topo.tail(g)); };
    return scaled_jacobian({p(h), p(topo.prev(twin(h))), p(twin(h)), p(topo.prev(h))});
  }

  // Along a spanning tree of the best edges of each connected set, from the leaves to the root, every triangle that
  // meets no edge of J or two takes that to its parent: the only J in the tree. The root comes out odd because the set
  // is even.
  void join(const std::vector<DualEdge>& edges) {
    const Topology& topo = mesh_.topo();
    IdVector<FaceId, FaceId> group(topo.face_capacity());
    for (const FaceId f : triangles_) group[f] = f;
    const auto find = [&](FaceId f) {
      while (group[f] != f) f = group[f] = group[group[f]];
      return f;
    };
    IdVector<EdgeId, std::uint8_t> in_tree(topo.edge_capacity(), 0);
    for (const DualEdge& e : edges) {
      const FaceId a = find(topo.face(half_of(e.edge, 0))), b = find(topo.face(half_of(e.edge, 1)));
      if (a == b) continue;
      group[a] = b;
      in_tree[e.edge] = 1;
    }
    IdVector<FaceId, std::uint8_t> seen(topo.face_capacity(), 0);
    for (const FaceId root : triangles_) {
      if (seen[root]) continue;
      struct Visit {
        FaceId face;
        EdgeId to_parent;
      };
      std::vector<Visit> order{{root, EdgeId()}};
      seen[root] = 1;
      for (std::size_t i = 0; i < order.size(); ++i)
        topo.for_each_half(order[i].face, [&](HalfId h) {
          if (!in_tree[edge_of(h)] || seen[topo.face(twin(h))]) return;
          seen[topo.face(twin(h))] = 1;
          order.push_back({topo.face(twin(h)), edge_of(h)});
        });
      for (std::size_t i = order.size(); i-- > 1;)
        if (degree_[order[i].face] % 2 == 0) flip(order[i].to_parent);
      QUADLINE_CHECK(degree_[root] % 2 == 1);  // an even number of triangles
    }
  }

  Polygon merged(FaceId f) const {
    const Topology& topo = mesh_.topo();
    HalfId shared;
    topo.for_each_half(f, [&](HalfId h) {
      if (is_dual(h) && in_join_[edge_of(h)]) shared = h;
    });
    return {topo.tail(shared), topo.tail(topo.prev(twin(shared))), topo.head(shared), topo.tail(topo.prev(shared))};
  }

  void cut(FaceId f, IdVector<EdgeId, NodeId>& middle, std::vector<Polygon>& quads) {
    const Topology& topo = mesh_.topo();
    std::array<NodeId, 3> corner, mid;
    int i = 0;
    Point centre;
    topo.for_each_half(f, [&](HalfId h) {
      corner[i] = topo.tail(h);
      centre += (1.0 / 3) * mesh_.point(corner[i]);
      if (is_dual(h) && in_join_[edge_of(h)]) {
        NodeId& m = middle[edge_of(h)];
        if (!m.valid()) m = mesh_.add_node(midpoint(mesh_.point(topo.tail(h)), mesh_.point(topo.head(h))));
        mid[i] = m;
      }
      ++i;
    });
    if (degree_[f] == 3) {
      const NodeId c = mesh_.add_node(centre);
      for (int k = 0; k < 3; ++k) quads.push_back({corner[k], mid[k], c, mid[(k + 2) % 3]});
      return;
    }
    for (int k = 0; k < 3; ++k)
      if (mid[k].valid()) quads.push_back({corner[k], mid[k], corner[(k + 1) % 3], corner[(k + 2) % 3]});
  }

  WorkMesh& mesh_;
  const std::vector<FaceId>& triangles_;
  IdVector<FaceId, int> degree_;  // edges of J round a triangle
  IdVector<EdgeId, std::uint8_t> in_join_;
};

}  // namespace

void Morph::complete() {
  const Topology& topo = mesh_.topo();
  std::vector<FaceId> triangles;
  for (const FaceId f : topo.faces())
    if (topo.is_triangle(f)) triangles.push_back(f);
  if (triangles.empty()) return;
  Completion completion(mesh_, triangles);
  completion.choose();
  std::vector<std::pair<std::vector<FaceId>, std::vector<Polygon>>> clusters;
  completion.realize([&](auto& cluster, auto& quads) { clusters.emplace_back(cluster, quads); });
  counts_.completion_triangles += triangles.size();
  for (const auto& [cluster, quads] : clusters) {
    counts_.completion_quads += quads.size();
    put_quads(cluster, quads, 0);
  }
}

}  // namespace quadline
