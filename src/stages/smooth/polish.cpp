// Pattern search on the mean logarithm of beta. Beta is not smooth where a corner is right, and it does not see
// stretch, so the search is guarded: corners keep their worst, and the inverse mean ratio stands in the objective as a
// ballast.
#include <algorithm>
#include <array>
#include <cmath>

#include "stages/smooth/measures.hpp"

namespace quadline {

namespace {

constexpr double kFloor = 0.8;                         // scaled Jacobian that a star may fall to, if it was better
constexpr double kBallast = 0.15;                      // weight of the inverse mean ratio
constexpr double kFirstStep = 0.08, kLastStep = 0.01;  // of the local size
constexpr double kBadBeta = 1e-6;

// The worth of a place, or -infinity where the worst corner falls below `least`.
double worth(const Stars& stars, std::size_t i, Point p, double least) {
  double sum = 0;
  for (const Spoke& s : stars.spokes(i)) {
    const QuadPoints q = quad_of(stars, s, p);
    if (scaled_jacobian(q) < least) return -INFINITY;
    sum += std::log(std::fmax(quad_distortion(q), kBadBeta)) - kBallast * std::fmin(inverse_mean_ratio(q), 100);
  }
  return sum;
}

}  // namespace

void polish(Stars& stars, int passes, double min_move) {
  constexpr std::array<Point, 8> kDirections{
      {{1, 0}, {0, 1}, {-1, 0}, {0, -1}, {0.7, 0.7}, {-0.7, 0.7}, {-0.7, -0.7}, {0.7, -0.7}}};
  stars.wake_all();
  for (int pass = 0; pass < passes; ++pass) {
    bool moved = false;
    for (const std::uint32_t i : stars.take_awake()) {
      const Point from = stars.at(i);
      const double h = stars.size(i);
      const double least = std::fmin(kFloor, worst_jacobian(stars, i, from));
      Point best = from;
      double most = worth(stars, i, from, least);
      for (double step = kFirstStep * h; step > kLastStep * h; step *= 0.5) {
        const Point centre = best;
        for (const Point d : kDirections) {
          Point p = centre + step * d;
          if (stars.slides(i)) p = stars.slid(i, p).point;
          const double w = worth(stars, i, p, least);
          if (w > most + 1e-9) {
            most = w;
            best = p;
          }
        }
      }
      if (distance(best, from) < min_move * h) continue;
      stars.move(i, best);
      stars.wake(i);
      moved = true;
    }
    if (!moved) return;
  }
}

}  // namespace quadline
