#include "stages/discretize/intervals.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "stages/discretize/bays.hpp"
#include "stages/discretize/labels.hpp"

namespace quadline {

double count_cost(const CountWish& wish, std::uint32_t count) {
  const double n = count, off = n - wish.length;
  return off * off / (n * wish.length);
}

std::uint32_t best_count(const CountWish& wish, std::uint32_t parity) {
  const double whole = std::floor(std::min(wish.length, 1e9));
  std::uint32_t low = std::max(wish.least, static_cast<std::uint32_t>(whole));
  if ((low & 1) != parity) low = low > wish.least ? low - 1 : low + 1;
  return count_cost(wish, low + 2) < count_cost(wish, low) ? low + 2 : low;
}

namespace {

/// A cell with two edges round it could hold no quad: one of its curves gets two more.
void fill_smallest_cells(const Domain& domain, const IdVector<CurveId, CountWish>& wishes,
                         IdVector<CurveId, std::uint32_t>& counts) {
  constexpr std::uint32_t kLeastEdges = 4;
  for (const Domain::Cell& cell : domain.cells) {
    std::uint32_t sum = 0;
    CurveId best;
    for (const auto& walk : cell.walks)
      for (const DirectedCurve& d : walk) {
        sum += counts[d.curve];
        if (sum >= kLeastEdges) break;
        const auto cost = [&](CurveId c) { return count_cost(wishes[c], counts[c] + 2); };
        if (!best.valid() || cost(d.curve) < cost(best)) best = d.curve;
      }
    if (sum < kLeastEdges && best.valid()) counts[best] += 2;
  }
}

}  // namespace

IdVector<CurveId, std::uint32_t> choose_counts(const Domain& domain, IdVector<CurveId, CountWish> wishes) {
  const std::vector<Bay> bays = find_bays(domain, wishes);
  even_out(bays, wishes);
  LabelledCounts labelled(domain, wishes, bays);
  labelled.choose();
  IdVector<CurveId, std::uint32_t> counts;
  for (std::size_t i = 0; i < wishes.count(); ++i) counts.push_back(labelled.count(CurveId(i)));
  fill_smallest_cells(domain, wishes, counts);
  return counts;
}

}  // namespace quadline
