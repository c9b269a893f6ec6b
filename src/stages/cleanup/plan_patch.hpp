#pragma once

#include <array>
#include <span>
#include <vector>

#include "stages/cleanup/fill_patch.hpp"

namespace quadline::cleanup {

constexpr std::size_t kMostCorners = 5;  ///< of a patch with one irregular node
using Numbers = std::array<int, kMostCorners>;

/// Rows between the irregular node and each of n = 3 or 5 sides, all >= 1; for n = 4 only whether opposite sides are
/// equal. Where the last side is a cut the irregular node may lie on it (no row there).
///
/// @return  false: no such filling.
bool solve_rows(const Numbers& sides, std::size_t n, bool is_cut, Numbers& rows);

/// How a patch is to be filled: whole, or cut in two pieces.
struct PatchPlan {
  int n_irregular = 0;
  double strain = 0;             ///< how far edges are from their target lengths, about; 0 is best
  std::size_t from = 0, to = 0;  ///< ends of the cut, by places on the rim; equal: no cut
  int length = 0;                ///< edges of the cut
};

/// All plans with at most `most_irregular` irregular nodes, the least irregular and least strained first.
std::vector<PatchPlan> plan_patch(std::span<const PatchNode> rim, int most_irregular);

}  // namespace quadline::cleanup
