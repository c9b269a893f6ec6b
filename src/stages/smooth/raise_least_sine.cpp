// The worst corners directly: a search in eight directions for the place of the greatest least sine, node by node
// [Freitag2000]. That is where two or three corners are equally bad: a kink, so no derivatives. Sines do not see
// stretch, so the shape must not get much worse.
#include "stages/smooth/shape_energy.hpp"
#include "stages/smooth/steps.hpp"
#include "stages/smooth/sweep.hpp"

namespace quadline::smoothing {

namespace {

constexpr double kGain = 1e-4;                         // of the squared sine that is worth a move
constexpr double kMayLose = 1.02;                      // factor on the inverse mean ratios that a move may cost
constexpr double kFirstStep = 0.1, kLastStep = 0.005;  // in target sizes

bool raise_at(Stars& stars, std::size_t i, Star& star) {
  star.gather(stars, i);
  double most = star.least_sine2({});
  if (most <= 0 || most >= kFloor2) return false;
  const Point from = stars.at(i);
  const double h = stars.size(i);
  const ShapeEnergy<1> shape;
  const double most_shape = kMayLose * shape.value(star, {}, 0);
  Point best;
  bool is_better = false;
  for (double step = kFirstStep; step > kLastStep; step *= 0.5) {
    const Point centre = best;
    for (const Point d : kDirections) {
      Point at = centre + step * d;
      if (stars.slides(i)) at = (1 / h) * (stars.slid(i, from + h * at).point - from);
      const double least = star.least_sine2(at);
      if (least < most + kGain || shape.value(star, at, 0) > most_shape) continue;
      most = least;
      best = at;
      is_better = true;
    }
  }
  if (is_better) stars.move(i, from + h * best);
  return is_better;
}

}  // namespace

void raise_least_sine(Stars& stars, const SmoothOptions& options, const Progress& progress) {
  stars.wake_all();
  sweep(stars, options.passes, progress, [&](std::size_t i, Star& star) { return raise_at(stars, i, star); });
}

}  // namespace quadline::smoothing
