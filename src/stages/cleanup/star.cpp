// Newton's step on the inverse mean ratio of a star [Knupp2000] with the area D replaced by chi(D, e) =
// (D + sqrt(D^2 + e^2)) / 2 where a corner is inverted [Garanzha2021]. We differ: e is chosen star by star, and the
// curvature of chi is left out of the Hessian, which keeps it positive definite.
#include "stages/cleanup/star.hpp"

#include <cmath>

namespace quadline::cleanup {

namespace {

constexpr double kFlat = 0.02;      // corner area, relative to the squares of the sides, below which e > 0
constexpr double kSoftening = 0.1;  // e, in the same unit
constexpr int kHalvings = 4;

struct Corner {
  Point u, v;  // towards the next and the previous corner
  double area() const { return cross(u, v); }
  double squares() const { return norm2(u) + norm2(v); }
};

// The three corners of a star quad that move with its node.
struct Corners {
  Corner own, next, previous;
  Corners(Point p, const StarQuad& q)
      : own{q.next - p, q.previous - p},
        next{q.opposite - q.next, p - q.next},
        previous{p - q.previous, q.opposite - q.previous} {}
};

double chi(double area, double e2) { return e2 == 0 ? area : 0.5 * (area + std::sqrt(area * area + e2)); }

double energy(Point p, std::span<const StarQuad> star, double e2) {
  double sum = 0;
  for (const StarQuad& q : star) {
    const Corners c(p, q);
    for (const Corner& corner : {c.own, c.next, c.previous}) {
      const double d = chi(corner.area(), e2);
      if (!(d > 0)) return HUGE_VAL;
      sum += corner.squares() / d;
    }
  }
  return sum;
}

struct Newton {
  Point gradient;
  double xx = 0, xy = 0, yy = 0;

  // Adds squares / chi(area), with the gradients of both in the place of the node.
  void add(const Corner& c, double e2, Point grad_squares, double hess_squares, Point grad_area) {
    const double area = c.area(), d = chi(area, e2);
    const double slope = e2 == 0 ? 1 : 0.5 * (1 + area / std::sqrt(area * area + e2));
    const double r = 1 / d, n = c.squares();
    const Point g = slope * grad_area;
    gradient += r * grad_squares - (n * r * r) * g;
    const double k = 2 * n * r * r * r, m = r * r;
    xx += hess_squares * r - 2 * m * grad_squares.x * g.x + k * g.x * g.x;
    yy += hess_squares * r - 2 * m * grad_squares.y * g.y + k * g.y * g.y;
    xy += k * g.x * g.y - m * (grad_squares.x * g.y + grad_squares.y * g.x);
  }
};

}  // namespace

Point better_place(Point p, std::span<const StarQuad> star) {
  double least = HUGE_VAL, squares = 0;
  for (const StarQuad& q : star) {
    const Corners c(p, q);
    for (const Corner& corner : {c.own, c.next, c.previous}) {
      least = std::fmin(least, corner.area());
      squares += corner.squares();
    }
  }
  const double unit = squares / (6 * static_cast<double>(star.size()));
  const double e = least > kFlat * unit ? 0 : kSoftening * unit, e2 = e * e;

  Newton sum;
  for (const StarQuad& q : star) {
    const Corners c(p, q);
    const Point u = c.own.u, v = c.own.v;
    const Point ahead = q.opposite - q.next, back = q.opposite - q.previous;
    sum.add(c.own, e2, -2.0 * (u + v), 4, {u.y - v.y, v.x - u.x});
    sum.add(c.next, e2, 2.0 * c.next.v, 2, {-ahead.y, ahead.x});
    sum.add(c.previous, e2, 2.0 * c.previous.u, 2, {back.y, -back.x});
  }
  const double det = sum.xx * sum.yy - sum.xy * sum.xy;
  if (!(det > 0)) return p;
  const Point g = sum.gradient;
  const Point step = {-(sum.yy * g.x - sum.xy * g.y) / det, -(sum.xx * g.y - sum.xy * g.x) / det};
  const double before = energy(p, star, e2);
  double t = 1;
  for (int i = 0; i < kHalvings; ++i, t *= 0.5) {
    const Point trial = p + t * step;
    if (energy(trial, star, e2) < before) return trial;
  }
  return p;
}

}  // namespace quadline::cleanup
