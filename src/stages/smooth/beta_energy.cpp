#include "stages/smooth/beta_energy.hpp"

#include <algorithm>
#include <cmath>

namespace quadline::smoothing {

namespace {

// Weights beside the stand-in: of its square, for the worst quads; of the inverse mean ratio of each corner, and of
// (n + 1/n) / 2 of each edge with n its squared length over the target's, as beta does not see stretch; of rows, whose
// edges it does not see to be uneven.
constexpr double kSquare = 0.5, kShape = 0.1, kSize = 0.06, kRows = 20;
constexpr double kFlat = 1e-6;  // a quad whose opposite corner is flat has no beta to raise

// exp(x) and exp(-x) of the three differences.
struct Differences {
  double p1, q1, p2, q2, p3, q3;
  Differences(double ap, double ab, double ad, double ac) {
    const double pc = ap * ac, bd = ab * ad, pb = ap * ab, cd = ac * ad, pd = ap * ad, bc = ab * ac;
    const double scale = 1 / (pc * bd);
    p1 = pc * pc * scale;
    q1 = bd * bd * scale;
    p2 = pb * pb * scale;
    q2 = cd * cd * scale;
    p3 = pd * pd * scale;
    q3 = bc * bc * scale;
  }
  double sum() const { return std::max(p1 + q1 + p2 + q2 + p3 + q3 - 6, 0.0); }
};

void add_beta(const Star::Quad& q, double epsilon2, Quadratic& sum) {
  const Corner p = q.corner_p(q.b, q.d), b = q.corner_b(q.b), d = q.corner_d(q.d);
  const double pc2 = norm2(q.c);
  const double p_edges = 1 / (p.u2 + p.v2 + q.bd2), b_edges = 1 / (p.u2 + q.bc2 + pc2),
               d_edges = 1 / (p.v2 + q.cd2 + pc2);
  const Differences x(p.det * p_edges, b.det * b_edges, d.det * d_edges, q.alpha_c);
  // Gradients of the logarithms of alpha.
  const Point lp = (1 / p.det) * q.grad_det_p() + (2 * p_edges) * (q.b + q.d);
  const Point lb = (1 / b.det) * q.grad_det_b() + (2 * b_edges) * (q.b + q.c);
  const Point ld = (1 / d.det) * q.grad_det_d() + (2 * d_edges) * (q.c + q.d);
  const Point x1 = lp - lb - ld, x2 = lp + lb - ld, x3 = lp + ld - lb;
  const double y = x.sum(), root = std::sqrt(y + epsilon2), weight = 0.5 / root + kSquare;
  sum.value += root + kSquare * y;
  sum.gradient += weight * ((x.p1 - x.q1) * x1 + (x.p2 - x.q2) * x2 + (x.p3 - x.q3) * x3);
  sum.add_square(weight * (x.p1 + x.q1), x1);
  sum.add_square(weight * (x.p2 + x.q2), x2);
  sum.add_square(weight * (x.p3 + x.q3), x3);
}

void add_shape(const Star::Quad& q, Quadratic& sum) {
  for_each_corner(q, [&](const CornerShape& c) {
    const double inverse = 1 / c.corner.det, f = 0.5 * (c.corner.u2 + c.corner.v2) * inverse;
    const Point df = inverse * (c.grad_n - f * c.grad_det);
    sum.value += kShape * f;
    sum.gradient += kShape * df;
    sum.add_identity(kShape * inverse * c.bend_n);
    sum.subtract_product(kShape * inverse, df, c.grad_det);
  });
}

void add_size(Point edge, Quadratic& sum) {
  const double n = norm2(edge), inverse = 1 / n, weight = kSize * (1 - inverse * inverse);
  sum.value += kSize * (n + inverse);
  sum.gradient += (-2 * weight) * edge;
  sum.add_identity(2 * std::max(weight, 0.0));
  sum.add_square(8 * kSize * inverse * inverse * inverse, edge);
}

}  // namespace

Quadratic BetaEnergy::derivatives(const Star& star) const {
  Quadratic sum;
  for (const Star::Quad& q : star.quads()) {
    if (q.alpha_c > kFlat) add_beta(q, epsilon2_, sum);
    add_shape(q, sum);
    add_size(q.b, sum);
    add_size(q.d, sum);
  }
  for (const Star::Row& row : star.rows()) {
    sum.value += kRows * row.misses2({});
    sum.gradient += (-2 * kRows * row.weight) * row.place;
    sum.add_identity(2 * kRows * row.weight);
  }
  return sum;
}

double BetaEnergy::value(const Star& star, Point at, double floor2) const {
  double sum = 0;
  for (const Star::Quad& q : star.quads()) {
    const Point pb = q.b - at, pd = q.d - at;
    const Corner p = q.corner_p(pb, pd), b = q.corner_b(pb), d = q.corner_d(pd);
    for (const Corner& c : {p, b, d})
      if (!(c.det > 0) || c.det * c.det < floor2 * (c.u2 * c.v2)) return HUGE_VAL;
    if (q.alpha_c > kFlat) {
      const double pc2 = norm2(q.c - at);
      const double y = Differences(p.det / (p.u2 + p.v2 + q.bd2), b.det / (p.u2 + q.bc2 + pc2),
                                   d.det / (p.v2 + q.cd2 + pc2), q.alpha_c)
                           .sum();
      sum += std::sqrt(y + epsilon2_) + kSquare * y;
    }
    sum += 0.5 * kShape * ((p.u2 + p.v2) / p.det + (b.u2 + b.v2) / b.det + (d.u2 + d.v2) / d.det);
    sum += kSize * (p.u2 + 1 / p.u2 + p.v2 + 1 / p.v2);
  }
  for (const Star::Row& row : star.rows()) sum += kRows * row.misses2(at);
  return sum;
}

}  // namespace quadline::smoothing
