// Node by node, damped Newton on the inverse mean ratio of the corners a node touches [Knupp2000]; determinants are
// linear in the node, so the derivatives are short. Where a corner is not convex its determinant D is replaced by the
// barrier chi(D) = (D + sqrt(e^2 + D^2)) / 2 of [Garanzha2021], which is positive and lets D climb through zero.
#include <algorithm>
#include <cmath>

#include "stages/smooth/measures.hpp"

namespace quadline {

namespace {

constexpr double kBarrier = 0.2;       // epsilon, in parts of the squared local size
constexpr double kFlat = 0.0004;       // squared sine below which a star is treated as tangled
constexpr double kKeepAbove = 0.0625;  // no star falls below it, or below what it was

struct Derivatives {
  double value = 0;
  Point gradient;
  double xx = 0, xy = 0, yy = 0;
};

/// What one corner adds: f = n / chi(det), to a power; n is half the sum of the squared edges. `Tangled`: with the
/// barrier.
template <bool Tangled>
class Corners {
 public:
  Corners(double epsilon, int power) : epsilon2_(epsilon * epsilon), power_(power) {}

  Derivatives energy(const Stars& stars, std::size_t i, Point p) const {
    Derivatives sum;
    for (const Spoke& s : stars.spokes(i)) {
      const Point b = stars.point(s.next), c = stars.point(s.opposite), d = stars.point(s.previous);
      const Point pb = b - p, pd = d - p, bc = c - b, dc = c - d;
      add(0.5 * (norm2(pb) + norm2(pd)), -1.0 * (pb + pd), 2, cross(pb, pd), left_normal(b - d), sum);
      add(0.5 * (norm2(bc) + norm2(pb)), -1.0 * pb, 1, cross(bc, -1.0 * pb), left_normal(bc), sum);
      add(0.5 * (norm2(dc) + norm2(pd)), -1.0 * pd, 1, cross(-1.0 * pd, dc), -1.0 * left_normal(dc), sum);
    }
    return sum;
  }

  /// The same without derivatives; infinity where a corner is not convex and there is no barrier.
  double value(const Stars& stars, std::size_t i, Point p) const {
    double sum = 0;
    for (const Spoke& s : stars.spokes(i)) {
      const Point b = stars.point(s.next), c = stars.point(s.opposite), d = stars.point(s.previous);
      const Point pb = b - p, pd = d - p, bc = c - b, dc = c - d;
      sum += power_of(0.5 * (norm2(pb) + norm2(pd)) / chi(cross(pb, pd)));
      sum += power_of(0.5 * (norm2(bc) + norm2(pb)) / chi(cross(pb, bc)));
      sum += power_of(0.5 * (norm2(dc) + norm2(pd)) / chi(cross(dc, pd)));
    }
    return sum;
  }

 private:
  double chi(double det) const {
    if constexpr (Tangled) return 0.5 * (det + std::sqrt(epsilon2_ + det * det));
    return det > 0 ? det : 0;  // 1 / 0: infinitely bad
  }
  double power_of(double f) const { return power_ == 1 ? f : f * f * f; }

  // grad_n, curvature: gradient and second derivative (the same in x and y) of n; the determinant is linear.
  void add(double n, Point grad_n, double curvature, double det, Point grad_d, Derivatives& sum) const {
    double slope = 1, bend = 0;
    if constexpr (Tangled) {
      const double root = std::sqrt(epsilon2_ + det * det);
      slope = 0.5 * (1 + det / root);
      bend = 0.5 * epsilon2_ / (root * root * root);
    }
    const double over = 1 / chi(det), f = n * over;
    const Point df = over * (grad_n - (f * slope) * grad_d);
    const double hxx = (curvature - 2 * slope * df.x * grad_d.x - f * bend * grad_d.x * grad_d.x) * over;
    const double hyy = (curvature - 2 * slope * df.y * grad_d.y - f * bend * grad_d.y * grad_d.y) * over;
    const double hxy = (-slope * (df.x * grad_d.y + df.y * grad_d.x) - f * bend * grad_d.x * grad_d.y) * over;
    const double weight = power_ == 1 ? 1 : 3 * f * f, growth = power_ == 1 ? 0 : 6 * f;  // derivatives of f^power
    sum.value += power_of(f);
    sum.gradient += weight * df;
    sum.xx += weight * hxx + growth * df.x * df.x;
    sum.xy += weight * hxy + growth * df.x * df.y;
    sum.yy += weight * hyy + growth * df.y * df.y;
  }

  double epsilon2_;
  int power_;
};

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

// Moves one node; true where it moved.
template <bool Tangled>
bool improve(Stars& stars, std::size_t i, double before, double min_move, int power) {
  const Point from = stars.at(i);
  const double h = stars.size(i);
  const Corners<Tangled> corners(kBarrier * h * h, power);
  const Derivatives e = corners.energy(stars, i, from);
  Point step = step_of(e, 0.5 * h);
  for (int halvings = 0; halvings < 6; ++halvings, step = 0.5 * step) {
    if (norm2(step) < min_move * min_move * h * h) return false;
    Point p = from + step;
    if (stars.slides(i)) p = stars.slid(i, p).point;
    if (corners.value(stars, i, p) >= e.value) continue;
    if (!Tangled && worst_sine2(stars, i, p) < std::min(before, kKeepAbove)) continue;
    if (norm2(p - from) < min_move * min_move * h * h) return false;
    stars.move(i, p);
    stars.wake(i);
    return true;
  }
  return false;
}

}  // namespace

void optimize(Stars& stars, int passes, double min_move, int power, double sound) {
  stars.wake_all();
  for (int pass = 0; pass < passes; ++pass) {
    bool moved = false;
    for (const std::uint32_t i : stars.take_awake()) {
      const double before = worst_sine2(stars, i, stars.at(i));
      if (before > sound) continue;
      moved |= before < kFlat ? improve<true>(stars, i, before, min_move, power)
                              : improve<false>(stars, i, before, min_move, power);
    }
    if (!moved) return;
  }
}

}  // namespace quadline
