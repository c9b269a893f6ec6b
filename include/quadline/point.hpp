#pragma once

#include <cmath>

namespace quadline {

/// A point or a vector of the plane, in model units.
struct Point {
  double x = 0;
  double y = 0;

  friend constexpr bool operator==(Point a, Point b) = default;
  friend constexpr Point operator+(Point a, Point b) { return {a.x + b.x, a.y + b.y}; }
  friend constexpr Point operator-(Point a, Point b) { return {a.x - b.x, a.y - b.y}; }
  friend constexpr Point operator*(double f, Point a) { return {f * a.x, f * a.y}; }
  constexpr Point& operator+=(Point b) { return *this = *this + b; }
};

constexpr double dot(Point a, Point b) { return a.x * b.x + a.y * b.y; }
constexpr double cross(Point a, Point b) { return a.x * b.y - a.y * b.x; }
constexpr double norm2(Point a) { return dot(a, a); }
constexpr Point left_normal(Point a) { return {-a.y, a.x}; }
constexpr Point midpoint(Point a, Point b) { return {a.x + 0.5 * (b.x - a.x), a.y + 0.5 * (b.y - a.y)}; }
inline double norm(Point a) { return std::sqrt(norm2(a)); }
inline double distance(Point a, Point b) { return norm(b - a); }

}  // namespace quadline
