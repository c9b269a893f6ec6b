#pragma once

#include <cstdint>
#include <queue>

#include "stages/qmorph/morph.hpp"

namespace quadline {

/// Front edges in the order in which they become base edges: by level, then those with a corner to be seamed, then by
/// states (1-1, one 1, none), then the shorter, then by id. Entries that a later push has replaced are skipped.
class FrontQueue {
 public:
  explicit FrontQueue(const Morph& morph) : morph_(morph) {}

  void push(HalfId h) {
    const WorkMesh& mesh = morph_.mesh();
    const Corner before = corner_before(mesh, h), after = corner_after(mesh, h);
    const int closed = (before.state == State::Closed) + (after.state == State::Closed);
    const bool seam = before.quads == 0 || after.quads == 0;
    version_.grow(h.value + std::size_t{1}, 0);
    heap_.push({morph_.level(edge_of(h)), seam ? 0 : 3 - closed, mesh.edge_length(edge_of(h)), h, ++version_[h]});
  }
  /// The next base edge; invalid when there is none.
  HalfId pop() {
    while (!heap_.empty()) {
      const Entry e = heap_.top();
      heap_.pop();
      if (e.version == version_[e.half]) return e.half;
    }
    return {};
  }

 private:
  struct Entry {
    int level, rank;
    double length;
    HalfId half;
    std::uint32_t version;
    bool operator<(const Entry& o) const {  // the heap gives its largest: the entry that should go first
      if (level != o.level) return level > o.level;
      if (rank != o.rank) return rank > o.rank;
      if (length != o.length) return length > o.length;
      return half > o.half;
    }
  };
  const Morph& morph_;
  std::priority_queue<Entry> heap_;
  IdVector<HalfId, std::uint32_t> version_;
};

}  // namespace quadline
