#include "mesh/recover_edge.hpp"

#include "geom/predicates.hpp"

namespace quadline {

namespace {

constexpr std::size_t kSwapsPerEdge = 16;  // beyond it they go round in a circle: both diagonals cross a-b

}  // namespace

Way way_between(const WorkMesh& mesh, NodeId a, NodeId b, EdgeId held, std::size_t most_crossed) {
  const Topology& topo = mesh.topo();
  const Point pa = mesh.point(a), pb = mesh.point(b);
  const auto side = [&](NodeId v) { return orientation(pa, pb, mesh.point(v)); };
  Way way;
  HalfId x;  // crossed: its tail lies right of a-b, its head left
  topo.for_each_out(a, [&](HalfId h) {
    if (x.valid() || way.obstacle.node.valid() || !mesh.is_triangle(h)) return;
    const HalfId rim = topo.next(h);
    const int at_tail = side(topo.tail(rim)), at_head = side(topo.head(rim));
    if (at_tail < 0 && at_head > 0) x = rim;
    const auto is_ahead = [&](NodeId v) { return dot(mesh.point(v) - pa, pb - pa) > 0; };
    if (at_tail == 0 && is_ahead(topo.tail(rim))) way.obstacle.node = topo.tail(rim);
    if (at_head == 0 && is_ahead(topo.head(rim))) way.obstacle.node = topo.head(rim);
  });
  if (way.obstacle.node.valid()) return way;
  while (x.valid() && way.crossed.size() < most_crossed) {
    if (mesh.can_merge(edge_of(x)) != Refusal::None || edge_of(x) == held) {
      way.obstacle.edge = edge_of(x);
      return way;
    }
    way.crossed.push_back(edge_of(x));
    const HalfId right = topo.next(twin(x));
    const NodeId apex = topo.head(right);
    if (apex == b) return way;
    const int s = side(apex);
    if (s == 0) {
      way.obstacle.node = apex;
      return way;
    }
    x = s > 0 ? right : topo.next(right);
  }
  way.crossed.clear();
  return way;
}

HalfId recover_edge(WorkMesh& mesh, NodeId a, NodeId b, std::vector<EdgeId>& way, std::vector<EdgeId>& made) {
  const Topology& topo = mesh.topo();
  const Point pa = mesh.point(a), pb = mesh.point(b);
  std::vector<EdgeId> later;
  std::size_t swaps_left = kSwapsPerEdge * way.size();
  for (bool progress = true; progress && !way.empty(); way.swap(later)) {
    progress = false;
    later.clear();
    for (const EdgeId e : way) {
      if (swaps_left == 0 || mesh.can_swap(e) != Refusal::None) {
        later.push_back(e);
        continue;
      }
      mesh.swap_edge(e);
      --swaps_left;
      progress = true;
      const NodeId c = topo.tail(half_of(e)), d = topo.head(half_of(e));
      const bool at_end = c == a || c == b || d == a || d == b;
      if (!at_end && orientation(pa, pb, mesh.point(c)) * orientation(pa, pb, mesh.point(d)) < 0) {
        later.push_back(e);
      } else if (!((c == a && d == b) || (c == b && d == a))) {
        made.push_back(e);
      }
    }
  }
  way.clear();
  return topo.find(a, b);
}

}  // namespace quadline
