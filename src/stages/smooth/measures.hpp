#pragma once

#include <algorithm>
#include <cmath>

#include "stages/smooth/stars.hpp"

namespace quadline {

/// A number with the sign of x and the size of its square: sines compare without a root.
inline double signed_square(double x) { return x * std::fabs(x); }

/// What smoothing asks of a quad, from its edges at once; `p` is the corner of the star's node.
struct QuadMeasure {
  QuadMeasure(const Stars& stars, const Spoke& s, Point p) {
    const Point b = stars.point(s.next), c = stars.point(s.opposite), d = stars.point(s.previous);
    const Point pb = b - p, bc = c - b, cd = d - c, dp = p - d;
    edge2[0] = norm2(pb);
    edge2[1] = norm2(bc);
    edge2[2] = norm2(cd);
    edge2[3] = norm2(dp);
    det[0] = cross(dp, pb);
    det[1] = cross(pb, bc);
    det[2] = cross(bc, cd);
    det[3] = cross(cd, dp);
    diagonal2[0] = norm2(c - p);
    diagonal2[1] = norm2(d - b);
  }

  /// Signed square of the least sine of a corner; `scaled_jacobian` of the element, squared.
  double least_sine2() const {
    double least = 1;
    for (int i = 0; i < 4; ++i) {
      const double lengths = edge2[i] * edge2[(i + 3) % 4];
      least = std::min(least, lengths > 0 ? signed_square(det[i]) / lengths : 0.0);
    }
    return least;
  }
  /// [Lee2003 eq 2]; 0 where a corner is not convex.
  double beta() const {
    const double a = det[1] / (edge2[0] + edge2[1] + diagonal2[0]), b = det[3] / (edge2[2] + edge2[3] + diagonal2[0]);
    const double c = det[0] / (edge2[0] + edge2[3] + diagonal2[1]), d = det[2] / (edge2[1] + edge2[2] + diagonal2[1]);
    const double ab_low = std::min(a, b), ab_high = std::max(a, b), cd_low = std::min(c, d), cd_high = std::max(c, d);
    // The two least are the smaller of one pair and either the other of it or the smaller of the other pair.
    double low, high;
    if (ab_high <= cd_low) {
      low = a * b;
      high = c * d;
    } else if (cd_high <= ab_low) {
      low = c * d;
      high = a * b;
    } else {
      low = ab_low * cd_low;
      high = ab_high * cd_high;
    }
    return std::min(ab_low, cd_low) > 0 ? low / high : 0;
  }
  /// Mean over the corners, 1 for a square [Knupp2000]; large where a corner is not convex.
  double inverse_mean_ratio() const {
    double sum = 0;
    for (int i = 0; i < 4; ++i) {
      const double n = edge2[i] + edge2[(i + 3) % 4];
      sum += det[i] > kFlat * n ? n / det[i] : 1 / kFlat;
    }
    return 0.125 * sum;
  }

 private:
  static constexpr double kFlat = 1e-3;
  double edge2[4], det[4], diagonal2[2];
};

/// Signed square of the least sine round star i with its node at p.
inline double worst_sine2(const Stars& stars, std::size_t i, Point p) {
  double least = 1;
  for (const Spoke& s : stars.spokes(i)) least = std::min(least, QuadMeasure(stars, s, p).least_sine2());
  return least;
}

// The steps of smoothing, in their order. `min_move`, in parts of the local size: a node that wants to move less stays.

/// [Lee2003 section 6]: a node goes to the centroid of its neighbours if that improves its elements.
void laplacian(Stars& stars, int passes, double min_move);
/// Minimises the inverse mean ratio of the corners, to the power `power` [Knupp2000]; where a star has a corner that is
/// not convex, a barrier that lets it pass through zero untangles it [Garanzha2021].
/// @param sound  stars whose worst corner has a squared sine above it stay as they are.
void optimize(Stars& stars, int passes, double min_move, int power, double sound);
/// Raises the geometric mean of beta without lowering the worst corner below what it is, or a floor.
void polish(Stars& stars, int passes, double min_move);

}  // namespace quadline
