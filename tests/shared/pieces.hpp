#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "quadline/model.hpp"

namespace quadline {

/// A straight line or a circular arc of a path, found from the model anew: the mesher's own curves stand trial here.
class Piece {
 public:
  Piece(Point a, Point b) : a_(a), b_(b), length_(distance(a, b)) {}

  /// From a to b through `via`; a straight line where the three are in line.
  Piece(Point a, Point via, Point b) : Piece(a, b) {
    const Point u = via - a, w = b - a;
    const double area = 2 * cross(u, w);
    if (std::fabs(area) < 1e-12 * norm2(w)) return;
    center_ = a + Point{(w.y * norm2(u) - u.y * norm2(w)) / area, (u.x * norm2(w) - w.x * norm2(u)) / area};
    turn_ = area > 0 ? 1 : -1;
    set_arc(distance(a, center_), angle_to(b));
  }

  explicit Piece(const Circle& circle) : Piece(circle.center + Point{circle.radius, 0}, circle.center) {
    b_ = a_;
    center_ = circle.center;
    turn_ = 1;
    set_arc(circle.radius, 2 * std::numbers::pi);
  }

  double length() const { return length_; }

  Point at(double s) const {
    if (turn_ == 0) return a_ + (s / length_) * (b_ - a_);
    const double angle = turn_ * s / radius_;
    const Point arm = a_ - center_;
    return center_ + std::cos(angle) * arm + std::sin(angle) * left_normal(arm);
  }

  /// Distance along the piece of the place nearest to p; of its start and end where p is beyond them.
  double along(Point p) const {
    if (turn_ == 0) return std::clamp(dot(p - a_, b_ - a_) / length_, 0.0, length_);
    const double angle = angle_to(p), sweep = length_ / radius_;
    if (angle <= sweep) return radius_ * angle;
    return angle - sweep < 2 * std::numbers::pi - angle ? length_ : 0;
  }

  double distance_to(Point p) const { return distance(p, at(along(p))); }
  bool is_circle() const { return turn_ != 0 && a_ == b_; }

 private:
  void set_arc(double radius, double sweep) { radius_ = radius, length_ = radius * sweep; }

  double angle_to(Point p) const {  // from the start, in the direction of the arc, 0 to 2 pi
    const Point from = a_ - center_, to = p - center_;
    const double angle = std::atan2(turn_ * cross(from, to), dot(from, to));
    return angle < 0 ? angle + 2 * std::numbers::pi : angle;
  }

  Point a_, b_, center_{};
  double length_ = 0, radius_ = 0;
  int turn_ = 0;  ///< 0 for a straight line; 1 for a counter-clockwise arc, -1 for a clockwise one
};

/// The pieces of a path in their order, those without a length left out; a closed path ends where it starts.
inline std::vector<Piece> pieces_of(const Path& path, bool is_closed) {
  if (path.circle) return {Piece(*path.circle)};
  std::vector<Piece> pieces;
  const auto add = [&](const Piece& piece) {
    if (piece.length() > 0) pieces.push_back(piece);
  };
  for (std::size_t i = 1; i < path.items.size(); ++i) {
    const Point a = path.items[i - 1].to, b = path.items[i].to;
    add(path.items[i].via ? Piece(a, *path.items[i].via, b) : Piece(a, b));
  }
  if (is_closed) add(Piece(path.items.back().to, path.items.front().to));
  return pieces;
}

/// Where a place is: in some outer loop and in no hole, or not; either counts for a place next to a loop.
class Ground {
 public:
  explicit Ground(const Model& model) {
    for (const Path& path : model.outer) outer_.push_back(polygon(path));
    for (const Path& path : model.holes) holes_.push_back(polygon(path));
  }

  bool is_well_inside(Point p) const {
    const auto winds = [p](const Polygon& polygon) { return polygon.winding(p) != 0; };
    const auto passes = [p](const Polygon& polygon) { return polygon.distance_to(p) < kNear; };
    return std::ranges::any_of(outer_, winds) && std::ranges::none_of(holes_, winds) &&
           std::ranges::none_of(outer_, passes) && std::ranges::none_of(holes_, passes);
  }

 private:
  static constexpr double kNear = 1e-3;  // more than what is between an arc and its chords, in models of some 10
  static constexpr int kChords = 720;    // of an arc

  struct Polygon {
    std::vector<Point> corners;

    int winding(Point p) const {
      int turns = 0;
      for_each_side([&](Point a, Point b) {
        const bool is_left = cross(b - a, p - a) > 0;
        if (a.y <= p.y && b.y > p.y && is_left) ++turns;
        if (a.y > p.y && b.y <= p.y && !is_left) --turns;
      });
      return turns;
    }

    double distance_to(Point p) const {
      double least = 1e300;
      for_each_side([&](Point a, Point b) {
        if (!(a == b)) least = std::min(least, Piece(a, b).distance_to(p));
      });
      return least;
    }

    template <class F>
    void for_each_side(F f) const {
      for (std::size_t i = 0; i < corners.size(); ++i) f(corners[i], corners[(i + 1) % corners.size()]);
    }
  };

  static Polygon polygon(const Path& path) {
    Polygon out;
    for (const Piece& piece : pieces_of(path, true))
      for (int i = 0; i < kChords; ++i) out.corners.push_back(piece.at(piece.length() * i / kChords));
    return out;
  }

  std::vector<Polygon> outer_, holes_;
};

}  // namespace quadline
