#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "base/csr.hpp"
#include "domain/domain.hpp"
#include "stages/discretize/count_target.hpp"
#include "stages/discretize/submappable_faces.hpp"

namespace quadline {

/// The counts of all curves while they are being chosen, and what they cost: how far they are from the targets, and how
/// far opposite sides of submappable faces are from each other.
class CountState {
 public:
  /// A curve as part of a side of a submappable face.
  struct Part {
    std::uint32_t submap, side;
  };
  struct Change {
    CurveId curve;
    std::uint32_t count;
  };

  CountState(const IdVector<CurveId, CountTarget>& targets, const std::vector<SubmappableFace>& submaps);

  /// Sets all counts.
  void start(IdVector<CurveId, std::uint32_t> counts);

  std::uint32_t count(CurveId c) const { return counts_[c]; }
  const CountTarget& target(CurveId c) const { return targets_[c]; }
  const std::vector<SubmappableFace>& submaps() const { return submaps_; }
  /// What the curve is a part of.
  std::span<const Part> parts(CurveId c) const { return parts_[c.value]; }
  bool is_on_submap(CurveId c) const { return !parts_[c.value].empty(); }

  /// Edges on a side of a submappable face.
  std::int64_t sum(std::uint32_t submap, std::uint32_t side) const { return sums_[submap][side]; }
  /// How many edges opposite sides differ by that should not: over the two pairs, with these sums.
  std::int64_t gap(std::uint32_t submap, const std::array<std::int64_t, 4>& sums) const;
  std::int64_t gap(std::uint32_t submap) const { return gap(submap, sums_[submap]); }
  const std::array<std::int64_t, 4>& sums(std::uint32_t submap) const { return sums_[submap]; }

  /// Makes the changes if that lowers the cost. @pre no curve occurs twice.
  bool try_changes(const std::vector<Change>& changes);

  static constexpr double kGapCost = 0.1;  ///< of one edge of `gap`; as one edge off where four are the target

 private:
  void apply(const std::vector<Change>& changes, bool forward);

  const IdVector<CurveId, CountTarget>& targets_;
  const std::vector<SubmappableFace>& submaps_;
  IdVector<CurveId, std::uint32_t> counts_;
  Rows<Part> parts_;                               ///< per curve
  std::vector<std::array<std::int64_t, 4>> sums_;  ///< per submappable face
  std::vector<std::uint32_t> touched_;             ///< submappable faces of the changes under test
};

/// Counts that are even round every cell, and cheap: a spanning forest of the curves that care most, then flips of one
/// or two labels, and steps of single counts by two, while they gain. Near-linear.
void label_counts(const Domain& domain, CountState& state);

/// Makes submappable faces equal that no small change makes equal, by one edge more or less on all curves that a closed
/// path across the cells crosses. Keeps every cell even. Near-linear.
void balance_intervals(const Domain& domain, CountState& state);

}  // namespace quadline
