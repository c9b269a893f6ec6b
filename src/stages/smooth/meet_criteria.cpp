// The caller's limits, by a direct search: a node of a quad that fails them goes where the quads round it are beyond
// them by the least. Their sum lets a node trade one quad for another; that it must fall by a part ends the search.
#include "quality/criteria_values.hpp"
#include "stages/smooth/steps.hpp"
#include "stages/smooth/sweep.hpp"

namespace quadline::smoothing {

namespace {

constexpr double kGain = 0.98;                         // factor on the excess that a move must reach
constexpr int kSweeps = 4;                             // for each pass asked for: few nodes take part
constexpr double kFirstStep = 0.2, kLastStep = 0.005;  // in target sizes

double excess(const Stars& stars, std::size_t i, Point at, const Criteria& criteria) {
  double sum = 0;
  for (const Spoke& s : stars.spokes(i))
    sum += criteria_excess(criteria, {at, stars.point(s.next), stars.point(s.opposite), stars.point(s.previous)},
                           stars.size(i));
  return sum;
}

bool meet_at(Stars& stars, std::size_t i, Star& star, const Criteria& criteria) {
  const Point from = stars.at(i);
  double least = excess(stars, i, from, criteria);
  if (least <= 0) return false;
  star.gather(stars, i);
  const double floor2 = std::fmin(kFloor2, star.least_sine2({}));
  const double h = stars.size(i);
  Point best = from;
  for (double step = kFirstStep; step > kLastStep && least > 0; step *= 0.5) {
    const Point centre = best;
    for (const Point d : kDirections) {
      Point at = centre + (step * h) * d;
      if (stars.slides(i)) at = stars.slid(i, at).point;
      if (star.least_sine2((1 / h) * (at - from)) < floor2) continue;
      const double now = excess(stars, i, at, criteria);
      if (!(now < kGain * least)) continue;
      least = now;
      best = at;
    }
  }
  if (best == from) return false;
  stars.move(i, best);
  return true;
}

}  // namespace

void meet_criteria(Stars& stars, const SmoothOptions& options, const Progress& progress) {
  stars.wake_all();
  sweep(stars, kSweeps * options.passes, progress,
        [&](std::size_t i, Star& star) { return meet_at(stars, i, star, *options.criteria); });
}

}  // namespace quadline::smoothing
