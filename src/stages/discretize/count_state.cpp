#include "stages/discretize/count_state.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>

namespace quadline {

namespace {
constexpr double kWishWeight = 400;  // as much for one edge of forty as else for one of two
}

double count_cost(const CountTarget& target, std::uint32_t count) {
  const double n = count, off = n - target.length;
  return (target.is_wished ? kWishWeight : 1) * (off * off) / (n * target.length);
}

std::uint32_t best_count(const CountTarget& target, std::uint32_t parity) {
  const double whole = std::floor(std::min(target.length, 1e9));
  std::uint32_t low = std::max(target.least, static_cast<std::uint32_t>(whole));
  if ((low & 1) != parity) low = low > target.least ? low - 1 : low + 1;
  return count_cost(target, low + 2) < count_cost(target, low) ? low + 2 : low;
}

CountState::CountState(const IdVector<CurveId, CountTarget>& targets, const std::vector<SubmappableFace>& submaps)
    : targets_(targets), submaps_(submaps) {
  parts_.fill(targets.count(), [&](const auto& visit) {
    for (std::uint32_t b = 0; b < submaps.size(); ++b)
      for (std::uint32_t k = 0; k < 4; ++k)
        for (CurveId c : submaps[b].sides[k]) visit(c.value, Part{b, k});
  });
}

void CountState::start(IdVector<CurveId, std::uint32_t> counts) {
  counts_ = std::move(counts);
  sums_.assign(submaps_.size(), {});
  for (std::size_t b = 0; b < submaps_.size(); ++b)
    for (std::size_t k = 0; k < 4; ++k)
      for (CurveId c : submaps_[b].sides[k]) sums_[b][k] += counts_[c];
}

std::int64_t CountState::gap(std::uint32_t submap, const std::array<std::int64_t, 4>& sums) const {
  std::int64_t sum = 0;
  for (std::size_t k = 0; k < 2; ++k)
    if (submaps_[submap].is_close[k]) sum += std::abs(sums[k] - sums[k + 2]);
  return sum;
}

void CountState::apply(const std::vector<Change>& changes, bool forward) {
  for (const Change& change : changes) {
    const std::int64_t step = static_cast<std::int64_t>(change.count) - counts_[change.curve];
    for (const Part& p : parts(change.curve)) sums_[p.submap][p.side] += forward ? step : -step;
  }
}

bool CountState::try_changes(const std::vector<Change>& changes) {
  constexpr double kMinGain = 1e-9;
  double cost = 0;
  touched_.clear();
  for (const Change& change : changes) {
    const CountTarget& target = targets_[change.curve];
    cost += count_cost(target, change.count) - count_cost(target, counts_[change.curve]);
    for (const Part& p : parts(change.curve)) touched_.push_back(p.submap);
  }
  std::sort(touched_.begin(), touched_.end());
  touched_.erase(std::unique(touched_.begin(), touched_.end()), touched_.end());
  std::int64_t wider = 0;
  for (std::uint32_t submap : touched_) wider -= gap(submap);
  apply(changes, true);
  for (std::uint32_t submap : touched_) wider += gap(submap);
  if (cost + kGapCost * static_cast<double>(wider) >= -kMinGain) {
    apply(changes, false);
    return false;
  }
  for (const Change& change : changes) counts_[change.curve] = change.count;
  return true;
}

}  // namespace quadline
