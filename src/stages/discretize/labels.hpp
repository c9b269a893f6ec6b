#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "domain/domain.hpp"
#include "stages/discretize/bays.hpp"
#include "stages/discretize/count_wish.hpp"

namespace quadline {

/// Counts of the curves, even round every cell: vertices have labels 0 or 1, and the count of a curve is odd exactly
/// where those of its ends differ.
///
/// Every cell is even then, whatever the labels. What they cost: how far the counts are from the wishes, and how far
/// opposite sides of bays are from each other.
class LabelledCounts {
 public:
  LabelledCounts(const Domain& domain, const IdVector<CurveId, CountWish>& wishes, const std::vector<Bay>& bays);

  /// Looks for labels of low cost: a spanning forest of the curves that care most, then flips of one or two labels, and
  /// steps of single counts by two, while they gain. Near-linear.
  void choose();

  std::uint32_t count(CurveId c) const { return counts_[c]; }

 private:
  /// A curve as part of a side of a bay.
  struct Part {
    std::uint32_t bay, side;
  };
  /// Rows of varying length.
  template <class T>
  struct Rows {
    std::vector<std::uint32_t> start;
    std::vector<T> items;
  };
  struct Change {
    CurveId curve;
    std::uint32_t count;
  };

  void index(const std::vector<Bay>& bays);
  void span_forest();
  std::uint32_t find(std::uint32_t i);
  std::uint32_t best(CurveId c, std::uint32_t parity) const { return best_counts_[c][parity]; }
  double gap(std::uint32_t bay) const;
  void gather_flip(VertexId v, VertexId but);
  double cost_of_changes();
  void apply_changes();
  bool flip(VertexId u, VertexId v);
  bool flip_all();
  bool step_all();

  const Domain& domain_;
  const IdVector<CurveId, CountWish>& wishes_;
  const std::vector<Bay>& bays_;
  IdVector<CurveId, std::array<std::uint32_t, 2>> best_counts_;  ///< even, odd
  IdVector<CurveId, std::uint32_t> counts_;
  Rows<CurveId> curves_at_;  ///< per vertex
  Rows<Part> parts_of_;      ///< per curve
  std::vector<std::array<std::int64_t, 4>> sums_;  ///< per bay: count of each side
  std::vector<Change> changes_;                    ///< of the move under test
  std::vector<std::uint32_t> touched_;             ///< bays of the move under test
  std::vector<std::uint32_t> root_;
  std::vector<std::uint8_t> offset_;
};

}  // namespace quadline
