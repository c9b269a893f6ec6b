#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "domain/domain.hpp"
#include "domain/whole_circle.hpp"
#include "quadline/options.hpp"
#include "stages/grid/fill_grid.hpp"

namespace quadline {

/// An inner walk of a cell.
struct InnerWalk {
  std::size_t walk;
  std::optional<WholeCircle> circle;  ///< what it is, if it is one
};

struct CountWish {
  CurveId curve;
  std::uint32_t count;  ///< edges, > 0
};

/// A grid for a cell, and what its curves need for it.
struct GridProposal {
  /// The ends of the arcs of a whole circle want to lie in this direction from its centre, and opposite to it.
  struct Turn {
    std::size_t walk;
    Point direction;
  };
  GridPlan plan;
  std::vector<CountWish> wishes;  ///< of all curves of the cell
  std::vector<Turn> turns;
};

/// The greatest number of proposals for a cell: they differ in the squares that they leave to holes and in their
/// density.
inline constexpr int kProposals = 3;

/// For a cell whose outer walk turns in quarter turns, with round holes and slots. Rows go through the middles of
/// holes, as many as make the quads that the area asks for. @param variant  0 to `kProposals` - 1.
std::optional<GridProposal> propose_straight(const Domain& domain, CellId c, const std::vector<InnerWalk>& holes,
                                             int variant, const Options& options);

/// What a circle has from the grid outside it.
struct GivenCircle {
  Point start;         ///< where its arcs end: a direction from the centre
  std::uint32_t rays;  ///< nodes on it
};

/// For the ring between two concentric circles, with round holes in it.
/// @param given  of the outer circle, if another grid has it as a hole.
std::optional<GridProposal> propose_ring(const Domain& domain, CellId c, const WholeCircle& outer,
                                         const std::vector<InnerWalk>& holes, int variant,
                                         const std::optional<GivenCircle>& given, const Options& options);

/// For a disk with nothing inside. @param given  of its circle, if another grid has it as a hole.
std::optional<GridProposal> propose_disk(const Domain& domain, CellId c, const WholeCircle& circle,
                                         const std::optional<GivenCircle>& given, const Options& options);

/// Area of a cell over that of a square of its size: how many quads it asks for.
double quads_asked(const Domain& domain, CellId c);

}  // namespace quadline
