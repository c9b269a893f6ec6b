// Pattern search on the mean logarithm of beta. Beta is not smooth where a corner is right, and it does not see
// stretch, so the search is guarded: corners keep their worst, and the inverse mean ratio stands in the objective as a
// ballast.
#include <algorithm>
#include <array>
#include <cmath>

#include "stages/smooth/measures.hpp"

namespace quadline {

namespace {

constexpr double kFloor2 = 0.64;                       // squared sine that a star may fall to, if it was better
constexpr double kBallast = 0.15;                      // weight of the inverse mean ratio
constexpr double kFirstStep = 0.08, kLastStep = 0.01;  // of the local size
constexpr double kPerfect = -0.01 - 1.01 * kBallast;   // worth per quad above which there is nothing to gain
constexpr double kLeastBeta = 1e-6;
constexpr double kLeastGain = 1e-4;  // of the logarithm

// The worth of a place, or -infinity where the worst corner falls below `least2`.
double worth(const Stars& stars, std::size_t i, Point p, double least2) {
  double product = 1, ballast = 0;
  for (const Spoke& s : stars.spokes(i)) {
    const QuadMeasure q(stars, s, p);
    if (q.least_sine2() < least2) return -INFINITY;
    product *= std::max(q.beta(), kLeastBeta);
    ballast += q.inverse_mean_ratio();
  }
  return std::log(product) - kBallast * ballast;
}

}  // namespace

// Each node keeps a step of its own, halved when none of its neighbours' places is better.
void polish(Stars& stars, int passes, double min_move) {
  constexpr std::array<Point, 8> kDirections{
      {{1, 0}, {0, 1}, {-1, 0}, {0, -1}, {0.7, 0.7}, {-0.7, 0.7}, {-0.7, -0.7}, {0.7, -0.7}}};
  std::vector<double> step(stars.count(), kFirstStep);
  const double last_step = std::max(kLastStep, min_move);
  stars.wake_all();
  for (int pass = 0; pass < passes; ++pass) {
    const std::vector<std::uint32_t> awake = stars.take_awake();
    if (awake.empty()) return;
    for (const std::uint32_t i : awake) {
      const Point from = stars.at(i);
      const double reach = step[i] * stars.size(i);
      const double least2 = std::min(kFloor2, worst_sine2(stars, i, from));
      Point best = from;
      const double before = worth(stars, i, from, least2);
      if (before > kPerfect * static_cast<double>(stars.spokes(i).size())) continue;
      double most = before;
      for (const Point d : kDirections) {
        Point p = from + reach * d;
        if (stars.slides(i)) p = stars.slid(i, p).point;
        const double w = worth(stars, i, p, least2);
        if (w <= most) continue;
        most = w;
        best = p;
      }
      if (most > before + kLeastGain) {
        stars.move(i, best);
        stars.wake(i);
      } else if (step[i] > 2 * last_step) {
        step[i] *= 0.5;
        stars.wake_self(i);
      }
    }
  }
}

}  // namespace quadline
