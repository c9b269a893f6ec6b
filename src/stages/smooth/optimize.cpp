// Node by node, Newton's method on the inverse mean ratio of the corners that a node touches [Knupp2000]. Sampled at
// the corners: inner points let corners fold.
#include "stages/smooth/relax.hpp"
#include "stages/smooth/shape_energy.hpp"
#include "stages/smooth/steps.hpp"

namespace quadline::smoothing {

namespace {

constexpr double kOver = 1.5;
constexpr double kPoor2 = 0.8;  // squared sine below which a star's worst corner is worth a step of its own
constexpr int kWorstPower = 8;

}  // namespace

void optimize(Stars& stars, const SmoothOptions& options, const Progress& progress) {
  stars.wake_all();
  relax(stars, ShapeEnergy<1>(),
        {.passes = options.passes, .min_move = options.min_move, .over = kOver, .floor2 = kFloor2},
        progress.part(0, 0.8));
  stars.wake_all();
  relax(stars, ShapeEnergy<kWorstPower>(kPoor2),
        {.passes = options.passes, .min_move = options.min_move, .floor2 = kFloor2}, progress.part(0.8, 1));
}

}  // namespace quadline::smoothing
