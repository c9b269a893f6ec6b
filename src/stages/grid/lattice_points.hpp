#pragma once

#include <cstddef>
#include <vector>

#include "quadline/point.hpp"
#include "stages/grid/grid_places.hpp"

namespace quadline {

/// Where the nodes of a lattice lie in the plane.
class LatticePoints {
 public:
  /// @param points  of the nodes that the lattice has.
  LatticePoints(const PlacedCell& cell, const std::vector<Point>& points);

  /// Places the rims of patches as squares round their holes, and the rest between what is known in its row and its
  /// column: the mean of both, the nearer pair counts more. O(n).
  void interpolate();

  Point at(GridPlace p) const { return cell_.frame.to_plane(value_[index(p)]); }

 private:
  int node_rows() const { return cell_.lattice.is_ring() ? cell_.lattice.rows() : cell_.lattice.rows() + 1; }
  std::size_t index(GridPlace p) const {
    return static_cast<std::size_t>(p.j) * static_cast<std::size_t>(cell_.lattice.columns() + 1) +
           static_cast<std::size_t>(p.i);
  }
  GridPlace wrapped(GridPlace p) const;
  Point lap(GridPlace p) const;
  void set(GridPlace p, Point value);
  void set_rim(const PlacedHole& placed);
  void spread(const std::vector<GridPlace>& line);
  void spread_between(const std::vector<GridPlace>& line, std::size_t from, std::size_t to);

  const PlacedCell& cell_;
  std::vector<Point> value_;    ///< in the frame; while spreading: weighted sums
  std::vector<double> weight_;  ///< while spreading
  std::vector<bool> is_known_;
};

}  // namespace quadline
