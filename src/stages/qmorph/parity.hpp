#pragma once

#include <cstdint>
#include <vector>

#include "base/id.hpp"

namespace quadline {

/// Two-colouring of the nodes on fronts: neighbours on a front, and in a quad, differ.
///
/// All front loops are even exactly as long as the colours fit, so one look-up tells whether a new edge between two
/// front nodes keeps the loops even; nobody counts a loop. A union-find forest whose links say "same" or "differs";
/// without path compression, so that ties can be taken back.
class Parity {
 public:
  /// Ties the colours of a and b; false, and nothing changed, where they contradict what is known. O(log n).
  bool tie(NodeId a, NodeId b, bool differ) {
    const Place pa = find(a), pb = find(b);
    const bool apart = pa.odd != pb.odd;
    if (pa.root == pb.root) return apart == differ;
    const bool a_larger = links_[pa.root].size >= links_[pb.root].size;
    const std::uint32_t top = a_larger ? pa.root : pb.root, below = a_larger ? pb.root : pa.root;
    links_[below].up = top;
    links_[below].odd = apart != differ;
    links_[top].size += links_[below].size;
    ties_.push_back(below);
    return true;
  }

  std::size_t mark() const { return ties_.size(); }

  /// Takes back every tie made since `mark()` was `mark`.
  void rollback(std::size_t mark) {
    for (; ties_.size() > mark; ties_.pop_back()) {
      Link& link = links_[ties_.back()];
      links_[link.up].size -= link.size;
      link.up = ties_.back();
      link.odd = false;
    }
  }

  /// A new node took the id v: it has no colour yet.
  void forget(NodeId v) {
    slots_.grow(v.value + std::size_t{1}, kNone);
    slots_[v] = kNone;
  }

 private:
  struct Link {
    std::uint32_t up;
    std::uint32_t size = 1;
    bool odd = false;  ///< the colour differs from that of `up`
  };
  struct Place {
    std::uint32_t root;
    bool odd;
  };
  static constexpr std::uint32_t kNone = UINT32_MAX;

  Place find(NodeId v) {
    slots_.grow(v.value + std::size_t{1}, kNone);
    if (slots_[v] == kNone) {
      slots_[v] = static_cast<std::uint32_t>(links_.size());
      links_.push_back({slots_[v]});
    }
    std::uint32_t i = slots_[v];
    bool odd = false;
    for (; links_[i].up != i; i = links_[i].up) odd ^= links_[i].odd;
    return {i, odd};
  }

  IdVector<NodeId, std::uint32_t> slots_;  // a node's link; ids of deleted nodes come back, links do not
  std::vector<Link> links_;
  std::vector<std::uint32_t> ties_;
};

}  // namespace quadline
