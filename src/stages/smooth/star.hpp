#pragma once

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "stages/smooth/stars.hpp"

namespace quadline::smoothing {

/// A corner of a quad: its determinant (twice the area of its triangle) and the squares of its sides.
struct Corner {
  double det, u2, v2;
  /// Square of the sine, with its sign: sines compare without a root.
  double sine2() const {
    const double sides2 = u2 * v2;
    return sides2 > 0 ? det * std::fabs(det) / sides2 : 0;
  }
};

/// The quads round one node, with the node's place as origin and the target size as unit: energies have no dimension,
/// and what does not change while the node moves is computed once.
class Star {
 public:
  /// The quad p b c d, counter-clockwise; the node is at p.
  struct Quad {
    Point b, c, d;
    Point bc, cd, bd;
    double bc2, cd2, bd2;  ///< squared lengths
    double alpha_c;        ///< distortion coefficient of the triangle b c d, up to a factor

    Corner corner_p(Point pb, Point pd) const { return {cross(pb, pd), norm2(pb), norm2(pd)}; }
    Corner corner_b(Point pb) const { return {cross(pb, bc), norm2(pb), bc2}; }
    Corner corner_d(Point pd) const { return {cross(pd, cd), norm2(pd), cd2}; }
    // Their determinants are linear in p.
    Point grad_det_p() const { return left_normal(bd); }
    Point grad_det_b() const { return left_normal(bc); }
    Point grad_det_d() const { return left_normal(cd); }
  };

  void gather(const Stars& stars, std::size_t i) {
    const Point origin = stars.at(i);
    const double unit = 1 / stars.size(i);
    quads_.clear();
    for (const Spoke& s : stars.spokes(i)) {
      Quad q;
      q.b = unit * (stars.point(s.next) - origin);
      q.c = unit * (stars.point(s.opposite) - origin);
      q.d = unit * (stars.point(s.previous) - origin);
      q.bc = q.c - q.b;
      q.cd = q.d - q.c;
      q.bd = q.d - q.b;
      q.bc2 = norm2(q.bc);
      q.cd2 = norm2(q.cd);
      q.bd2 = norm2(q.bd);
      q.alpha_c = cross(q.bc, q.cd) / (q.bc2 + q.cd2 + q.bd2);
      quads_.push_back(q);
    }
    gather_rows(stars, i, unit);
  }
  std::span<const Quad> quads() const { return quads_; }

  /// Where the node would make two edges equal that follow each other: those that meet at it, or an edge of its own and
  /// the one beyond. The square of the way there is, times the weight, the same for equal ratios of the two.
  struct Row {
    Point place;
    double weight;
    double misses2(Point p) const { return weight * norm2(place - p); }
  };
  std::span<const Row> rows() const { return rows_; }

  /// Signed square of the least sine of the corners that move, with the node at p; those opposite to it do not.
  double least_sine2(Point p) const {
    double least = 1;
    for (const Quad& q : quads_) {
      const Point pb = q.b - p, pd = q.d - p;
      for (const Corner& c : {q.corner_p(pb, pd), q.corner_b(pb), q.corner_d(pd)}) least = std::min(least, c.sine2());
    }
    return least;
  }

  /// The mean of the neighbours by an edge.
  Point centroid() const {
    // Each of them ends one quad and begins the next; on the boundary the two outer ones count once.
    Point sum;
    for (const Quad& q : quads_) sum += q.b + q.d;
    return (0.5 / static_cast<double>(quads_.size())) * sum;
  }

 private:
  void gather_rows(const Stars& stars, std::size_t i, double unit) {
    const Point origin = stars.at(i);
    rows_.clear();
    const auto add_across = [&](Point a, Point b) { rows_.push_back({0.5 * (a + b), 1 / norm2(a - b)}); };
    if (stars.is_regular(i)) {
      add_across(quads_[0].b, quads_[2].b);
      add_across(quads_[1].b, quads_[3].b);
    } else if (stars.slides(i)) {
      const auto& [a, b] = stars.beside(i);
      add_across(unit * (a - origin), unit * (b - origin));
    }
    const std::span<const Spoke> spokes = stars.spokes(i);
    for (std::size_t k = 0; k < spokes.size(); ++k) {
      if (spokes[k].beyond == kNone) continue;
      const Point beyond = unit * (stars.point(spokes[k].beyond) - origin);
      rows_.push_back({2.0 * quads_[k].b - beyond, 0.25 / norm2(beyond)});
    }
  }

  std::vector<Quad> quads_;
  std::vector<Row> rows_;
};

}  // namespace quadline::smoothing
