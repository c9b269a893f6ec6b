#include "domain/cell_locator.hpp"

#include <cmath>

#include "base/constants.hpp"

namespace quadline {

double ray_distance(Point p, Point d, double reach, const CurvePiece& piece) {
  if (!piece.is_arc()) {
    const Point e = piece.b - piece.a;
    const double det = cross(d, e);
    if (det == 0) return kInfinity;
    const double t = cross(piece.a - p, e) / det, u = cross(piece.a - p, d) / det;
    return t > 0 && t <= reach && u >= 0 && u <= 1 ? t : kInfinity;
  }
  const Point c = piece.center - p;
  const double along = dot(c, d), off = cross(d, c), half2 = piece.radius * piece.radius - off * off;
  if (half2 < 0) return kInfinity;
  const double half = std::sqrt(half2);
  for (double t : {along - half, along + half}) {
    if (t <= 0 || t > reach) continue;
    const Point q = p + t * d;
    if (distance(point_at(piece, project(piece, q)), q) <= 1e-6 * piece.radius) return t;
  }
  return kInfinity;
}

std::vector<Box> boxes_of_curves(const Domain& domain) {
  std::vector<Box> boxes;
  boxes.reserve(domain.curves.count());
  for (const Domain::Curve& c : domain.curves) boxes.push_back(box(c.piece));
  return boxes;
}

bool is_left_of(const CurvePiece& piece, double s, Point p) {
  return cross(tangent_at(piece, s), p - point_at(piece, s)) > 0;
}

CellId CellLocator::at(Point p) const {
  // A ray that meets a curve near its end may see the wrong one of two; another direction will not.
  constexpr Point kDirections[] = {{0.6, 0.8}, {-0.8, 0.6}, {-0.28, -0.96}, {0.96, -0.28}, {-0.96, -0.28}};
  CellId found;
  for (Point d : kDirections) {
    CurveId curve;
    double nearest = kInfinity;
    tree_.ray(p, d, [&](std::uint32_t item) {
      const double t = ray_distance(p, d, kInfinity, domain_.curves[CurveId(item)].piece);
      if (t < nearest) {
        nearest = t;
        curve = CurveId(item);
      }
      return t;
    });
    if (!curve.valid()) return CellId();
    const Domain::Curve& hit = domain_.curves[curve];
    const double s = project(hit.piece, p + nearest * d), whole = length(hit.piece);
    found = is_left_of(hit.piece, s, p) ? hit.left : hit.right;
    const double slant = std::abs(cross(tangent_at(hit.piece, s), d));
    if (s > 1e-6 * whole && s < (1 - 1e-6) * whole && slant > 1e-3) break;
  }
  return found;
}

}  // namespace quadline
