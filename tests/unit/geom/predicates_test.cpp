// The signs are compared with those of CGAL's kernel, another implementation of exact predicates, on inputs that are
// easy (random), full of ties (grids, circles), and next to ties (neighbouring doubles).
#include "geom/predicates.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace quadline {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

Kernel::Point_2 cgal(Point p) { return {p.x, p.y}; }

int cgal_orientation(Point a, Point b, Point c) {
  return static_cast<int>(CGAL::orientation(cgal(a), cgal(b), cgal(c)));
}
int cgal_in_circle(Point a, Point b, Point c, Point d) {
  return static_cast<int>(CGAL::side_of_oriented_circle(cgal(a), cgal(b), cgal(c), cgal(d)));
}

/// Numbers that are the same everywhere.
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed * 0x9e3779b97f4a7c15u + 1) {}
  std::uint64_t bits() {
    state_ ^= state_ << 13;
    state_ ^= state_ >> 7;
    state_ ^= state_ << 17;
    return state_;
  }
  double unit() { return static_cast<double>(bits() >> 11) * 0x1p-53; }
  double up_to(int n) { return static_cast<double>(bits() % static_cast<std::uint64_t>(n)); }

 private:
  std::uint64_t state_;
};

struct Input {
  std::string name;
  bool has_ties;
  std::function<Point(Random&)> point;
};

/// A few doubles further on; zeros stay, since next to them products underflow.
Point nudged(Random& r, Point p) {
  for (double* c : {&p.x, &p.y})
    for (auto steps = r.bits() % 3; steps > 0 && *c != 0; --steps) *c = std::nextafter(*c, r.bits() % 2 ? 1e3 : -1e3);
  return p;
}

/// On the circle of radius 65 round the origin, exactly: the sums of squares that give 4225.
Point on_circle(Random& r) {
  static const std::vector<Point> quarter{{65, 0},  {63, 16}, {60, 25}, {56, 33}, {52, 39},
                                          {39, 52}, {33, 56}, {25, 60}, {16, 63}};
  Point p = quarter[r.bits() % quarter.size()];
  for (auto turns = r.bits() % 4; turns > 0; --turns) p = left_normal(p);
  return p;
}

std::vector<Input> inputs() {
  return {
      {"random", false, [](Random& r) { return Point{r.unit(), r.unit()}; }},
      {"integer grid", true, [](Random& r) { return Point{r.up_to(6), r.up_to(6)}; }},
      {"grid of tenths", true, [](Random& r) { return Point{0.1 * r.up_to(6), 0.1 * r.up_to(6)}; }},
      {"grid of tenths, far away", true,
       [](Random& r) { return Point{1e7 + 0.1 * r.up_to(6), -3e6 + 0.1 * r.up_to(6)}; }},
      {"turned grid", true,
       [](Random& r) {
         const double x = r.up_to(6), y = r.up_to(6);
         return Point{0.8 * x - 0.6 * y, 0.6 * x + 0.8 * y};
       }},
      {"circle", true, on_circle},
      {"circle, next doubles", true, [](Random& r) { return nudged(r, on_circle(r)); }},
      {"circle, far away", true, [](Random& r) { return Point{1e9, 1e9} + on_circle(r); }},
      {"circle and centre, tiny", true, [](Random& r) { return (r.bits() % 5 ? 0x1p-40 : 0x1p-70) * on_circle(r); }},
      {"line, next doubles", true,
       [](Random& r) {
         const double t = r.unit();
         return nudged(r, {t, t / 3 + 0.1});
       }},
      {"many magnitudes", false,
       [](Random& r) {
         const auto coordinate = [&] { return std::ldexp(r.unit() - 0.5, static_cast<int>(r.bits() % 80) - 40); };
         return Point{coordinate(), coordinate()};
       }},
  };
}

TEST(Predicates, HaveTheSignsOfAnotherExactImplementation) {
  constexpr int kCases = 20000;
  for (const Input& input : inputs()) {
    Random r(7);
    int wrong = 0, ties = 0;
    for (int i = 0; i < kCases; ++i) {
      const Point a = input.point(r), b = input.point(r), c = input.point(r), d = input.point(r);
      const int side = orientation(a, b, c), inside = in_circle(a, b, c, d);
      wrong += side != cgal_orientation(a, b, c);
      wrong += inside != cgal_in_circle(a, b, c, d);
      ties += side == 0 || inside == 0;
    }
    EXPECT_EQ(wrong, 0) << input.name;
    EXPECT_EQ(ties > 0, input.has_ties) << input.name;
  }
}

TEST(Predicates, AgreeWithThemselvesWhenPointsChangePlaces) {
  Random r(11);
  for (const Input& input : inputs()) {
    for (int i = 0; i < 2000; ++i) {
      const Point a = input.point(r), b = input.point(r), c = input.point(r), d = input.point(r);
      EXPECT_EQ(orientation(a, b, c), orientation(b, c, a)) << input.name;
      EXPECT_EQ(orientation(a, b, c), -orientation(b, a, c)) << input.name;
      EXPECT_EQ(in_circle(a, b, c, d), in_circle(b, c, a, d)) << input.name;
      EXPECT_EQ(in_circle(a, b, c, d), -in_circle(b, a, c, d)) << input.name;
      EXPECT_EQ(in_circle(a, b, c, d), -in_circle(a, b, d, c)) << input.name;
    }
  }
}

TEST(Predicates, SeeTheLastBit) {
  const Point a{0, 0}, b{3, 1};
  EXPECT_EQ(orientation(a, b, {6, 2}), 0);
  EXPECT_EQ(orientation(a, b, {6, std::nextafter(2.0, 3)}), 1);
  EXPECT_EQ(orientation(a, b, {6, std::nextafter(2.0, 1)}), -1);
  EXPECT_EQ(in_circle({1, 0}, {0, 1}, {-1, 0}, {0, -1}), 0);
  EXPECT_EQ(in_circle({1, 0}, {0, 1}, {-1, 0}, {0, std::nextafter(-1.0, 0)}), 1);
  EXPECT_EQ(in_circle({1, 0}, {0, 1}, {-1, 0}, {0, std::nextafter(-1.0, -2)}), -1);
}

}  // namespace
}  // namespace quadline
