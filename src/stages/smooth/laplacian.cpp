// Constrained Laplacian smoothing [Lee2003 section 6]. We differ: "improves" means that the least scaled Jacobian round
// the node does not fall, or stays high; a refused move is halved twice; only nodes near a change are looked at again.
#include "stages/smooth/steps.hpp"
#include "stages/smooth/sweep.hpp"

namespace quadline::smoothing {

namespace {

constexpr int kTries = 3;
constexpr double kSound2 = 0.81;  // squared sine above which a star need not improve

bool centre_node(Stars& stars, std::size_t i, Star& star, double min_move) {
  star.gather(stars, i);
  const double h = stars.size(i), before = star.least_sine2({});
  const Point from = stars.at(i);
  Point step = star.centroid();
  for (int n = 0; n < kTries; ++n, step = 0.5 * step) {
    Point to = from + h * step, at = step;
    if (stars.slides(i)) {
      to = stars.slid(i, to).point;
      at = (1 / h) * (to - from);
    }
    if (norm2(at) < min_move * min_move) return false;
    const double after = star.least_sine2(at);
    if (after < before && after < kSound2) continue;
    stars.move(i, to);
    return true;
  }
  return false;
}

}  // namespace

void laplacian(Stars& stars, const SmoothOptions& options, const Progress& progress) {
  stars.wake_all();
  sweep(stars, options.passes, progress,
        [&](std::size_t i, Star& star) { return centre_node(stars, i, star, options.min_move); });
}

}  // namespace quadline::smoothing
