// Rays for nesting and for locating points: which side of which piece is first met below a point.
#include <algorithm>
#include <array>
#include <cmath>

#include "base/constants.hpp"
#include "domain/arrange/work.hpp"

namespace quadline::arrangement {

namespace {

std::vector<Box> boxes_of(const Work& work) {
  std::vector<Box> boxes;
  for (const Piece& piece : work.pieces) boxes.push_back(inflated(box(piece.curve), work.tolerance));
  return boxes;
}

struct Crossing {
  double along = kInfinity;  ///< length of the ray
  bool from_left = false;    ///< the ray comes from the piece's left
  bool is_clear = true;
};

class Ray {
 public:
  Ray(Point from, Point direction, double margin) : from_(from), direction_(direction), margin_(margin) {}

  Crossing meet(const CurvePiece& piece) const { return piece.is_arc() ? meet_arc(piece) : meet_segment(piece); }

 private:
  Crossing meet_segment(const CurvePiece& piece) const {
    const double a = cross(direction_, piece.a - from_);
    const double b = cross(direction_, piece.b - from_);
    if (std::min(a, b) > margin_ || std::max(a, b) < -margin_) return {};
    const double f = a == b ? 0.5 : std::clamp(a / (a - b), 0.0, 1.0);
    const double along = dot(direction_, piece.a + f * (piece.b - piece.a) - from_);
    const bool is_clear = std::min(std::abs(a), std::abs(b)) > margin_;
    return along > 0 ? Crossing{along, a < b, is_clear} : Crossing{};
  }

  Crossing meet_arc(const CurvePiece& arc) const {
    const Point to_center = arc.center - from_;
    const double off = cross(direction_, to_center);
    const double depth = arc.radius - std::abs(off);
    if (depth < -margin_) return {};
    const double half = std::sqrt(std::max(0.0, depth * (arc.radius + std::abs(off))));
    Crossing first;
    for (const double along : {dot(direction_, to_center) - half, dot(direction_, to_center) + half}) {
      const Point p = from_ + along * direction_;
      const double near_end = std::min(distance(p, arc.a), distance(p, arc.b));
      const bool is_on = near_end <= margin_ || is_beside(arc, p);
      if (!(along > 0) || along >= first.along || !is_on) continue;
      const Point tangent = (arc.sweep > 0 ? 1.0 : -1.0) * left_normal(p - arc.center);
      first = {along, cross(direction_, tangent) > 0, near_end > margin_ && depth > margin_};
    }
    return first;
  }

  Point from_, direction_;
  double margin_;
};

}  // namespace

RayCaster::RayCaster(const Work& work, const std::vector<std::uint32_t>& component)
    : work_(work), component_(component), tree_(boxes_of(work)) {
  const double farthest =
      std::max({std::abs(work.box.lo.x), std::abs(work.box.lo.y), std::abs(work.box.hi.x), std::abs(work.box.hi.y)});
  margin_ = 0x1p-20 * work.tolerance + 0x1p-50 * farthest;
}

Point RayCaster::direction(unsigned k) {
  static constexpr std::array<double, kDirections> kSlants = {0.0172, -0.0318, 0.1093, -0.1367,
                                                              0.2319, -0.2741, 0.3583, -0.4177};
  const Point slanted{kSlants[k], -1};
  return (1 / norm(slanted)) * slanted;
}

RayCaster::Hit RayCaster::cast(Point from, unsigned k, std::uint32_t skip) const {
  const Point down = direction(k);
  const Ray ray(from, down, margin_);
  Hit hit;
  double best = kInfinity;
  tree_.ray(from, down, [&](std::uint32_t item) {
    if (component_[item] == skip) return best;
    const Crossing met = ray.meet(work_.pieces[CurveId(item)].curve);
    if (met.along < best) {
      best = met.along;
      hit = {2 * item + (met.from_left ? 0u : 1u), met.is_clear};
    }
    return best;
  });
  return hit;
}

}  // namespace quadline::arrangement
