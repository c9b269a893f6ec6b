#pragma once

#include <cmath>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "quadline/point.hpp"

namespace quadline::test {

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
  std::size_t below(std::size_t n) { return bits() % n; }
  double unit() { return static_cast<double>(bits() >> 11) * 0x1p-53; }

 private:
  std::uint64_t state_;
};

/// A way to make points.
struct PointInput {
  std::string name;
  bool has_ties;  ///< collinear or cocircular points
  std::function<Point(Random&)> point;
};

inline double up_to(Random& r, std::size_t n) { return static_cast<double>(r.below(n)); }

/// A few doubles further on; zeros stay, since next to them products underflow.
inline Point nudged(Random& r, Point p) {
  for (double* c : {&p.x, &p.y})
    for (auto steps = r.bits() % 3; steps > 0 && *c != 0; --steps) *c = std::nextafter(*c, r.bits() % 2 ? 1e3 : -1e3);
  return p;
}

/// On the circle of radius 65 round the origin, exactly: the sums of squares that give 4225.
inline Point on_circle(Random& r) {
  static const std::vector<Point> quarter{{65, 0},  {63, 16}, {60, 25}, {56, 33}, {52, 39},
                                          {39, 52}, {33, 56}, {25, 60}, {16, 63}};
  Point p = quarter[r.bits() % quarter.size()];
  for (auto turns = r.bits() % 4; turns > 0; --turns) p = left_normal(p);
  return p;
}

inline std::vector<PointInput> point_inputs() {
  return {
      {"random", false, [](Random& r) { return Point{r.unit(), r.unit()}; }},
      {"integer grid", true, [](Random& r) { return Point{up_to(r, 6), up_to(r, 6)}; }},
      {"grid of tenths", true, [](Random& r) { return Point{0.1 * up_to(r, 6), 0.1 * up_to(r, 6)}; }},
      {"grid of tenths, far away", true,
       [](Random& r) { return Point{1e7 + 0.1 * up_to(r, 6), -3e6 + 0.1 * up_to(r, 6)}; }},
      {"turned grid", true,
       [](Random& r) {
         const double x = up_to(r, 6), y = up_to(r, 6);
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

}  // namespace quadline::test
