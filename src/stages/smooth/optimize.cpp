// Node by node, damped Newton on the inverse mean ratio of the corners a node touches [Knupp2000]; determinants are
// linear in the node, so the derivatives are short. Where a corner is not convex its determinant D is replaced by the
// barrier chi(D) = (D + sqrt(e^2 + D^2)) / 2 of [Garanzha2021], which is positive and lets D climb through zero.
#include <cmath>

#include "stages/smooth/measures.hpp"

namespace quadline {

namespace {

constexpr double kFlat = 0.0004;       // squared sine below which a star is treated as tangled
constexpr double kKeepAbove = 0.0625;  // no star falls below it, or below what it was

struct Derivatives {
  double value = 0;
  Point gradient;
  double xx = 0, xy = 0, yy = 0;
};

/// One corner: half the sum of the squared edges over their determinant. `grad_n`, `curvature`: of half the sum.
class Barrier {
 public:
  Barrier(double epsilon, int power) : epsilon2_(epsilon * epsilon), power_(power) {}

  void add(double n, Point grad_n, double curvature, double det, Point grad_d, Derivatives& sum) const {
    const double root = std::sqrt(epsilon2_ + det * det);
    const double chi = 0.5 * (det + root);
    const double slope = root > 0 ? 0.5 * (1 + det / root) : 0.5;
    const double bend = root > 0 ? 0.5 * epsilon2_ / (root * root * root) : 0;
    const double f = n / chi;
    const Point df = (1 / chi) * (grad_n - (f * slope) * grad_d);
    const double hxx = (curvature - 2 * slope * df.x * grad_d.x - f * bend * grad_d.x * grad_d.x) / chi;
    const double hyy = (curvature - 2 * slope * df.y * grad_d.y - f * bend * grad_d.y * grad_d.y) / chi;
    const double hxy = (-slope * (df.x * grad_d.y + df.y * grad_d.x) - f * bend * grad_d.x * grad_d.y) / chi;
    double weight = 1, growth = 0;  // of f^power: first and second derivative
    double value = f;
    for (int k = 1; k < power_; ++k) value *= f;
    if (power_ > 1) {
      weight = power_ * value / f;
      growth = (power_ - 1) * weight / f;
    }
    sum.value += value;
    sum.gradient += weight * df;
    sum.xx += weight * hxx + growth * df.x * df.x;
    sum.xy += weight * hxy + growth * df.x * df.y;
    sum.yy += weight * hyy + growth * df.y * df.y;
  }

 private:
  double epsilon2_;
  int power_;
};

Derivatives energy(const Stars& stars, std::size_t i, Point p, const Barrier& barrier) {
  Derivatives sum;
  for (const Spoke& s : stars.spokes(i)) {
    const Point b = stars.point(s.next), c = stars.point(s.opposite), d = stars.point(s.previous);
    const Point pb = b - p, pd = d - p, bc = c - b, dc = c - d;
    barrier.add(0.5 * (norm2(pb) + norm2(pd)), -1.0 * (pb + pd), 2, cross(pb, pd), left_normal(b - d), sum);
    barrier.add(0.5 * (norm2(bc) + norm2(pb)), -1.0 * pb, 1, cross(bc, -1.0 * pb), left_normal(bc), sum);
    barrier.add(0.5 * (norm2(dc) + norm2(pd)), -1.0 * pd, 1, cross(-1.0 * pd, dc), -1.0 * left_normal(dc), sum);
  }
  return sum;
}

// Newton's step; where the energy is not convex, or the step would not go down, the gradient's.
Point step_of(const Derivatives& e, double longest) {
  const double det = e.xx * e.yy - e.xy * e.xy;
  Point step;
  if (det > 1e-12 * (e.xx * e.xx + e.yy * e.yy) && e.xx > 0) {
    step = {-(e.yy * e.gradient.x - e.xy * e.gradient.y) / det, -(e.xx * e.gradient.y - e.xy * e.gradient.x) / det};
  } else {
    const double length = norm(e.gradient);
    step = length > 0 ? (-0.3 * longest / length) * e.gradient : Point{};
  }
  const double length = norm(step);
  return length > longest ? (longest / length) * step : step;
}

}  // namespace

void optimize(Stars& stars, int passes, double min_move, int power) {
  stars.wake_all();
  for (int pass = 0; pass < passes; ++pass) {
    bool moved = false;
    for (const std::uint32_t i : stars.take_awake()) {
      const Point from = stars.at(i);
      const double h = stars.size(i), before = worst_sine2(stars, i, from);
      const bool tangled = before < kFlat;
      const Barrier barrier(tangled ? 0.2 * h * h : 0, power);
      const Derivatives e = energy(stars, i, from, barrier);
      Point step = step_of(e, 0.5 * h);
      for (int halvings = 0; halvings < 6; ++halvings, step = 0.5 * step) {
        if (norm(step) < min_move * h) break;
        Point p = from + step;
        if (stars.slides(i)) p = stars.slid(i, p).point;
        const double after = worst_sine2(stars, i, p);
        if (!tangled && after < std::fmin(before, kKeepAbove)) continue;
        if (energy(stars, i, p, barrier).value >= e.value) continue;
        if (distance(p, from) < min_move * h) break;
        stars.move(i, p);
        stars.wake(i);
        moved = true;
        break;
      }
    }
    if (!moved) return;
  }
}

}  // namespace quadline
