#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "domain/domain.hpp"
#include "quadline/context.hpp"
#include "stages/grid/plan_grids.hpp"

namespace quadline {

/// Tries grids that are proposed before curves are asked for the counts that they need.
class Rehearsal {
 public:
  /// @param context  asked whether to stop.
  explicit Rehearsal(const Context& context) { quiet_.is_cancelled = context.is_cancelled; }

  /// What a grid is worth, with the nodes on its curves as it wishes them and the cell's size everywhere: its cost in
  /// the measure of `cell_cost` for each quad, infinity where the cell would not keep it. Of proposals that are the
  /// same but for a shift or a turn one is tried.
  /// @throws Cancelled when the context asks for it.
  /// Cost O(n log n) for n quads.
  double cost(const Domain& domain, CellId c, const GridProposal& proposal);

 private:
  Context quiet_;  ///< it reports nothing
  std::map<std::vector<std::int64_t>, double> known_;
};

}  // namespace quadline
