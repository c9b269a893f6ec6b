// Recovers the top edge by swaps [Owen1999 section 3.3]. We differ: the walk uses exact predicates, and gives up (which
// is normal: the base edge waits until the front has changed) where the edge would cross a front, a line or a node.
#include <deque>

#include "geom/predicates.hpp"
#include "stages/qmorph/morph.hpp"

namespace quadline {

namespace {

constexpr std::size_t kLongestWalk = 48;  // edges crossed; more means that the two ends are no neighbours

// The edges that the segment a-b crosses, from a on; empty where it meets a front, a constraint or a node.
std::deque<EdgeId> crossed_edges(const WorkMesh& mesh, NodeId a, NodeId b) {
  const Topology& topo = mesh.topo();
  const Point pa = mesh.point(a), pb = mesh.point(b);
  const auto side = [&](NodeId v) { return orientation(pa, pb, mesh.point(v)); };
  HalfId x;  // crossed: its tail lies right of a-b, its head left
  topo.for_each_out(a, [&](HalfId h) {
    if (x.valid() || !mesh.is_triangle(h)) return;
    const HalfId rim = topo.next(h);
    if (side(topo.tail(rim)) < 0 && side(topo.head(rim)) > 0) x = rim;
  });
  std::deque<EdgeId> crossed;
  while (x.valid() && crossed.size() < kLongestWalk) {
    if (mesh.is_constraint(x) || !mesh.is_triangle(twin(x))) return {};
    crossed.push_back(edge_of(x));
    const HalfId right = topo.next(twin(x));
    const NodeId apex = topo.head(right);
    if (apex == b) return crossed;
    const int s = side(apex);
    if (s == 0) return {};
    x = s > 0 ? right : topo.next(right);
  }
  return {};
}

}  // namespace

HalfId Morph::recover_edge(NodeId a, NodeId b) {
  const Topology& topo = mesh_.topo();
  if (const HalfId h = topo.find(a, b); h.valid()) return h;
  std::deque<EdgeId> crossed = crossed_edges(mesh_, a, b);
  if (crossed.empty()) return {};
  for (const EdgeId e : crossed)
    if (is_held(e)) return {};

  const Point pa = mesh_.point(a), pb = mesh_.point(b);
  std::size_t refused = 0, steps = crossed.size() * crossed.size() + 16;
  while (!crossed.empty() && refused <= crossed.size() && steps-- > 0) {
    const EdgeId e = crossed.front();
    crossed.pop_front();
    if (mesh_.can_swap(e) != Refusal::None) {
      crossed.push_back(e);
      ++refused;
      continue;
    }
    mesh_.swap_edge(e);
    refused = 0;
    const NodeId c = topo.tail(half_of(e)), d = topo.head(half_of(e));
    if (c == a || c == b || d == a || d == b) continue;
    if (orientation(pa, pb, mesh_.point(c)) != orientation(pa, pb, mesh_.point(d))) crossed.push_back(e);
  }
  return topo.find(a, b);
}

}  // namespace quadline
