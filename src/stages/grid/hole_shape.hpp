#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "domain/domain.hpp"
#include "quadline/options.hpp"
#include "stages/grid/grid_frame.hpp"
#include "stages/grid/propose_grid.hpp"

namespace quadline {

/// A hole that a grid can go round: a whole circle; a slot, with two half circles; a rectangle with round corners. The
/// straight sides run along the rows and columns.
struct HoleShape {
  std::size_t walk;
  Point center{};
  std::array<double, 2> across{};  ///< width and height, model units
  double radius = 0;               ///< of its arcs
  int arcs = 0;                    ///< 2: whole circle or slot, 4: rectangle
  std::size_t along = 0;           ///< of a slot: its straight sides are along the rows (0), or the columns
  double area = 0;
  double around = 0;        ///< length of the walk
  double asked = 0;         ///< edges round it by the sizes of its curves and of the cells beside them
  std::uint32_t given = 0;  ///< edges that a circle is to have; 0: as it suits

  bool is_circle() const { return across[0] == across[1] && arcs == 2; }
};

/// Edges round a walk by the sizes of its curves and of the cells beside them.
double edges_asked(const Domain& domain, const std::vector<DirectedCurve>& walk);

/// The same where it is finer than the size of a cell beside it; else 0.
double finer_edges(const Domain& domain, CellId c, const std::vector<DirectedCurve>& walk);

/// Empty where the walk is none of these, or is to have a number of edges that no square patch has.
std::optional<HoleShape> shape_of(const Domain& domain, CellId c, const InnerWalk& inner, const GridFrame& frame);

/// The squares that a hole leaves out of a grid, and the edges that make its curves fit.
struct HoleCounts {
  std::array<int, 2> k{};                   ///< columns and rows
  std::array<std::uint32_t, 2> straight{};  ///< on a straight side along the rows, along the columns
  std::uint32_t arc = 0;                    ///< on each arc
  int more_rings = 0;                       ///< than `rings_of` would have by the shape alone: k is given, room is not

  int edges() const { return 2 * (k[0] + k[1]); }
};

/// Its curves ask for so many edges that no grid of size h can be round it: the sizes must grade.
bool is_too_fine(const HoleShape& hole, double h);

/// One column (side 0) or row more, a circle's both, with the edges that this asks for.
/// @pre the number of edges is not given.
void grow(HoleCounts& counts, const HoleShape& hole, std::size_t side);

/// For a grid of size h, with room for rings: more room the greater `variant` is. The corners of the patch come to lie
/// at nodes in the middle of round corners, or alike on both sides of the ends of a slot.
HoleCounts counts_of(const HoleShape& hole, double h, int variant, const Options& options);

/// Rings round a hole: more where it is small in its patch.
int rings_of(const HoleShape& hole, const HoleCounts& counts, double h);

}  // namespace quadline
