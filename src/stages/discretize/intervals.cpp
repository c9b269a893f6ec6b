#include "stages/discretize/intervals.hpp"

#include <algorithm>
#include <cstdint>
#include <vector>

#include "stages/discretize/cell_targets.hpp"
#include "stages/discretize/count_state.hpp"
#include "stages/discretize/submappable_faces.hpp"

namespace quadline {

namespace {

std::uint32_t edges_round(const Domain::Cell& cell, const IdVector<CurveId, std::uint32_t>& counts) {
  std::uint32_t sum = 0;
  for (const auto& walk : cell.walks)
    for (const DirectedCurve& d : walk) sum += counts[d.curve];
  return sum;
}

/// A cell with two edges round it could hold no quad: one of its curves gets two more. Where all its curves are halved
/// it may be a cell that is, and has half as many edges before.
void fill_smallest_cells(const Domain& domain, const IdVector<CurveId, CountTarget>& targets,
                         IdVector<CurveId, std::uint32_t>& counts) {
  constexpr std::uint32_t kLeastEdges = 4;
  for (const Domain::Cell& cell : domain.cells) {
    std::uint32_t least = 2 * kLeastEdges;
    for (const auto& walk : cell.walks)
      for (const DirectedCurve& d : walk)
        if (!targets[d.curve].is_halved) least = kLeastEdges;
    if (edges_round(cell, counts) >= least) continue;
    const auto cost = [&](CurveId c) { return count_cost(targets[c], counts[c] + 2); };
    CurveId best;
    for (const auto& walk : cell.walks)
      for (const DirectedCurve& d : walk)
        if (!best.valid() || cost(d.curve) < cost(best)) best = d.curve;
    while (edges_round(cell, counts) < least) {
      counts[best] += 2;
      if (const CurveId twin = targets[best].twin; twin.valid()) counts[twin] = counts[best];
    }
  }
}

/// Twins want the same, the mean of what they want.
void level_twins(IdVector<CurveId, CountTarget>& targets) {
  for (CountTarget& target : targets.raw()) {
    if (!target.twin.valid()) continue;
    CountTarget& twin = targets[target.twin];
    target.length = twin.length = 0.5 * (target.length + twin.length);
    target.least = twin.least = std::max(target.least, twin.least);
  }
}

}  // namespace

IdVector<CurveId, std::uint32_t> choose_counts(const Domain& domain, IdVector<CurveId, CountTarget> targets) {
  for (CountTarget& target : targets.raw())  // what a line or a gap asks for must hold
    target.least = std::max(target.least, static_cast<std::uint32_t>(std::min(target.length, 1e9) / kMostCoarsened));
  widen_triangles(domain, targets);
  crowd_polygons(domain, targets);
  level_twins(targets);
  const std::vector<SubmappableFace> submaps = find_submappable_faces(domain, targets);
  even_out(submaps, targets);
  level_twins(targets);
  CountState state(targets, submaps);
  label_counts(domain, state);
  balance_intervals(domain, state);
  IdVector<CurveId, std::uint32_t> counts;
  for (std::size_t i = 0; i < targets.count(); ++i) counts.push_back(state.count(CurveId(i)));
  fill_smallest_cells(domain, targets, counts);
  return counts;
}

}  // namespace quadline
