#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "domain/domain.hpp"
#include "geom/predicates.hpp"
#include "mesh/work_mesh.hpp"
#include "quadline/context.hpp"
#include "stages/triangulate/triangulate.hpp"
#include "tests/unit/geom/point_inputs.hpp"

namespace quadline::test {

/// What `triangulate` takes: nodes, and segments along curves with a cell on either side.
class Sketch {
 public:
  NodeId node(Point p) { return mesh.add_node(p, {NodeKind::Fixed, CurveId(), 0, VertexId()}); }

  /// A chain of segments, one curve; -1: outside.
  CurveId chain(const std::vector<NodeId>& nodes, int left, int right) {
    const CurveId c =
        domain.curves.push_back({.tail = {}, .head = {}, .piece = {}, .left = cell(left), .right = cell(right)});
    for (std::size_t i = 0; i + 1 < nodes.size(); ++i) mesh.add_segment({nodes[i], nodes[i + 1], c});
    return c;
  }
  CurveId loop(const std::vector<Point>& points, int left, int right) {
    std::vector<NodeId> nodes;
    for (const Point p : points) nodes.push_back(node(p));
    nodes.push_back(nodes.front());
    return chain(nodes, left, right);
  }
  CurveId line(const std::vector<Point>& points, int cell_id) {
    std::vector<NodeId> nodes;
    for (const Point p : points) nodes.push_back(node(p));
    return chain(nodes, cell_id, cell_id);
  }
  void triangulate() {
    Context context;
    quadline::triangulate(mesh, domain, context);
  }

  WorkMesh mesh;
  Domain domain;

 private:
  static CellId cell(int i) { return i < 0 ? CellId() : CellId(static_cast<std::size_t>(i)); }
};

inline std::vector<Point> rectangle(double x0, double y0, double x1, double y1) {
  return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
}

/// Area of the triangles of each cell; -1: outside.
inline std::map<int, double> areas(const WorkMesh& mesh) {
  std::map<int, double> sum;
  for (std::size_t i = 0; i < mesh.topo().face_capacity(); ++i) {
    const FaceId f(i);
    if (!mesh.topo().is_live(f)) continue;
    const Polygon p = mesh.topo().polygon(f);
    sum[mesh.cell(f).valid() ? static_cast<int>(mesh.cell(f).value) : -1] +=
        0.5 * twice_area(mesh.point(p.nodes[0]), mesh.point(p.nodes[1]), mesh.point(p.nodes[2]));
  }
  return sum;
}

/// Number of edges, constraints left out, whose two triangles' circles hold the other's node. Exact.
inline int edges_not_delaunay(const WorkMesh& mesh) {
  const Topology& topo = mesh.topo();
  int n = 0;
  for (std::size_t i = 0; i < topo.edge_capacity(); ++i) {
    const EdgeId e(i);
    if (!topo.is_live(e) || mesh.is_constraint(e)) continue;
    const HalfId h = half_of(e, 0), t = half_of(e, 1);
    if (!topo.face(h).valid() || !topo.face(t).valid()) continue;
    n += in_circle(mesh.point(topo.tail(h)), mesh.point(topo.head(h)), mesh.point(topo.head(topo.next(h))),
                   mesh.point(topo.head(topo.next(t)))) > 0;
  }
  return n;
}

/// Number of segments that are no edge with their curve.
inline int segments_missing(const WorkMesh& mesh) {
  int n = 0;
  for (const Segment& s : mesh.segments()) {
    const HalfId h = mesh.topo().find(s.a, s.b);
    n += !h.valid() || mesh.curve(edge_of(h)) != s.curve;
  }
  return n;
}

using Triangle = std::array<std::uint32_t, 3>;

/// Counter-clockwise, the smallest node first.
inline Triangle in_order(Triangle t) {
  while (t[0] > t[1] || t[0] > t[2]) t = {t[1], t[2], t[0]};
  return t;
}

inline std::set<Triangle> triangles(const WorkMesh& mesh) {
  std::set<Triangle> all;
  for (std::size_t i = 0; i < mesh.topo().face_capacity(); ++i) {
    const FaceId f(i);
    if (!mesh.topo().is_live(f)) continue;
    const Polygon p = mesh.topo().polygon(f);
    all.insert(in_order({p.nodes[0].value, p.nodes[1].value, p.nodes[2].value}));
  }
  return all;
}

}  // namespace quadline::test
