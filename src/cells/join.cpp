#include "cells/join.hpp"

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
  explicit Joiner(const IdVector<CellId, const WorkMesh*>& parts) {
    for (const WorkMesh* part : parts)
      if (part) parts_.push_back(part);
  }

  WorkMesh join() {
    find_places();
    WorkMesh mesh;
    for (const WorkMesh* part : parts_) add_faces(*part);
    mesh.build(std::move(points_), std::move(tags_), faces_);
    for (std::size_t i = 0; i < cells_.size(); ++i) mesh.set_cell(FaceId(i), cells_[i]);
    for (const WorkMesh* part : parts_) add_constraints(*part, mesh);
    for (const FaceId f : frozen_) mesh.freeze(f);
    mesh.sort_in_space();
    return mesh;
  }

 private:
  template <class Visit>
  static void for_each_node(const WorkMesh& part, Visit visit) {
    for (const NodeId v : part.topo().nodes())
      if (part.topo().out(v).valid()) visit(v);
  }

  void find_places() {
    for (const WorkMesh* part : parts_)
      for_each_node(*part, [&](NodeId v) {
        if (is_on_curve(part->tag(v))) places_.push_back(place(part->tag(v)));
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
    for (const FaceId f : topo.faces()) {
      if (!part.cell(f).valid()) continue;
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

  std::vector<const WorkMesh*> parts_;
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

WorkMesh joined(const IdVector<CellId, const WorkMesh*>& parts) { return Joiner(parts).join(); }

}  // namespace quadline
