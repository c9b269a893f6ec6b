#include "domain/whole_circle.hpp"

#include <cmath>
#include <cstdint>

#include "base/constants.hpp"
#include "base/elementary.hpp"

namespace quadline {

WholeCircles::WholeCircles(const Domain& domain) {
  IdVector<VertexId, std::uint32_t> ends(domain.vertices.count());
  for (const Domain::Curve& c : domain.curves)
    for (const VertexId v : {c.tail, c.head}) ++ends[v];
  for (const std::uint32_t n : ends) is_seam_.push_back(n == 2);
  for (const Domain::PointUse& point : domain.points) is_seam_[point.vertex] = false;
  for (const Domain::Cell& cell : domain.cells) {  // circles with common rays are turned together, or not at all
    if (cell.rings == 0 || find(domain, cell.walks[1])) continue;
    for (const DirectedCurve& d : cell.walks[0]) is_seam_[domain.curves[d.curve].tail] = false;
  }
}

std::optional<WholeCircle> WholeCircles::find(const Domain& domain, const std::vector<DirectedCurve>& walk) const {
  if (walk.size() != 2) return std::nullopt;
  const CurvePiece &a = domain.curves[walk[0].curve].piece, &b = domain.curves[walk[1].curve].piece;
  if (!a.is_arc() || !b.is_arc() || a.center != b.center || a.radius != b.radius) return std::nullopt;
  const Domain::Curve& first = domain.curves[walk[0].curve];
  if (!is_seam_[first.tail] || !is_seam_[first.head]) return std::nullopt;
  return WholeCircle{a.center, a.radius};
}

void WholeCircles::turn(Domain& domain, const std::vector<DirectedCurve>& walk, Point direction) {
  Domain::Curve &first = domain.curves[walk[0].curve], &second = domain.curves[walk[1].curve];
  const Point way = (first.piece.radius / norm(direction)) * direction;
  domain.vertices[first.tail].at = first.piece.center + way;
  domain.vertices[first.head].at = first.piece.center - way;
  for (Domain::Curve* curve : {&first, &second}) {
    curve->piece.a = domain.vertices[curve->tail].at;
    curve->piece.b = domain.vertices[curve->head].at;
    curve->piece.sweep = std::copysign(0.5 * kFullTurn, curve->piece.sweep);
  }
}

void WholeCircles::turn(Domain& domain, const std::vector<DirectedCurve>& walk, Point tail, Point head) {
  Domain::Curve &first = domain.curves[walk[0].curve], &second = domain.curves[walk[1].curve];
  const auto place = [&](VertexId v, Point direction) {
    domain.vertices[v].at = first.piece.center + (first.piece.radius / norm(direction)) * direction;
  };
  place(first.tail, tail);
  place(first.head, head);
  for (Domain::Curve* curve : {&first, &second}) {
    CurvePiece& piece = curve->piece;
    piece.a = domain.vertices[curve->tail].at;
    piece.b = domain.vertices[curve->head].at;
    const Point from = piece.a - piece.center, to = piece.b - piece.center;
    const double turn = arc_tangent(cross(from, to), dot(from, to)), left = turn > 0 ? turn : turn + kFullTurn;
    piece.sweep = piece.sweep > 0 ? left : left - kFullTurn;
  }
}

}  // namespace quadline
