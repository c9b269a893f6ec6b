#include "stages/grid/walk_nodes.hpp"

#include <algorithm>
#include <utility>

#include "domain/walk_turns.hpp"

namespace quadline {

namespace {

// The nodes of each curve of the cell, in its direction.
class CurveChains {
 public:
  explicit CurveChains(const WorkMesh& mesh) {
    for (const Segment& s : mesh.segments()) order_.push_back(&s);
    std::stable_sort(order_.begin(), order_.end(),
                     [](const Segment* a, const Segment* b) { return a->curve < b->curve; });
  }

  // Calls visit(node) for the nodes of a directed curve but the last.
  template <class Visit>
  void for_each_node(const DirectedCurve& d, Visit visit) const {
    const auto is_before = [](const Segment* s, CurveId c) { return s->curve < c; };
    const auto first = std::lower_bound(order_.begin(), order_.end(), d.curve, is_before);
    auto last = first;
    while (last != order_.end() && (*last)->curve == d.curve) ++last;
    if (d.reversed) {
      for (auto s = last; s != first; --s) visit((*(s - 1))->b);
    } else {
      for (auto s = first; s != last; ++s) visit((*s)->a);
    }
  }

 private:
  std::vector<const Segment*> order_;  // by curve, and along it
};

}  // namespace

std::vector<NodeWalk> walks_of(const WorkMesh& mesh, const Domain& domain, CellId c) {
  const CurveChains chains(mesh);
  std::vector<NodeWalk> walks;
  for (const auto& curves : domain.cells[c].walks) {
    const std::vector<int> quads = quads_along(domain, curves);
    NodeWalk walk;
    for (std::size_t i = 0; i < curves.size(); ++i) {
      int turn = 2 - quads[i];
      walk.turns += turn;
      chains.for_each_node(curves[i], [&](NodeId v) { walk.nodes.push_back({v, std::exchange(turn, 0)}); });
    }
    walks.push_back(std::move(walk));
  }
  return walks;
}

}  // namespace quadline
