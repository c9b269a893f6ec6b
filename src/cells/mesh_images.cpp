#include "cells/mesh_images.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "base/constants.hpp"
#include "base/csr.hpp"
#include "search/place_index.hpp"

namespace quadline {

namespace {

constexpr double kNear = 0.25;  // of the shortest edge on a circle: so far a node is where its image should be

class Spreader {
 public:
  Spreader(const WorkMesh& mesh, const Domain& domain, const Symmetry& symmetry)
      : mesh_(mesh),
        topo_(mesh.topo()),
        domain_(domain),
        symmetry_(symmetry),
        image_(topo_.node_capacity()),
        is_spoiled_(topo_.node_capacity(), false),
        is_seen_(topo_.face_capacity(), false) {}

  IdVector<NodeId, NodeId> run() {
    sow();
    for (std::size_t k = 0; k < pending_.size(); ++k) spread(pending_[k].first, pending_[k].second);
    for (const NodeId v : topo_.nodes())
      if (is_spoiled_[v]) image_[v] = NodeId();
    return std::move(image_);
  }

 private:
  void sow() {
    Rows<NodeId> on_curve(domain_.curves.count(), [&](const auto& visit) {
      for (const NodeId v : topo_.nodes())
        if (mesh_.tag(v).curve.valid() && !mesh_.tag(v).vertex.valid()) visit(mesh_.tag(v).curve.value, v);
    });
    IdVector<VertexId, NodeId> at_vertex(domain_.vertices.count());
    for (const NodeId v : topo_.nodes())
      if (mesh_.tag(v).vertex.valid()) at_vertex[mesh_.tag(v).vertex] = v;
    for (std::size_t i = 0; i < on_curve.count(); ++i)
      std::sort(on_curve[i].begin(), on_curve[i].end(),
                [&](NodeId a, NodeId b) { return mesh_.tag(a).s < mesh_.tag(b).s; });
    IdVector<VertexId, std::uint8_t> is_seam(domain_.vertices.count(), false);
    for (std::size_t i = 0; i < domain_.curves.count(); ++i)
      if (symmetry_.is_whole_circle[CurveId(i)])
        for (const VertexId v : {domain_.curves[CurveId(i)].tail, domain_.curves[CurveId(i)].head}) is_seam[v] = true;
    for (std::size_t i = 0; i < at_vertex.count(); ++i)
      if (const VertexId v(i); at_vertex[v].valid() && !is_seam[v]) put(at_vertex[v], at_vertex[symmetry_.vertices[v]]);
    for (std::size_t i = 0; i < on_curve.count(); ++i) {
      const DirectedCurve to = symmetry_.curves[CurveId(i)];
      const auto from = on_curve[i], into = on_curve[to.curve.value];
      if (from.size() != into.size() || symmetry_.is_whole_circle[CurveId(i)]) continue;
      for (std::size_t k = 0; k < from.size(); ++k) put(from[k], into[to.reversed ? into.size() - 1 - k : k]);
    }
    sow_circles();
    for (const EdgeId e : topo_.edges())
      if (mesh_.curve(e).valid())
        for (const int side : {0, 1}) queue(half_of(e, side));
  }

  // The arcs of a whole circle may begin elsewhere than those of its image: its nodes go by place.
  void sow_circles() {
    std::vector<NodeId> nodes;
    std::vector<Point> places;
    double shortest = kInfinity;
    for (const EdgeId e : topo_.edges()) {
      if (!mesh_.curve(e).valid() || !symmetry_.is_whole_circle[mesh_.curve(e)]) continue;
      shortest = std::min(shortest, mesh_.edge_length(e));
      for (const HalfId h : {half_of(e, 0), half_of(e, 1)}) {
        nodes.push_back(topo_.tail(h));
        places.push_back(mesh_.point(nodes.back()));
      }
    }
    if (nodes.empty()) return;
    const PlaceIndex index(places, kNear * shortest);
    for (std::size_t i = 0; i < nodes.size(); ++i)
      if (const std::size_t to = index.find(symmetry_.move(places[i])); to != PlaceIndex::kNone)
        put(nodes[i], nodes[to]);
  }

  void put(NodeId v, NodeId image) {
    if (image_[v].valid() && image_[v] != image) is_spoiled_[v] = true;
    image_[v] = image;
  }

  // The face on the left of a half-edge whose ends have images.
  void queue(HalfId h) {
    const FaceId f = topo_.face(h);
    const NodeId a = image_[topo_.tail(h)], b = image_[topo_.head(h)];
    if (!f.valid() || is_seen_[f] || !a.valid() || !b.valid()) return;
    const HalfId to = symmetry_.move.is_mirrored ? topo_.find(b, a) : topo_.find(a, b);
    if (!to.valid() || !topo_.face(to).valid() || topo_.sides(topo_.face(to)) != topo_.sides(f)) return;
    is_seen_[f] = true;
    pending_.emplace_back(h, to);
  }

  void spread(HalfId from, HalfId to) {
    const HalfId first = from;
    do {
      put(topo_.tail(from), symmetry_.move.is_mirrored ? topo_.head(to) : topo_.tail(to));
      from = topo_.next(from);
      to = symmetry_.move.is_mirrored ? topo_.prev(to) : topo_.next(to);
    } while (from != first);
    do {
      queue(twin(from));
      from = topo_.next(from);
    } while (from != first);
  }

  const WorkMesh& mesh_;
  const Topology& topo_;
  const Domain& domain_;
  const Symmetry& symmetry_;
  IdVector<NodeId, NodeId> image_;
  IdVector<NodeId, std::uint8_t> is_spoiled_;  ///< where two ways do not agree
  IdVector<FaceId, std::uint8_t> is_seen_;
  std::vector<std::pair<HalfId, HalfId>> pending_;
};

}  // namespace

IdVector<NodeId, NodeId> images_of(const WorkMesh& mesh, const Domain& domain, const Symmetry& symmetry) {
  return Spreader(mesh, domain, symmetry).run();
}

}  // namespace quadline
