#include "stages/discretize/intervals.hpp"

#include <algorithm>
#include <cstdint>
#include <vector>

#include "stages/discretize/bays.hpp"
#include "stages/discretize/cell_wishes.hpp"
#include "stages/discretize/count_state.hpp"

namespace quadline {

namespace {

/// A cell with two edges round it could hold no quad: one of its curves gets two more. Where all its curves are even
/// it may be one that is halved, and has half as many edges before.
void fill_smallest_cells(const Domain& domain, const IdVector<CurveId, CountWish>& wishes,
                         IdVector<CurveId, std::uint32_t>& counts) {
  constexpr std::uint32_t kLeastEdges = 4;
  for (const Domain::Cell& cell : domain.cells) {
    std::uint32_t least = 2 * kLeastEdges;
    for (const auto& walk : cell.walks)
      for (const DirectedCurve& d : walk)
        if (!wishes[d.curve].is_even) least = kLeastEdges;
    std::uint32_t sum = 0;
    CurveId best;
    for (const auto& walk : cell.walks)
      for (const DirectedCurve& d : walk) {
        sum += counts[d.curve];
        if (sum >= least) break;
        const auto cost = [&](CurveId c) { return count_cost(wishes[c], counts[c] + 2); };
        if (!best.valid() || cost(d.curve) < cost(best)) best = d.curve;
      }
    for (; sum < least && best.valid(); sum += 2) counts[best] += 2;
  }
}

}  // namespace

IdVector<CurveId, std::uint32_t> choose_counts(const Domain& domain, IdVector<CurveId, CountWish> wishes) {
  for (CountWish& wish : wishes.raw())  // what a line or a gap asks for must hold
    wish.least = std::max(wish.least, static_cast<std::uint32_t>(std::min(wish.length, 1e9) / kMostCoarsened));
  widen_triangles(domain, wishes);
  crowd_polygons(domain, wishes);
  const std::vector<Bay> bays = find_bays(domain, wishes);
  even_out(bays, wishes);
  CountState state(wishes, bays);
  label_counts(domain, state);
  exchange_counts(domain, state);
  IdVector<CurveId, std::uint32_t> counts;
  for (std::size_t i = 0; i < wishes.count(); ++i) counts.push_back(state.count(CurveId(i)));
  fill_smallest_cells(domain, wishes, counts);
  return counts;
}

}  // namespace quadline
