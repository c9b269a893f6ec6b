#pragma once

#include <queue>

#include "base/id.hpp"

namespace quadline::cleanup {

/// Nodes to look at: those for small cavities first, then those for patches; the dearest first, then by id.
class WorkList {
 public:
  enum Phase { Local, Patch, Done };
  struct Entry {
    Phase phase = Done;
    int cost = 0;
    NodeId node;
    bool operator<(const Entry& o) const {
      if (phase != o.phase) return phase > o.phase;
      return cost != o.cost ? cost < o.cost : node > o.node;
    }
  };

  /// Nothing happens where the node waits for that phase or an earlier one already.
  void push(NodeId v, Phase phase, int cost) {
    pending_.grow(v.value + std::size_t{1}, Done);
    if (pending_[v] <= phase) return;
    pending_[v] = phase;
    queue_.push({phase, cost, v});
  }

  /// False: nothing is left.
  bool pop(Entry& entry) {
    while (!queue_.empty()) {
      entry = queue_.top();
      queue_.pop();
      if (pending_[entry.node] != entry.phase) continue;  // pushed again, for an earlier phase
      pending_[entry.node] = Done;
      return true;
    }
    return false;
  }
  std::size_t count() const { return queue_.size(); }

 private:
  std::priority_queue<Entry> queue_;
  IdVector<NodeId, Phase> pending_;
};

}  // namespace quadline::cleanup
