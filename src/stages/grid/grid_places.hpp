#pragma once

#include <optional>

#include "stages/grid/fill_grid.hpp"
#include "stages/grid/grid_map.hpp"
#include "stages/grid/lattice.hpp"

namespace quadline {

/// A hole with its place in the lattice.
struct PlacedHole {
  GridHole hole;
  Patch patch;
};

/// The cell in the lattice: its walks and holes at their places.
struct PlacedCell {
  GridFrame frame;
  Lattice lattice;
  GridMap columns, rows;  ///< valid where there are holes
  std::vector<PlacedHole> holes;
};

/// Empty where the walks do not close, overlap, or leave no room for a hole. O(n).
std::optional<PlacedCell> place_cell(const WorkMesh& mesh, const GridPlan& plan, const std::vector<NodeWalk>& walks);

}  // namespace quadline
