// Exact signs by floating-point expansions [Shewchuk1997]: an error-bound filter first; where it fails, expansions of
// exactly as many components as the coordinates need (zeros are dropped). The differences of neighbouring mesh points
// are mostly exact, and then the expansions stay short, also on grids, where every test is a tie.
#include "geom/predicates.hpp"

#include <array>
#include <cmath>

#ifdef __FAST_MATH__
#error "exact predicates need strict floating point"
#endif

namespace quadline {

namespace {

constexpr double kEpsilon = 0x1p-53;
constexpr double kOrientationBound = (3 + 16 * kEpsilon) * kEpsilon;
constexpr double kInCircleBound = (10 + 96 * kEpsilon) * kEpsilon;
constexpr double kSplitter = 0x1p27 + 1;

struct Two {
  double tail, head;
};

Two two_sum(double a, double b) {
  const double x = a + b, bv = x - a, av = x - bv;
  return {(a - av) + (b - bv), x};
}

Two two_product(double a, double b) {
  const double x = a * b;
  const double ca = kSplitter * a, ah = ca - (ca - a), al = a - ah;
  const double cb = kSplitter * b, bh = cb - (cb - b), bl = b - bh;
  return {al * bl - (((x - ah * bh) - al * bh) - ah * bl), x};
}

/// A sum of doubles of growing size that do not overlap, without zeros. `N`: most components.
template <int N>
struct Expansion {
  std::array<double, N> c;
  int n = 0;

  void put(double x) {
    if (x != 0) c[n++] = x;
  }
  int sign() const { return n == 0 ? 0 : c[n - 1] > 0 ? 1 : -1; }
};

Expansion<2> difference(double a, double b) {
  const Two d = two_sum(a, -b);
  Expansion<2> e;
  e.put(d.tail);
  e.put(d.head);
  return e;
}

template <int A, int B>
Expansion<A + B> sum(const Expansion<A>& e, const Expansion<B>& f) {
  Expansion<A + B> h;
  double q = 0;
  for (int i = 0, j = 0; i < e.n || j < f.n;) {  // components of both by growing size
    const bool from_e = j == f.n || (i < e.n && std::fabs(e.c[i]) < std::fabs(f.c[j]));
    const Two s = two_sum(q, from_e ? e.c[i++] : f.c[j++]);
    h.put(s.tail);
    q = s.head;
  }
  h.put(q);
  return h;
}

template <int A>
Expansion<2 * A> scaled(const Expansion<A>& e, double b) {
  Expansion<2 * A> h;
  double q = 0;
  for (int i = 0; i < e.n; ++i) {
    const Two p = two_product(e.c[i], b);
    const Two low = two_sum(q, p.tail);
    h.put(low.tail);
    const Two high = two_sum(p.head, low.head);
    h.put(high.tail);
    q = high.head;
  }
  h.put(q);
  return h;
}

template <int A, int B>
Expansion<2 * A * B> product(const Expansion<A>& e, const Expansion<B>& f) {
  Expansion<2 * A * B> h;
  for (int j = 0; j < f.n; ++j) {
    const auto grown = sum(h, scaled(e, f.c[j]));
    h.n = grown.n;
    for (int i = 0; i < grown.n; ++i) h.c[i] = grown.c[i];
  }
  return h;
}

template <int A>
Expansion<A> negated(Expansion<A> e) {
  for (int i = 0; i < e.n; ++i) e.c[i] = -e.c[i];
  return e;
}

// a.x b.y - a.y b.x
Expansion<16> exact_cross(const Expansion<2>& ax, const Expansion<2>& ay, const Expansion<2>& bx,
                          const Expansion<2>& by) {
  return sum(product(ax, by), negated(product(ay, bx)));
}

int exact_in_circle(Point a, Point b, Point c, Point d) {
  const auto ax = difference(a.x, d.x), ay = difference(a.y, d.y);
  const auto bx = difference(b.x, d.x), by = difference(b.y, d.y);
  const auto cx = difference(c.x, d.x), cy = difference(c.y, d.y);
  const auto lift = [](const Expansion<2>& x, const Expansion<2>& y) { return sum(product(x, x), product(y, y)); };
  const auto term_a = product(lift(ax, ay), exact_cross(bx, by, cx, cy));
  const auto term_b = product(lift(bx, by), exact_cross(cx, cy, ax, ay));
  const auto term_c = product(lift(cx, cy), exact_cross(ax, ay, bx, by));
  return sum(sum(term_a, term_b), term_c).sign();
}

int sign_of(double x) { return x > 0 ? 1 : x < 0 ? -1 : 0; }

}  // namespace

int orientation(Point a, Point b, Point c) {
  const double left = (a.x - c.x) * (b.y - c.y), right = (a.y - c.y) * (b.x - c.x);
  const double det = left - right;
  if (std::fabs(det) > kOrientationBound * (std::fabs(left) + std::fabs(right))) return sign_of(det);
  return exact_cross(difference(a.x, c.x), difference(a.y, c.y), difference(b.x, c.x), difference(b.y, c.y)).sign();
}

int in_circle(Point a, Point b, Point c, Point d) {
  const double ax = a.x - d.x, ay = a.y - d.y, bx = b.x - d.x, by = b.y - d.y, cx = c.x - d.x, cy = c.y - d.y;
  const double bxcy = bx * cy, cxby = cx * by, cxay = cx * ay, axcy = ax * cy, axby = ax * by, bxay = bx * ay;
  const double la = ax * ax + ay * ay, lb = bx * bx + by * by, lc = cx * cx + cy * cy;
  const double det = la * (bxcy - cxby) + lb * (cxay - axcy) + lc * (axby - bxay);
  const double permanent = la * (std::fabs(bxcy) + std::fabs(cxby)) + lb * (std::fabs(cxay) + std::fabs(axcy)) +
                           lc * (std::fabs(axby) + std::fabs(bxay));
  if (std::fabs(det) > kInCircleBound * permanent) return sign_of(det);
  return exact_in_circle(a, b, c, d);
}

}  // namespace quadline
