// Incremental constrained Delaunay triangulation [Lawson1977, Sloan1993], in Hilbert order so that walks are short
// [Amenta2003]. We differ from a textbook in the box: its four nodes need not be far away, because the outer loops are
// constraints and what lies beyond them is thrown away.
#include "stages/triangulate/triangulate.hpp"

#include <limits>

#include "base/check.hpp"
#include "geom/predicates.hpp"
#include "mesh/delaunay.hpp"
#include "mesh/recover_edge.hpp"
#include "search/hilbert.hpp"

namespace quadline {

namespace {

constexpr std::size_t kNoLimit = std::numeric_limits<std::size_t>::max();

// Two triangles of a box round all nodes; the nodes of the domain keep their ids and wait outside any triangle.
void start_with_box(WorkMesh& mesh) {
  const std::size_t n = mesh.topo().node_capacity();
  std::vector<Point> points;
  std::vector<NodeTag> tags;
  Point lo = mesh.point(NodeId(0)), hi = lo;
  for (std::size_t i = 0; i < n; ++i) {
    const Point p = mesh.point(NodeId(i));
    points.push_back(p);
    tags.push_back(mesh.tag(NodeId(i)));
    lo = {std::fmin(lo.x, p.x), std::fmin(lo.y, p.y)};
    hi = {std::fmax(hi.x, p.x), std::fmax(hi.y, p.y)};
  }
  const double margin = std::fmax(hi.x - lo.x, hi.y - lo.y);
  lo = {lo.x - margin, lo.y - margin};
  hi = {hi.x + margin, hi.y + margin};
  for (const Point p : {lo, Point{hi.x, lo.y}, hi, Point{lo.x, hi.y}}) {
    points.push_back(p);
    tags.push_back({});
  }
  const std::array<Polygon, 2> box{Polygon(NodeId(n), NodeId(n + 1), NodeId(n + 2)),
                                   Polygon(NodeId(n), NodeId(n + 2), NodeId(n + 3))};
  mesh.build(std::move(points), std::move(tags), box);
}

void insert_nodes(WorkMesh& mesh, std::size_t n, Context& context) {
  const Topology& topo = mesh.topo();
  std::vector<Point> points;
  for (std::size_t i = 0; i < n; ++i) points.push_back(mesh.point(NodeId(i)));
  NodeId last(n);
  std::size_t done = 0;
  for (const std::uint32_t i : insertion_order(points)) {
    HalfId near = topo.out(last);
    if (!topo.face(near).valid()) near = twin(near);
    const NodeId v(i);
    if (!insert_node(mesh, v, locate(mesh, mesh.point(v), topo.face(near))))
      throw InternalError("two nodes lie at one place", {.file = {}, .place = {}, .point = mesh.point(v)});
    last = v;
    if (++done % 4096 == 0) context.progress("triangulate", 0.5 * static_cast<double>(done) / static_cast<double>(n));
  }
}

// Makes the segment an edge; nodes exactly on it split it.
void recover_segment(WorkMesh& mesh, const Segment& segment, std::vector<Segment>& pieces) {
  NodeId a = segment.a;
  std::vector<EdgeId> made;
  while (a != segment.b) {
    NodeId b = segment.b;
    HalfId h = mesh.topo().find(a, b);
    if (!h.valid()) {
      Way way = way_between(mesh, a, b, EdgeId(), kNoLimit);
      if (way.obstacle.edge.valid()) {
        const Point p = mesh.point(mesh.topo().tail(half_of(way.obstacle.edge)));
        throw InternalError("two curves cross", {.file = {}, .place = {}, .point = p});
      }
      if (way.obstacle.node.valid()) b = way.obstacle.node;
      h = mesh.topo().find(a, b);
      if (!h.valid()) h = recover_edge(mesh, a, b, way.crossed, made);
      if (!h.valid())
        throw InternalError("a curve cannot be made an edge", {.file = {}, .place = {}, .point = mesh.point(a)});
    }
    mesh.set_curve(edge_of(h), segment.curve);
    pieces.push_back({a, b, segment.curve});
    a = b;
  }
  restore_delaunay(mesh, made);
}

// Faces beside a segment get the cells of its curve; the others follow from their neighbours.
void spread_cells(WorkMesh& mesh, const Domain& domain) {
  const Topology& topo = mesh.topo();
  std::vector<FaceId> front;
  const auto claim = [&](FaceId f, CellId cell) {
    if (!f.valid() || !cell.valid() || mesh.cell(f).valid()) return;
    mesh.set_cell(f, cell);
    front.push_back(f);
  };
  for (const Segment& s : mesh.segments()) {
    const HalfId h = topo.find(s.a, s.b);
    claim(topo.face(h), domain.curves[s.curve].left);
    claim(topo.face(twin(h)), domain.curves[s.curve].right);
  }
  while (!front.empty()) {
    const FaceId f = front.back();
    front.pop_back();
    topo.for_each_half(f, [&](HalfId h) {
      if (mesh.can_cross(h) == Refusal::None) claim(topo.face(twin(h)), mesh.cell(f));
    });
  }
}

}  // namespace

void triangulate(WorkMesh& mesh, const Domain& domain, Context& context) {
  const std::size_t n = mesh.topo().node_capacity();
  QUADLINE_CHECK(n >= 3);
  start_with_box(mesh);
  insert_nodes(mesh, n, context);
  std::vector<Segment> pieces;
  pieces.reserve(mesh.segments().size());
  for (const Segment& s : mesh.segments()) recover_segment(mesh, s, pieces);
  mesh.set_segments(std::move(pieces));
  spread_cells(mesh, domain);
  QUADLINE_DEBUG_CHECK(defect(mesh).empty());
  context.progress("triangulate", 1);
}

}  // namespace quadline
