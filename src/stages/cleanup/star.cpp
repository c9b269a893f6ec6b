// Newton's step on the inverse mean ratio of a star [Knupp2000] with the area D replaced by chi(D, e) =
// (D + sqrt(D^2 + e^2)) / 2 where a corner is inverted [Garanzha2021]. We differ: e is chosen star by star, and the
// curvature of chi is left out of the Hessian, which keeps it positive definite; a term keeps edges near their size.
#include "stages/cleanup/star.hpp"

#include <algorithm>
#include <cmath>

#include "base/constants.hpp"

namespace quadline::cleanup {

namespace {

constexpr double kFlat = 0.02;       // corner area, relative to the squares of the sides, below which e > 0
constexpr double kSoftening = 0.1;   // e, in the same unit
constexpr double kSmallStep = 1e-8;  // squared, in the same unit: not worth while
constexpr int kHalvings = 4;
constexpr double kSize = 0.3;   // of the stretch of an edge, beside 1 for the shape of a corner
constexpr double kOffSize = 6;  // squared edges so many times off: the geometry rules there, not the size

// chi and its slope in the place of the area; plain areas where nothing is near flat.
struct Plain {
  double chi(double area) const { return area; }
  double slope(double) const { return 1; }
};
struct Soft {
  double e2;
  double chi(double area) const { return 0.5 * (area + std::sqrt(area * area + e2)); }
  double slope(double area) const { return 0.5 * (1 + area / std::sqrt(area * area + e2)); }
};

// The three corners of a star quad that move with its node: edge vectors towards the next and the previous corner.
struct Corner {
  Point u, v;
  double area() const { return cross(u, v); }
  double squares() const { return norm2(u) + norm2(v); }
};
struct Corners {
  Corner own, next, previous;
  Corners(Point p, const StarQuad& q)
      : own{q.next - p, q.previous - p},
        next{q.opposite - q.next, p - q.next},
        previous{p - q.previous, q.opposite - q.previous} {}
};

// How far an edge is from its target size: n + 1 / n with n its square over the target's, times a weight.
struct Stretch {
  double size2, weight;
  double of(Point edge) const { return weight * (norm2(edge) / size2 + size2 / norm2(edge)); }
};

template <class Chi>
double energy(Point p, std::span<const StarQuad> star, const Stretch& stretch, Chi chi) {
  double sum = 0;
  for (const StarQuad& q : star) {
    const Corners c(p, q);
    const double a = chi.chi(c.own.area()), b = chi.chi(c.next.area()), d = chi.chi(c.previous.area());
    if (a <= 0 || b <= 0 || d <= 0) return kInfinity;
    if (stretch.weight > 0) sum += stretch.of(c.own.u) + stretch.of(c.own.v);
    sum += c.own.squares() / a + c.next.squares() / b + c.previous.squares() / d;
  }
  return sum;
}

struct Newton {
  double value = 0;
  Point gradient;
  double xx = 0, xy = 0, yy = 0;

  // Adds the stretch of an edge from the node.
  void add_stretch(Point edge, const Stretch& stretch) {
    const double n2 = norm2(edge), inverse = stretch.size2 / (n2 * n2), first = 1 / stretch.size2 - inverse;
    value += stretch.of(edge);
    gradient += (-2 * stretch.weight * first) * edge;
    const double bend = 2 * stretch.weight * std::max(first, 0.0), cube = 8 * stretch.weight * inverse / n2;
    xx += bend + cube * edge.x * edge.x;
    xy += cube * edge.x * edge.y;
    yy += bend + cube * edge.y * edge.y;
  }

  // Adds squares / chi(area), with the derivatives of both by the place of the node.
  template <class Chi>
  void add(const Corner& c, Chi chi, Point grad_squares, double hess_squares, Point grad_area) {
    const double area = c.area(), r = 1 / chi.chi(area), n = c.squares();
    const Point g = chi.slope(area) * grad_area;
    const double m = r * r, k = 2 * n * r * m;
    value += n * r;
    gradient += r * grad_squares - (n * m) * g;
    xx += hess_squares * r - 2 * m * grad_squares.x * g.x + k * g.x * g.x;
    yy += hess_squares * r - 2 * m * grad_squares.y * g.y + k * g.y * g.y;
    xy += k * g.x * g.y - m * (grad_squares.x * g.y + grad_squares.y * g.x);
  }
};

template <class Chi>
Point newton_step(Point p, std::span<const StarQuad> star, double unit, const Stretch& stretch, Chi chi) {
  Newton sum;
  for (const StarQuad& q : star) {
    const Corners c(p, q);
    const Point u = c.own.u, v = c.own.v;
    if (stretch.weight > 0) {
      sum.add_stretch(u, stretch);
      sum.add_stretch(v, stretch);
    }
    const Point ahead = c.next.u, back = c.previous.v;
    sum.add(c.own, chi, -2.0 * (u + v), 4, {u.y - v.y, v.x - u.x});
    sum.add(c.next, chi, 2.0 * c.next.v, 2, {-ahead.y, ahead.x});
    sum.add(c.previous, chi, 2.0 * c.previous.u, 2, {back.y, -back.x});
  }
  const double det = sum.xx * sum.yy - sum.xy * sum.xy;
  if (!(det > 0)) return p;
  const Point g = sum.gradient;
  const Point step = {-(sum.yy * g.x - sum.xy * g.y) / det, -(sum.xx * g.y - sum.xy * g.x) / det};
  if (norm2(step) < kSmallStep * unit) return p;
  double t = 1;
  for (int i = 0; i < kHalvings; ++i, t *= 0.5) {
    const Point trial = p + t * step;
    if (energy(trial, star, stretch, chi) < sum.value) return trial;
  }
  return p;
}

}  // namespace

Point better_place(Point p, std::span<const StarQuad> star, double size) {
  double least = kInfinity, squares = 0;
  for (const StarQuad& q : star) {
    const Corners c(p, q);
    least = std::min({least, c.own.area(), c.next.area(), c.previous.area()});
    squares += c.own.squares();
  }
  const double unit = squares / (2 * static_cast<double>(star.size()));
  const double size2 = size * size;
  const bool is_near = unit < kOffSize * size2 && size2 < kOffSize * unit;
  if (least > kFlat * unit) return newton_step(p, star, unit, {size2, is_near ? kSize : 0}, Plain{});
  const double e = kSoftening * unit;
  return newton_step(p, star, unit, {size2, 0}, Soft{e * e});
}

}  // namespace quadline::cleanup
