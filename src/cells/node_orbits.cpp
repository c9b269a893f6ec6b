#include "cells/node_orbits.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "cells/mesh_images.hpp"
#include "geom/element.hpp"

namespace quadline {

namespace {

constexpr double kNear = 0.5;  // of an edge
constexpr double kKept = 0.8;  // of a scaled Jacobian
constexpr int kMostRounds = 8;

// What the connectivity gives is what the place would give, and both are free or on curves.
bool is_near_image(const WorkMesh& mesh, NodeId v, NodeId image, const Symmetry& symmetry) {
  if (!image.valid() || mesh.is_free(v) != mesh.is_free(image)) return false;
  const Point to = symmetry.move(mesh.point(v));
  const double off = distance(to, mesh.point(image));
  return off < kNear * distance(mesh.point(image), mesh.point(mesh.topo().head(mesh.topo().out(image))));
}

std::vector<double> jacobians(const WorkMesh& mesh) {
  std::vector<double> all;
  for (const FaceId f : mesh.topo().faces()) all.push_back(scaled_jacobian(mesh.quad_points(f)));
  return all;
}

}  // namespace

NodeOrbits::NodeOrbits(const WorkMesh& mesh, const Domain& domain, const std::vector<Symmetry>& symmetries)
    : domain_(domain), symmetries_(symmetries) {
  if (symmetries.empty()) return;
  for (const Symmetry& symmetry : symmetries) {
    images_.push_back(images_of(mesh, domain, symmetry));
    for (const NodeId v : mesh.topo().nodes())
      if (!is_near_image(mesh, v, images_.back()[v], symmetry)) images_.back()[v] = NodeId();
  }
  groups_ = subgroups_of(symmetries);
  for (const NodeId v : mesh.topo().nodes()) {
    if (!may_move(mesh.tag(v))) continue;
    const auto group = std::find_if(groups_.begin(), groups_.end(),
                                    [&](const Group& symmetric) { return has_images(mesh.topo(), v, symmetric); });
    if (group != groups_.end()) nodes_.push_back({v, static_cast<std::size_t>(group - groups_.begin())});
  }
}

// Nodes on arcs do not slide, and so stay alike.
bool NodeOrbits::may_move(const NodeTag& tag) const {
  return tag.kind == NodeKind::Free || (tag.kind == NodeKind::OnCurve && !domain_.curves[tag.curve].piece.is_arc());
}

bool NodeOrbits::has_images(const Topology& topo, NodeId v, const Group& group) const {
  bool has_all = true;
  for (const std::size_t i : group)
    topo.for_each_out(v, [&](HalfId h) {
      const NodeId a = images_[i][v], b = images_[i][topo.head(h)];
      has_all = has_all && a.valid() && b.valid() && topo.find(a, b).valid();
    });
  return has_all;
}

NodeOrbits::Place NodeOrbits::mean_place(const WorkMesh& mesh, const Entry& entry) const {
  const auto& [v, number] = entry;
  const Group& group = groups_[number];
  const double share = 1 / static_cast<double>(group.size() + 1);
  const NodeTag& tag = mesh.tag(v);
  Place mean{share * mesh.point(v), share * tag.s};
  for (const std::size_t i : group) {
    const NodeId image = images_[i][v];
    const Isometry& move = symmetries_[i].move;
    if (tag.kind == NodeKind::Free) {
      mean.at += share * (move.from + move.turned_back(mesh.point(image) - move.to));
      continue;
    }
    const double whole = length(domain_.curves[tag.curve].piece);
    const double along = mesh.tag(image).s / length(domain_.curves[mesh.tag(image).curve].piece);
    mean.s += share * whole * (symmetries_[i].curves[tag.curve].reversed ? 1 - along : along);
  }
  if (tag.kind == NodeKind::OnCurve) mean.at = point_at(domain_.curves[tag.curve].piece, mean.s);
  return mean;
}

void NodeOrbits::put(WorkMesh& mesh, NodeId v, const Place& place) {
  if (mesh.tag(v).kind == NodeKind::OnCurve) {
    mesh.slide(v, place.s, place.at);
  } else {
    mesh.move(v, place.at);
  }
}

void NodeOrbits::even_out(WorkMesh& mesh) const {
  if (nodes_.empty()) return;
  IdVector<NodeId, Place> given(mesh.topo().node_capacity());
  IdVector<NodeId, const Entry*> moved(given.count(), nullptr);
  std::vector<Place> means;
  for (const Entry& entry : nodes_) {
    given[entry.node] = {mesh.point(entry.node), mesh.tag(entry.node).s};
    means.push_back(mean_place(mesh, entry));
    moved[entry.node] = &entry;
  }
  const std::vector<double> before = jacobians(mesh);
  for (std::size_t i = 0; i < nodes_.size(); ++i) put(mesh, nodes_[i].node, means[i]);
  const auto put_back = [&](NodeId v) {
    if (!moved[v]) return;
    put(mesh, v, given[v]);
    moved[v] = nullptr;
  };
  for (int round = 0;; ++round) {
    bool is_sound = true;
    std::size_t k = 0;
    for (const FaceId f : mesh.topo().faces()) {
      const double least = kKept * before[k++];
      if (scaled_jacobian(mesh.quad_points(f)) >= least) continue;
      for (const NodeId v : mesh.topo().polygon(f).nodes) {
        if (!moved[v]) continue;
        is_sound = false;
        for (const std::size_t i : groups_[moved[v]->group]) put_back(images_[i][v]);
        put_back(v);
      }
    }
    if (is_sound) return;
    if (round < kMostRounds) continue;
    for (const Entry& entry : nodes_) put_back(entry.node);
    return;
  }
}

}  // namespace quadline
