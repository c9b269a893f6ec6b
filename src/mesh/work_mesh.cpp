#include "mesh/work_mesh.hpp"

#include <algorithm>

#include "base/check.hpp"
#include "geom/predicates.hpp"
#include "search/hilbert.hpp"

namespace quadline {

NodeId WorkMesh::add_node(Point p, const NodeTag& tag) {
  const NodeId v = topo_.add_node();
  fit();
  point_[v] = p;
  tag_[v] = tag;
  return v;
}

void WorkMesh::slide(NodeId v, double s, Point p) {
  QUADLINE_CHECK(tag_[v].kind == NodeKind::OnCurve);
  tag_[v].s = s;
  point_[v] = p;
}

QuadPoints WorkMesh::quad_points(FaceId f) const {
  const Polygon p = topo_.polygon(f);
  return {point(p.nodes[0]), point(p.nodes[1]), point(p.nodes[2]), point(p.nodes[3])};
}

Angle WorkMesh::angle_between(HalfId a, HalfId b) const {
  if (a == b) return degrees(360);
  const Point v = point(topo_.tail(a));
  return angle_at(point(topo_.head(b)), v, point(topo_.head(a)));
}

Refusal WorkMesh::can_swap(EdgeId e) const {
  const HalfId h = half_of(e, 0), t = half_of(e, 1);
  if (const Refusal refusal = can_merge(e); refusal != Refusal::None) return refusal;
  const Point a = point(topo_.tail(h)), b = point(topo_.tail(t));
  const Point c = point(topo_.tail(topo_.prev(h))), d = point(topo_.tail(topo_.prev(t)));
  if (orientation(d, c, a) <= 0 || orientation(c, d, b) <= 0) return Refusal::WouldInvert;
  return Refusal::None;
}

void WorkMesh::swap_edge(EdgeId e) {
  QUADLINE_DEBUG_CHECK(can_swap(e) == Refusal::None);
  topo_.swap_edge(e);
}

NodeId WorkMesh::split_edge(EdgeId e, Point p, const NodeTag& tag) {
  const NodeId v = add_node(p, tag);
  split_edge(e, v);
  return v;
}

void WorkMesh::split_edge(EdgeId e, NodeId v) {
  const FaceId left = topo_.face(half_of(e, 0)), right = topo_.face(half_of(e, 1));
  const EdgeId rest = topo_.split_edge(e, v);
  fit();
  curve_[rest] = curve_[e];
  is_constraint_[rest] = is_constraint_[e];
  if (left.valid()) cell_[topo_.face(half_of(rest, 0))] = cell_[topo_.face(half_of(e, 0))] = cell_[left];
  if (right.valid()) cell_[topo_.face(half_of(rest, 1))] = cell_[topo_.face(half_of(e, 1))] = cell_[right];
  topo_.for_each_out(v, [&](HalfId h) {
    if (edge_of(h) != e && edge_of(h) != rest) set_curve(edge_of(h), CurveId());
  });
}

NodeId WorkMesh::split_face(FaceId f, Point p, const NodeTag& tag) {
  const NodeId v = add_node(p, tag);
  split_face(f, v);
  return v;
}

void WorkMesh::split_face(FaceId f, NodeId v) {
  const auto [g, k] = topo_.split_face(f, v);
  fit();
  cell_[g] = cell_[k] = cell_[f];
  topo_.for_each_out(v, [&](HalfId h) { set_curve(edge_of(h), CurveId()); });
}

void WorkMesh::replace_cavity(std::span<const FaceId> faces, std::span<const Polygon> polygons,
                              std::vector<FaceId>& made) {
  const CellId cell = cell_[faces.front()];
#ifndef NDEBUG
  for (const FaceId f : faces) QUADLINE_CHECK(cell_[f] == cell && can_replace(f) == Refusal::None);
#endif
  find_constraints_inside(faces);
  topo_.replace_cavity(faces, polygons, made, fresh_);
  fit();
  for (const HalfId h : fresh_) set_curve(edge_of(h), CurveId());
  for (const FaceId f : made) cell_[f] = cell;
  for (const Segment& s : inside_) {
    const HalfId h = topo_.find(s.a, s.b);
    QUADLINE_CHECK(h.valid());
    set_curve(edge_of(h), s.curve);
  }
}

// A cavity may go round the end of an open line, and so hold both sides of its last edge.
void WorkMesh::find_constraints_inside(std::span<const FaceId> faces) {
  inside_.clear();
  for (const FaceId f : faces)
    topo_.for_each_half(f, [&](HalfId h) {
      if (!is_constraint(h) || h > twin(h) || std::find(faces.begin(), faces.end(), topo_.face(twin(h))) == faces.end())
        return;
      inside_.push_back({topo_.tail(h), topo_.head(h), curve_[edge_of(h)]});
    });
}

void WorkMesh::freeze(FaceId f) {
  topo_.for_each_half(f, [&](HalfId h) {
    tag_[topo_.tail(h)].kind = NodeKind::Fixed;
    is_constraint_[edge_of(h)] = 1;
  });
}

// Also where frozen faces are all round it.
bool WorkMesh::is_frozen(FaceId f) const {
  bool is_held = false;  // by more than curves
  const HalfId start = topo_.first(f);
  HalfId h = start;
  do {
    if (!is_constraint(h)) return false;
    is_held |= !curve_[edge_of(h)].valid();
    h = topo_.next(h);
  } while (h != start);
  return is_held;
}

void WorkMesh::thaw() {
  for (const EdgeId e : topo_.edges()) is_constraint_[e] = curve_[e].valid();
  for (NodeTag& tag : tag_)
    if (!tag.vertex.valid()) tag.kind = tag.curve.valid() ? NodeKind::OnCurve : NodeKind::Free;
}

void WorkMesh::build(std::vector<Point> points, std::vector<NodeTag> tags, std::span<const Polygon> polygons) {
  topo_.build(points.size(), polygons);
  point_.raw() = std::move(points);
  tag_.raw() = std::move(tags);
  curve_.assign(topo_.edge_capacity(), CurveId());
  is_constraint_.assign(topo_.edge_capacity(), 0);
  cell_.assign(topo_.face_capacity(), CellId());
  fit();
}

void WorkMesh::keep_cell(CellId c) {
  for (CellId& cell : cell_)
    if (cell != c) cell = CellId();
}

void WorkMesh::drop_outside() {
  for (const FaceId f : topo_.faces())
    if (!cell_[f].valid()) topo_.remove_face(f);
  for (const NodeId v : topo_.nodes())
    if (!topo_.out(v).valid()) topo_.remove_node(v);
}

void WorkMesh::compact() { follow(topo_.compact()); }

void WorkMesh::sort_in_space() {
  std::vector<FaceId> faces;
  std::vector<Point> corners;
  for (const FaceId f : topo_.faces()) {
    faces.push_back(f);
    corners.push_back(point(topo_.tail(topo_.first(f))));
  }
  std::vector<FaceId> order;
  order.reserve(faces.size());
  for (const std::uint32_t i : hilbert_order(corners)) order.push_back(faces[i]);
  follow(topo_.reorder(order));
}

void WorkMesh::follow(const Topology::Renumbering& map) {
  const auto move = [](auto& array, const auto& to, std::size_t n) {
    using IdType = std::decay_t<decltype(array.end_id())>;
    std::decay_t<decltype(array)> moved(n);
    for (std::size_t i = 0; i < to.count(); ++i)
      if (to[IdType(i)].valid()) moved[to[IdType(i)]] = array[IdType(i)];
    array = std::move(moved);
  };
  move(point_, map.node, topo_.node_capacity());
  move(tag_, map.node, topo_.node_capacity());
  move(curve_, map.edge, topo_.edge_capacity());
  move(is_constraint_, map.edge, topo_.edge_capacity());
  move(cell_, map.face, topo_.face_capacity());
  for (Segment& s : segments_) {
    s.a = map.node[s.a];
    s.b = map.node[s.b];
  }
}

void WorkMesh::fit() {
  point_.grow(topo_.node_capacity());
  tag_.grow(topo_.node_capacity());
  curve_.grow(topo_.edge_capacity());
  is_constraint_.grow(topo_.edge_capacity(), 0);
  cell_.grow(topo_.face_capacity());
}

int ideal_quads(const WorkMesh& mesh, NodeId v) {
  int n = 0;
  bool on_curve = false;
  mesh.for_each_sector(v, [&](HalfId, HalfId, Angle angle) {
    n += quads_for_angle(angle);
    on_curve = true;
  });
  return on_curve ? n : 4;
}

std::string defect(const WorkMesh& mesh) {
  const Topology& topo = mesh.topo();
  if (const char* text = topo.defect()) return text;
  for (const FaceId f : topo.faces()) {
    const Polygon p = topo.polygon(f);
    double area = 0;
    for (int k = 1; k + 1 < p.n; ++k)
      area += twice_area(mesh.point(p.nodes[0]), mesh.point(p.nodes[k]), mesh.point(p.nodes[k + 1]));
    const bool positive =
        p.n == 3 ? orientation(mesh.point(p.nodes[0]), mesh.point(p.nodes[1]), mesh.point(p.nodes[2])) > 0 : area > 0;
    if (!positive) {
      const Point at = mesh.point(p.nodes[0]);
      return "a face without positive area at (" + std::to_string(at.x) + ", " + std::to_string(at.y) + ")";
    }
  }
  for (const EdgeId e : topo.edges()) {
    if (!mesh.is_constraint(e)) continue;
    if (mesh.is_free(topo.tail(half_of(e, 0))) || mesh.is_free(topo.tail(half_of(e, 1))))
      return "a constraint edge ends at a free node";
  }
  return "";
}

}  // namespace quadline
