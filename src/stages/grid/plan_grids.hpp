#pragma once

#include <cstdint>
#include <functional>
#include <optional>

#include "domain/cell_set.hpp"
#include "domain/domain.hpp"
#include "quadline/options.hpp"
#include "stages/grid/propose_grid.hpp"

namespace quadline {

/// Which cells with round holes are to become grids with rings, and what their curves need for it.
struct GridPlans {
  IdVector<CellId, std::optional<GridProposal>> cells;
  IdVector<CurveId, std::uint32_t> counts;  ///< edges wished for; 0: no wish

  /// Takes the plans of cells away, with what they asked of their curves. O(wishes).
  void drop(const CellSet& dropped, Domain& domain);
};

/// Plans grids for cells with round holes: those whose other curves are straight and at right angles, and rings between
/// two concentric circles. In the domain their whole circles are turned, so that the ends of the two arcs lie where the
/// grid wants them, and holes with rings are marked.
///
/// Rings that the model asks for are planned by every method; their circles get the number of edges that the grid round
/// them has there, or what suits their sizes, unless it is given.
///
/// Cells with a line, a point or a neighbour of lesser size get no plan: their grids could not grade. No other
/// cell gets one where a function of place gives sizes, or by other methods than Layout.
/// @param cost  of a proposal in the domain as it is turned for it; infinity: it will not do.
/// @pre  no more quads are expected than Options::max_quads.
/// Cost O(n log n) but for `cost`, which is asked `kProposals` times for each cell.
GridPlans plan_grids(Domain& domain, const Options& options,
                     const std::function<double(const Domain&, CellId, const GridProposal&)>& cost);

}  // namespace quadline
