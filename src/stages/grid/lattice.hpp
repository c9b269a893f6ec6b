#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "base/id.hpp"
#include "stages/grid/walk_nodes.hpp"

namespace quadline {

/// A node of a grid by its column and row.
struct GridPlace {
  int i = 0, j = 0;
  friend bool operator==(GridPlace, GridPlace) = default;
};

/// The places of the nodes of a walk that begins at (0, 0) in a direction, 0 to 3 quarter turns from that of growing i;
/// then that of its end, which is (0, 0) where the walk closes. [Whiteley1996]
std::vector<GridPlace> traced(const NodeWalk& walk, int direction);

/// Quads that are left out of a grid, for a hole and the rings round it.
struct Patch {
  GridPlace corner;  ///< least i and j
  int columns = 0, rows = 0;
};

/// A cell as a part of the lattice of whole numbers: which unit squares are quads, and what nodes they have.
class Lattice {
 public:
  /// @param rows_round  > 0: a ring; row `rows_round` is row 0.
  Lattice(int columns, int rows, bool is_ring);

  int columns() const { return columns_; }
  int rows() const { return rows_; }
  bool is_ring() const { return is_ring_; }

  /// Invalid: none there.
  NodeId& node(GridPlace p) { return nodes_[index(p)]; }
  NodeId node(GridPlace p) const { return nodes_[index(p)]; }
  bool is_on_boundary(GridPlace p) const { return on_boundary_[index(p)] != 0; }

  /// Puts the nodes of a walk at their places. False where another node, or none, is there already.
  bool put(const NodeWalk& walk, std::span<const GridPlace> places);
  /// Tells inside from outside. False where the walks wind round a square more than once. @pre all walks are put.
  bool find_inside();
  /// False where a quad of it is not inside, or a boundary node is.
  bool cut(const Patch& patch);
  /// A square whose corner of least i and j is at p is a quad.
  bool is_quad(int i, int j) const { return inside_[square(i, j)] > 0; }
  /// A corner of a quad, or on the rim of a patch.
  bool is_used(GridPlace p) const;

 private:
  std::size_t index(GridPlace p) const {
    const int j = is_ring_ ? wrapped(p.j) : p.j;
    return static_cast<std::size_t>(j) * static_cast<std::size_t>(columns_ + 1) + static_cast<std::size_t>(p.i);
  }
  std::size_t square(int i, int j) const {
    return static_cast<std::size_t>(is_ring_ ? wrapped(j) : j) * static_cast<std::size_t>(columns_) +
           static_cast<std::size_t>(i);
  }
  int wrapped(int j) const { return ((j % rows_) + rows_) % rows_; }
  bool contains(GridPlace p) const { return p.i >= 0 && p.i <= columns_ && (is_ring_ || (p.j >= 0 && p.j <= rows_)); }

  int columns_, rows_;
  bool is_ring_;
  std::vector<NodeId> nodes_;
  std::vector<std::uint8_t> on_boundary_, on_rim_;
  std::vector<std::int8_t> inside_;  ///< by squares: first the steps of the winding number, then 1 or 0
};

}  // namespace quadline
