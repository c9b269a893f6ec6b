// The top edge comes from swaps [Owen1999 section 3.3]. We differ: the walk uses exact predicates, and gives up (which
// is normal: the base edge waits until the front has changed) where the edge would cross a front, a line or a node.
#include "mesh/recover_edge.hpp"
#include "stages/qmorph/morph.hpp"

namespace quadline {

namespace {

constexpr std::size_t kMostCrossed = 48;  // more means that the two ends are no neighbours

}  // namespace

HalfId Morph::recover_edge(NodeId a, NodeId b) {
  if (const HalfId h = mesh_.topo().find(a, b); h.valid()) return h;
  Way way = way_between(mesh_, a, b, held_, kMostCrossed);
  if (way.crossed.empty() || way.obstacle.node.valid() || way.obstacle.edge.valid()) return {};
  std::vector<EdgeId> made;
  return quadline::recover_edge(mesh_, a, b, way.crossed, made);
}

}  // namespace quadline
