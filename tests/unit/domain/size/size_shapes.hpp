#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <vector>

#include "domain/domain.hpp"

/// Domains built by hand, for tests of what stands on them.
namespace quadline::shapes {

/// A curve between two vertices; through `via` where it is an arc.
struct Link {
  std::size_t tail, head;
  std::optional<Point> via = std::nullopt;
  double size = std::numeric_limits<double>::infinity();
};

/// Traces the cells of a plane graph whose curves meet at vertices only. Quadratic, for small shapes.
class Builder {
 public:
  Builder(std::vector<Point> points, std::vector<Link> links, double size) {
    domain_.size = size;
    for (Point p : points) domain_.vertices.push_back({p});
    domain_.box = {points[0], points[0]};
    for (const Link& l : links) {
      const Point a = points[l.tail], b = points[l.head];
      const CurvePiece piece = l.via ? arc_through(a, *l.via, b) : CurvePiece{a, b, {}, 0, 0};
      domain_.curves.push_back({VertexId(l.tail), VertexId(l.head), piece, CellId(), CellId(), l.size});
      const Box around = box(piece);
      domain_.box.lo = {std::min(domain_.box.lo.x, around.lo.x), std::min(domain_.box.lo.y, around.lo.y)};
      domain_.box.hi = {std::max(domain_.box.hi.x, around.hi.x), std::max(domain_.box.hi.y, around.hi.y)};
    }
    domain_.regions = {"domain"};
  }

  /// @param outside  points in the faces that are holes.
  Domain build(const std::vector<Point>& outside = {}) {
    trace_walks();
    std::vector<std::size_t> outer;  // walk of each cell
    for (std::size_t w = 0; w < walks_.size(); ++w)
      if (area(walks_[w]) > 0 &&
          std::none_of(outside.begin(), outside.end(), [&](Point p) { return smallest_around(p) == w; }))
        outer.push_back(w);
    for (std::size_t w : outer) domain_.cells.push_back({{walks_[w]}, {}, 0, domain_.size});
    for (const auto& walk : walks_) {
      if (area(walk) > 0) continue;
      const auto around = std::find(outer.begin(), outer.end(), smallest_around(inside_point(walk)));
      if (around != outer.end())
        domain_.cells[CellId(static_cast<std::size_t>(around - outer.begin()))].walks.push_back(walk);
    }
    for (std::size_t i = 0; i < domain_.cells.count(); ++i)
      for (const auto& walk : domain_.cells[CellId(i)].walks)
        for (const DirectedCurve& d : walk)
          (d.reversed ? domain_.curves[d.curve].right : domain_.curves[d.curve].left) = CellId(i);
    place_lone_points();
    return domain_;
  }

 private:
  using Walk = std::vector<DirectedCurve>;

  Point leaving(DirectedCurve d) const {
    const CurvePiece& p = domain_.curves[d.curve].piece;
    return d.reversed ? -1.0 * tangent_at(p, length(p)) : tangent_at(p, 0);
  }
  VertexId tail(DirectedCurve d) const {
    return d.reversed ? domain_.curves[d.curve].head : domain_.curves[d.curve].tail;
  }
  VertexId head(DirectedCurve d) const { return tail({d.curve, !d.reversed}); }

  DirectedCurve following(DirectedCurve d) const {
    const Point back = leaving({d.curve, !d.reversed});
    DirectedCurve best{d.curve, !d.reversed};
    double least = 10;
    for (std::size_t i = 0; i < domain_.curves.count(); ++i)
      for (bool reversed : {false, true}) {
        const DirectedCurve next{CurveId(i), reversed};
        if (tail(next) != head(d) || (next.curve == d.curve && next.reversed != d.reversed)) continue;
        const Point out = leaving(next);
        double turn = std::atan2(cross(out, back), dot(out, back));  // clockwise from `back` to `out`
        if (turn <= 0) turn += 2 * std::numbers::pi;
        if (turn < least) {
          least = turn;
          best = next;
        }
      }
    return best;
  }

  void trace_walks() {
    std::vector<bool> is_seen(2 * domain_.curves.count());
    for (std::size_t i = 0; i < is_seen.size(); ++i) {
      if (is_seen[i]) continue;
      Walk walk;
      for (DirectedCurve d{CurveId(i / 2), i % 2 == 1}; !is_seen[2 * d.curve.value + d.reversed]; d = following(d)) {
        is_seen[2 * d.curve.value + d.reversed] = true;
        walk.push_back(d);
      }
      walks_.push_back(walk);
    }
  }

