#pragma once

#include "stages/smooth/quadratic.hpp"
#include "stages/smooth/shape_energy.hpp"
#include "stages/smooth/star.hpp"

namespace quadline::smoothing {

/// Sum over the quads of a smooth stand-in for -ln(beta) [Lee2003 eq 2], with terms that keep shape, size and even
/// rows.
///
/// With L the logarithms of the four triangle coefficients alpha of a quad, -ln(beta) is the greatest of |x1|, |x2|,
/// |x3|, the differences between two of the L and the other two. In its place stands sqrt(y + epsilon^2), where y is
/// the sum of (2 sinh(x / 2))^2 over the three: about their Euclidean length, without logarithms and without kinks. The
/// Hessian is that of the reweighted least squares, which is positive and bounds the energy from above.
class BetaEnergy {
 public:
  static constexpr bool kGuards = true;

  /// @param epsilon  rounds the kink where a quad is a rectangle, > 0.
  explicit BetaEnergy(double epsilon) : epsilon2_(epsilon * epsilon) {}
  bool takes(double sine2) const { return sine2 > 0; }

  Quadratic derivatives(const Star& star) const;
  double value(const Star& star, Point at, double floor2) const;

 private:
  double epsilon2_;
};

}  // namespace quadline::smoothing
