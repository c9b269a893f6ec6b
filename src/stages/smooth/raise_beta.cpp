// Beta is not smooth where a quad is a rectangle, and there its geometric mean wants most quads to be: like a sum of
// absolute values, it rather has some far off than all a little. So a smooth stand-in, with a rounding that shrinks.
#include <iterator>

#include "stages/smooth/beta_energy.hpp"
#include "stages/smooth/relax.hpp"
#include "stages/smooth/steps.hpp"

namespace quadline::smoothing {

namespace {

constexpr double kRoundings[] = {0.3, 0.05};
constexpr double kOver = 1.8;

}  // namespace

void raise_beta(Stars& stars, const SmoothOptions& options, const Progress& progress) {
  double done = 0;
  for (const double rounding : kRoundings) {
    const double next = done + 1.0 / std::size(kRoundings);
    stars.wake_all();
    relax(stars, BetaEnergy(rounding),
          {.passes = options.passes, .min_move = options.min_move, .over = kOver, .floor2 = kFloor2},
          progress.part(done, next));
    done = next;
  }
}

}  // namespace quadline::smoothing
