#pragma once

#include "stages/smooth/quadratic.hpp"
#include "stages/smooth/star.hpp"

namespace quadline::smoothing {

/// Inverse mean ratio (|u|^2 + |v|^2) / 2 of a corner, times its determinant, with the derivatives of the numerator.
struct CornerShape {
  Corner corner;
  Point grad_n;   ///< of half the sum of the squared sides
  double bend_n;  ///< its second derivative in any direction
  Point grad_det;
};

/// Calls `visit(CornerShape)` for the three corners of a quad that move with its node, which is at the origin.
template <class Visit>
void for_each_corner(const Star::Quad& q, Visit visit) {
  visit(CornerShape{q.corner_p(q.b, q.d), -1.0 * (q.b + q.d), 2, q.grad_det_p()});
  visit(CornerShape{q.corner_b(q.b), -1.0 * q.b, 1, q.grad_det_b()});
  visit(CornerShape{q.corner_d(q.d), -1.0 * q.d, 1, q.grad_det_d()});
}

/// Sum over the corners of the inverse mean ratio [Knupp2000] to a power: 1 for the bulk, more for the worst.
template <int kPower>
class ShapeEnergy {
 public:
  static constexpr bool kGuards = true;

  /// @param below  stars whose least squared sine is above stay as they are.
  explicit ShapeEnergy(double below = HUGE_VAL) : below_(below) {}
  bool takes(double sine2) const { return sine2 > 0 && sine2 < below_; }

  Quadratic derivatives(const Star& star) const {
    Quadratic sum;
    for (const Star::Quad& q : star.quads()) {
      for_each_corner(q, [&](const CornerShape& c) {
        const double inverse = 1 / c.corner.det;
        const double f = 0.5 * (c.corner.u2 + c.corner.v2) * inverse;
        const Point df = inverse * (c.grad_n - f * c.grad_det);
        const double all = power(f), weight = kPower * all / f;
        sum.value += all;
        sum.gradient += weight * df;
        sum.add_identity(weight * inverse * c.bend_n);
        sum.subtract_product(weight * inverse, df, c.grad_det);
        if constexpr (kPower > 1) sum.add_square((kPower - 1) * weight / f, df);
      });
    }
    return sum;
  }
  double value(const Star& star, Point p, double floor2) const {
    double sum = 0;
    for (const Star::Quad& q : star.quads()) {
      const Point pb = q.b - p, pd = q.d - p;
      for (const Corner& c : {q.corner_p(pb, pd), q.corner_b(pb), q.corner_d(pd)}) {
        if (!(c.det > 0) || c.det * c.det < floor2 * (c.u2 * c.v2)) return HUGE_VAL;
        sum += power(0.5 * (c.u2 + c.v2) / c.det);
      }
    }
    return sum;
  }

 private:
  static double power(double f) {
    double product = f;
    for (int k = 1; k < kPower; ++k) product *= f;
    return product;
  }
  double below_;
};

/// The same to the power 1 with the barrier chi(D) = (D + sqrt(epsilon^2 + D^2)) / 2 in the place of determinants D:
/// positive, so that they may climb through zero [Garanzha2021].
class BarrierEnergy {
 public:
  static constexpr bool kGuards = false;

  /// @param epsilon  > 0, in squared target sizes.
  BarrierEnergy(double epsilon, double below) : epsilon2_(epsilon * epsilon), below_(below) {}
  bool takes(double sine2) const { return sine2 < below_; }

  Quadratic derivatives(const Star& star) const {
    Quadratic sum;
    for (const Star::Quad& q : star.quads()) {
      for_each_corner(q, [&](const CornerShape& c) {
        const double root = std::sqrt(epsilon2_ + c.corner.det * c.corner.det);
        const double inverse = 1 / chi(c.corner.det), slope = 1 / (inverse * root);
        const double bend = 0.5 * epsilon2_ / (root * root * root);
        const double f = 0.5 * (c.corner.u2 + c.corner.v2) * inverse;
        const Point g = slope * c.grad_det;
        const Point df = inverse * (c.grad_n - f * g);
        sum.value += f;
        sum.gradient += df;
        sum.add_identity(inverse * c.bend_n);
        sum.subtract_product(inverse, df, g);
        sum.add_square(-f * bend * inverse, c.grad_det);
      });
    }
    return sum;
  }
  double value(const Star& star, Point p, double) const {
    double sum = 0;
    for (const Star::Quad& q : star.quads()) {
      const Point pb = q.b - p, pd = q.d - p;
      for (const Corner& c : {q.corner_p(pb, pd), q.corner_b(pb), q.corner_d(pd)})
        sum += 0.5 * (c.u2 + c.v2) / chi(c.det);
    }
    return sum;
  }

 private:
  // For large negative determinants the sum would cancel.
  double chi(double det) const {
    const double root = std::sqrt(epsilon2_ + det * det);
    return det > 0 ? 0.5 * (det + root) : 0.5 * epsilon2_ / (root - det);
  }
  double epsilon2_, below_;
};

}  // namespace quadline::smoothing