  std::vector<Point> polygon(const Walk& walk) const {
    std::vector<Point> corners;
    for (DirectedCurve d : walk) {
      const CurvePiece& p = domain_.curves[d.curve].piece;
      const int n = p.is_arc() ? 64 : 1;
      for (int i = 0; i < n; ++i) corners.push_back(point_at(p, length(p) * (d.reversed ? n - i : i) / n));
    }
    return corners;
  }
  double area(const Walk& walk) const {
    const std::vector<Point> c = polygon(walk);
    double sum = 0;
    for (std::size_t i = 0; i < c.size(); ++i) sum += cross(c[i] - c[0], c[(i + 1) % c.size()] - c[0]);
    return std::abs(sum) < 1e-9 * domain_.size * domain_.size ? 0 : sum;
  }
  bool contains(const Walk& walk, Point p) const {
    const std::vector<Point> c = polygon(walk);
    bool is_in = false;
    for (std::size_t i = 0; i < c.size(); ++i) {
      const Point a = c[i], b = c[(i + 1) % c.size()];
      if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x)) is_in = !is_in;
    }
    return is_in;
  }
  /// A point just outside the component that the clockwise walk goes round.
  Point inside_point(const Walk& walk) const {
    Point lowest = domain_.vertices[tail(walk[0])].at;
    for (DirectedCurve d : walk)
      for (int i = 0; i < 64; ++i) {
        const CurvePiece& p = domain_.curves[d.curve].piece;
        const Point q = point_at(p, length(p) * i / 64);
        if (q.y < lowest.y) lowest = q;
      }
    return {lowest.x + 1e-7 * domain_.size, lowest.y - 1e-4 * domain_.size};
  }
  std::size_t smallest_around(Point p) const {
    std::size_t best = walks_.size();
    for (std::size_t w = 0; w < walks_.size(); ++w)
      if (area(walks_[w]) > 0 && contains(walks_[w], p) &&
          (best == walks_.size() || area(walks_[w]) < area(walks_[best])))
        best = w;
    return best;
  }
  void place_lone_points() {
    for (std::size_t i = 0; i < domain_.vertices.count(); ++i) {
      const VertexId v(i);
      if (std::any_of(domain_.curves.begin(), domain_.curves.end(),
                      [&](const Domain::Curve& c) { return c.tail == v || c.head == v; }))
        continue;
      const std::size_t w = smallest_around(domain_.vertices[v].at);
      for (auto& cell : domain_.cells)
        if (w < walks_.size() && cell.walks[0][0].curve == walks_[w][0].curve &&
            cell.walks[0][0].reversed == walks_[w][0].reversed)
          cell.lone_points.push_back(v);
    }
  }

  Domain domain_;
  std::vector<Walk> walks_;
};

/// A rectangle from the origin, vertices and curves counter-clockwise from there.
inline Domain rectangle(double width, double height, double size) {
  return Builder({{0, 0}, {width, 0}, {width, height}, {0, height}}, {{0, 1}, {1, 2}, {2, 3}, {3, 0}}, size).build();
}

/// A square with a round hole (two half arcs) in the middle, counter-clockwise.
inline Domain square_with_hole(double side, double radius, double size) {
  const double m = 0.5 * side;
  return Builder({{0, 0}, {side, 0}, {side, side}, {0, side}, {m + radius, m}, {m - radius, m}},
                 {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {4, 5, Point{m, m + radius}}, {5, 4, Point{m, m - radius}}}, size)
      .build({{m, m}});
}

/// Multiplies all lengths by a factor.
inline Domain scaled(Domain domain, double factor) {
  for (auto& v : domain.vertices) v.at = factor * v.at;
  for (auto& c : domain.curves) {
    c.piece.a = factor * c.piece.a;
    c.piece.b = factor * c.piece.b;
    c.piece.center = factor * c.piece.center;
    c.piece.radius *= factor;
    c.size *= factor;
  }
  for (auto& c : domain.cells) c.size *= factor;
  for (auto& p : domain.points) p.size *= factor;
  domain.size *= factor;
  domain.tolerance *= factor;
  domain.box = {factor * domain.box.lo, factor * domain.box.hi};
  return domain;
}

}  // namespace quadline::shapes
