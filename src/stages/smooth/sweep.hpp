#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "stages/smooth/progress.hpp"
#include "stages/smooth/star.hpp"

namespace quadline::smoothing {

/// Where a search without derivatives looks, about as far in all directions; short of unit length on the diagonals,
/// which need not be exact.
inline constexpr std::array<Point, 8> kDirections{
    {{1, 0}, {0, 1}, {-1, 0}, {0, -1}, {0.7, 0.7}, {-0.7, 0.7}, {-0.7, -0.7}, {0.7, -0.7}}};

/// Takes the stars that are awake in their order, sweep after sweep; a star that moved wakes those near it for the
/// next. Ends early where nothing moves.
/// @param sweeps   at most.
/// @param improve  `improve(i, star)` moves node i if that pays, and says whether it did; `star` is for it to gather.
template <class Improve>
void sweep(Stars& stars, int sweeps, const Progress& progress, const Improve& improve) {
  Star star;
  for (int n = 0; n < sweeps; ++n) {
    progress.report(static_cast<double>(n) / sweeps);
    bool moved = false;
    for (const std::uint32_t i : stars.take_awake()) {
      if (!improve(i, star)) continue;
      stars.wake_around(i);
      moved = true;
    }
    if (!moved) return;
  }
}

}  // namespace quadline::smoothing
