#pragma once

#include <cstddef>
#include <vector>

#include "domain/domain.hpp"
#include "mesh/work_mesh.hpp"
#include "stages/grid/grid_frame.hpp"

namespace quadline {

/// A hole in a grid: a patch of quads is left out, and rings of as many quads as its rim has edges go round the hole.
struct GridHole {
  std::size_t walk = 0;       ///< of the cell
  int columns = 0, rows = 0;  ///< of the patch
  int rings = 1;
  Point at{};     ///< centre, model units
  Point place{};  ///< of the centre in the grid, as planned
};

/// How a cell becomes a grid.
struct GridPlan {
  GridFrame frame{};
  int direction = 0;          ///< of the outer walk where it begins, in quarter turns from the first axis of the frame
  std::size_t inner = 0;      ///< polar: the inner walk of the ring
  int columns = 0, rows = 0;  ///< as planned; with others the holes go to the nearest places
  std::vector<GridHole> holes{};
  /// > 0: so many rows of equal width between the two circles of a ring, as the model asks for; the rest tells nothing.
  int rings = 0;
  bool is_disk = false;  ///< see `fill_disk`; `rows` are its rings
};

/// Fills a cell whose corners turn in quarter turns with a grid (submapping), and puts rings round its round holes; or
/// the ring between two walks that do not turn, in a polar frame; or a disk. Rings that the model asks for get nodes on
/// straight rays from the nodes of the one circle to those of the other.
///
/// Nodes inside come to lie between the nearest ones of curves in their row and column, in the coordinates of the
/// frame.
///
/// @param mesh  nodes and segments of the cell; gets its quads, which may not be sound.
/// @return  false where counts or walks make no grid; `mesh` stays as it is.
/// Cost O(n) for n quads. Source: [Whiteley1996]; transfinite interpolation [Gordon1973].
bool fill_grid(WorkMesh& mesh, const Domain& domain, CellId c, const GridPlan& plan);

}  // namespace quadline
