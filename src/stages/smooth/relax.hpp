#pragma once

#include "stages/smooth/quadratic.hpp"
#include "stages/smooth/sweep.hpp"

namespace quadline::smoothing {

/// How nodes are taken to the minimum of an energy.
struct Sweeps {
  int passes = 0;
  double min_move = 0;   ///< a node that wants to move less stays; in target sizes
  double over = 1;       ///< over-relaxation, 1..2: steps are so much longer than Newton's
  double longest = 0.3;  ///< step, in target sizes
  double floor2 = 0;     ///< no star's least squared sine falls below it, or below what it was
};

/// A node's move that its energy allows; false: none.
template <class Energy>
bool relax_node(Stars& stars, std::size_t i, Star& star, const Energy& energy, const Sweeps& sweeps) {
  constexpr int kHalvings = 4;
  constexpr double kRounding = 1 - 1e-12;  // or a star at its floor could not slide along it
  star.gather(stars, i);
  const double before = star.least_sine2({});
  if (!energy.takes(before)) return false;
  const Quadratic here = energy.derivatives(star);
  const bool slides = stars.slides(i);
  Point step = sweeps.over * (slides ? here.step_along(stars.tangent(i), sweeps.longest) : here.step(sweeps.longest));
  const double way = norm(step);
  if (!(way > sweeps.min_move)) return false;
  if (way > sweeps.longest) step = (sweeps.longest / way) * step;
  const double floor2 = Energy::kGuards ? kRounding * std::fmin(sweeps.floor2, before) : -HUGE_VAL;
  const Point from = stars.at(i);
  const double h = stars.size(i);
  for (int halving = 0; halving < kHalvings; ++halving, step = 0.5 * step) {
    Point to = from + h * step, at = step;
    if (slides) {
      to = stars.slid(i, to).point;
      at = (1 / h) * (to - from);
    }
    if (norm2(at) < sweeps.min_move * sweeps.min_move) return false;
    if (energy.value(star, at, floor2) < here.value) {
      stars.move(i, to);
      return true;
    }
  }
  return false;
}

/// Newton's method with halved steps on one star after the other, in order: those awake, and those near a move.
///
/// An `Energy` has
/// - `takes(sine2)`: whether a star whose least squared sine is that takes part;
/// - `derivatives(star)`: the energy near the origin;
/// - `value(star, p, floor2)`: infinite where a squared sine is below `floor2`, which is asked for if it has `kGuards`.
template <class Energy>
void relax(Stars& stars, const Energy& energy, const Sweeps& sweeps, const Progress& progress) {
  sweep(stars, sweeps.passes, progress,
        [&](std::size_t i, Star& star) { return relax_node(stars, i, star, energy, sweeps); });
}

}  // namespace quadline::smoothing
