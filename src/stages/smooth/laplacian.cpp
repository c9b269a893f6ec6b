// Constrained Laplacian smoothing [Lee2003 section 6]. We differ: "improves" means the least scaled Jacobian round the
// node does not fall; a refused move is halved twice; only nodes near a change are looked at again.
#include "stages/smooth/measures.hpp"

namespace quadline {

namespace {

constexpr double kSound = 0.81;  // squared sine above which a star need not improve

Point centroid(const Stars& stars, std::size_t i) {
  // Each neighbour by an edge ends one quad and begins the next; on the boundary the two outer ones count once.
  Point sum;
  double n = 0;
  for (const Spoke& s : stars.spokes(i)) {
    sum += stars.point(s.next) + stars.point(s.previous);
    n += 2;
  }
  return (1 / n) * sum;
}

}  // namespace

void laplacian(Stars& stars, int passes, double min_move) {
  stars.wake_all();
  for (int pass = 0; pass < passes; ++pass) {
    bool moved = false;
    for (const std::uint32_t i : stars.take_awake()) {
      const Point from = stars.at(i);
      const double before = worst_sine2(stars, i, from);
      const Point wanted = centroid(stars, i);
      double part = 1;
      for (int halvings = 0; halvings < 3; ++halvings, part *= 0.5) {
        Point p = from + part * (wanted - from);
        if (stars.slides(i)) p = stars.slid(i, p).point;
        const double after = worst_sine2(stars, i, p);
        if (after < before && after < kSound) continue;
        if (distance(p, from) > min_move * stars.size(i)) {
          stars.move(i, p);
          stars.wake(i);
          moved = true;
        }
        break;
      }
    }
    if (!moved) return;
  }
}

}  // namespace quadline
