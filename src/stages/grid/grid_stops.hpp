#pragma once

#include <cstddef>
#include <vector>

namespace quadline {

/// What a grid must meet along one of its coordinates: sides of the cell and middles of holes.
struct GridStop {
  double at = 0;             ///< in the frame
  int k = 0;                 ///< of a hole: squares of its patch; 0: a side
  double low = 0, high = 0;  ///< the part of the other coordinate that it takes
  double index = 0;          ///< in the grid: whole, and a half more where k is odd
};

/// Gives stops their places in the grid, from 0 at the first: near `density` squares for each unit, equal gaps alike,
/// room for the patches of holes that face each other. Stops nearer than `together` get one place. O(n log n).
void place_stops(std::vector<GridStop>& stops, double density, double together);

/// The place in the grid of a coordinate of the frame, between stops that have theirs.
double index_at(const std::vector<GridStop>& stops, double at);

}  // namespace quadline
