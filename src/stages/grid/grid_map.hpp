#pragma once

#include <cstddef>
#include <vector>

namespace quadline {

/// One coordinate of a frame against that of a grid: piecewise linear through the nodes that are known, growing.
class GridMap {
 public:
  /// A node whose place in the grid is known.
  struct Known {
    double at;  ///< in the frame
    int index;  ///< in the grid
  };
  /// Of nodes with one index the mean counts. `is_valid` is false where the two do not grow together. O(n log n).
  explicit GridMap(std::vector<Known> known);

  bool is_valid() const { return is_valid_; }
  double to_grid(double at) const;      ///< beyond the ends as the last piece goes on
  double to_frame(double index) const;  ///< its inverse

 private:
  struct Knot {
    double at, index;
  };
  std::vector<Knot> knots_;
  bool is_valid_ = false;
};

}  // namespace quadline
