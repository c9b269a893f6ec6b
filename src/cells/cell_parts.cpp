#include "cells/cell_parts.hpp"

#include <algorithm>
#include <cstddef>
#include <tuple>
#include <utility>

#include "base/check.hpp"

namespace quadline {

namespace {

// Of a node on a curve, whatever its number.
struct Place {
  VertexId vertex;
  CurveId curve;
  double s;
  bool operator<(const Place& o) const { return key() < o.key(); }
  bool operator==(const Place& o) const { return key() == o.key(); }

 private:
  std::tuple<VertexId, CurveId, double> key() const { return {vertex, curve, s}; }
};

Place place(const NodeTag& tag) { return {tag.vertex, tag.curve, tag.s}; }
bool is_on_curve(const NodeTag& tag) { return tag.vertex.valid() || tag.curve.valid(); }

class Joiner {
 public:
  explicit Joiner(const IdVector<CellId, WorkMesh>& parts) : parts_(parts) {}

  WorkMesh join() {
    find_places();
    WorkMesh mesh;
    for (const WorkMesh& part : parts_) add_faces(part);
    mesh.build(std::move(points_), std::move(tags_), faces_);
    for (std::size_t i = 0; i < cells_.size(); ++i) mesh.set_cell(FaceId(i), cells_[i]);
    for (const WorkMesh& part : parts_) add_constraints(part, mesh);
    for (const FaceId f : frozen_) mesh.freeze(f);
    mesh.sort_in_space();
    return mesh;
  }

 private:
  template <class Visit>
  static void for_each_node(const WorkMesh& part, Visit visit) {
    for (std::size_t i = 0; i < part.topo().node_capacity(); ++i)
      if (const NodeId v(i); part.topo().is_live(v) && part.topo().out(v).valid()) visit(v);
  }

  void find_places() {
    for (const WorkMesh& part : parts_)
      for_each_node(part, [&](NodeId v) {
        if (is_on_curve(part.tag(v))) places_.push_back(place(part.tag(v)));
      });
    std::sort(places_.begin(), places_.end());
    places_.erase(std::unique(places_.begin(), places_.end()), places_.end());
    numbers_.resize(places_.size());
  }

  NodeId& number_at(const NodeTag& tag) {
    return numbers_[std::lower_bound(places_.begin(), places_.end(), place(tag)) - places_.begin()];
  }

  NodeId add_node(const WorkMesh& part, NodeId v) {
    points_.push_back(part.point(v));
    tags_.push_back(part.tag(v));
    return NodeId(points_.size() - 1);
  }

  void add_faces(const WorkMesh& part) {
    const Topology& topo = part.topo();
    IdVector<NodeId, NodeId> number(topo.node_capacity());
    for_each_node(part, [&](NodeId v) {
      if (!is_on_curve(part.tag(v))) {
        number[v] = add_node(part, v);
        return;
      }
      NodeId& shared = number_at(part.tag(v));
      if (!shared.valid()) shared = add_node(part, v);
      number[v] = shared;
    });
    for (std::size_t i = 0; i < topo.face_capacity(); ++i) {
      const FaceId f(i);
      if (!topo.is_live(f) || !part.cell(f).valid()) continue;
      if (part.is_frozen(f)) frozen_.emplace_back(faces_.size());
      Polygon p = topo.polygon(f);
      for (int k = 0; k < p.n; ++k) p.nodes[k] = number[p.nodes[k]];
      faces_.push_back(p);
      cells_.push_back(part.cell(f));
    }
  }

  // Those of a curve between two cells come with both: one of them gives them all.
  void add_constraints(const WorkMesh& part, WorkMesh& mesh) {
    for (Segment s : part.segments()) {
      giver_.grow(s.curve.value + std::size_t{1}, nullptr);
      const WorkMesh*& giver = giver_[s.curve];
      if (!giver) giver = &part;
      if (giver != &part) continue;
      s.a = number_at(part.tag(s.a));
      s.b = number_at(part.tag(s.b));
      const HalfId h = mesh.topo().find(s.a, s.b);
      QUADLINE_CHECK(h.valid());
      mesh.set_curve(edge_of(h), s.curve);
      mesh.add_segment(s);
    }
  }

  const IdVector<CellId, WorkMesh>& parts_;
  std::vector<Place> places_;    // sorted
  std::vector<NodeId> numbers_;  // of the places, in the joined mesh
  IdVector<CurveId, const WorkMesh*> giver_;
  std::vector<Point> points_;
  std::vector<NodeTag> tags_;
  std::vector<Polygon> faces_;
  std::vector<CellId> cells_;
  std::vector<FaceId> frozen_;
};

}  // namespace

CellNodes::CellNodes(const Domain& domain, const WorkMesh& nodes)
    : domain_(domain), nodes_(nodes), segments_(domain.cells.count()) {
  for (std::size_t i = 0; i < nodes.segments().size(); ++i) {
    const Domain::Curve& curve = domain.curves[nodes.segments()[i].curve];
    if (curve.left.valid()) segments_[curve.left].push_back(static_cast<std::uint32_t>(i));
    if (curve.right.valid() && curve.right != curve.left)
      segments_[curve.right].push_back(static_cast<std::uint32_t>(i));
  }
}

WorkMesh CellNodes::of(CellId c) const {
  std::vector<NodeId> used;
  for (const std::uint32_t i : segments_[c]) {
    used.push_back(nodes_.segments()[i].a);
    used.push_back(nodes_.segments()[i].b);
  }
  for (const VertexId v : domain_.cells[c].lone_points) used.push_back(NodeId(v.value));
  std::sort(used.begin(), used.end());
  used.erase(std::unique(used.begin(), used.end()), used.end());
  WorkMesh part;
  for (const NodeId v : used) part.add_node(nodes_.point(v), nodes_.tag(v));
  const auto number = [&](NodeId v) { return NodeId(std::lower_bound(used.begin(), used.end(), v) - used.begin()); };
  for (const std::uint32_t i : segments_[c]) {
    const Segment& s = nodes_.segments()[i];
    part.add_segment({number(s.a), number(s.b), s.curve});
  }
  return part;
}

WorkMesh joined(const IdVector<CellId, WorkMesh>& parts) { return Joiner(parts).join(); }

}  // namespace quadline
