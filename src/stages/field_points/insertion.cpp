#include "stages/field_points/insertion.hpp"

#include <algorithm>

#include "geom/predicates.hpp"
#include "mesh/delaunay.hpp"

namespace quadline {

namespace {

double distance_to_segment(Point p, Point a, Point b) {
  const Point d = b - a;
  const double t = std::fmin(1, std::fmax(0, dot(p - a, d) / norm2(d)));
  return distance(p, a + t * d);
}

}  // namespace

NodeId Insertion::try_insert(Point p, FaceId f, const Spacing& spacing, Frame frame) {
  if (!mesh_.cell(f).valid() || too_near(p, f, size_.at(p), spacing, frame)) return {};
  const NodeId v = mesh_.add_node(p);
  return insert_node(mesh_, v, f) ? v : NodeId();
}

// Looks at the nodes round p, from the corners of its triangle on, as far as the least distance reaches.
bool Insertion::too_near(Point p, FaceId f, double h, const Spacing& spacing, Frame frame) {
  const Topology& topo = mesh_.topo();
  const double least = spacing.to_nodes * h, least_to_edge = spacing.to_constraints * h;
  const double reach = std::fmax(spacing.framed ? 1.4143 * least : least, least_to_edge);
  near_.clear();
  topo.for_each_half(f, [&](HalfId g) { near_.push_back(topo.tail(g)); });
  for (std::size_t i = 0; i < near_.size(); ++i) {
    const NodeId v = near_[i];
    const Point d = mesh_.point(v) - p;
    const double gap = spacing.framed ? std::fmax(std::fabs(dot(d, frame)), std::fabs(cross(d, frame))) : norm(d);
    if (gap < least) return true;
    const bool expand = norm2(d) < reach * reach;
    if (i >= 3 && !expand) continue;
    bool near_edge = false;
    topo.for_each_out(v, [&](HalfId g) {
      const NodeId w = topo.head(g);
      if (mesh_.is_constraint(g) && distance_to_segment(p, mesh_.point(v), mesh_.point(w)) < least_to_edge)
        near_edge = true;
      if (expand && near_.size() < 64 && std::find(near_.begin(), near_.end(), w) == near_.end()) near_.push_back(w);
    });
    if (near_edge) return true;
  }
  return false;
}

FaceId Insertion::walk(NodeId v, Point p) const {
  const Topology& topo = mesh_.topo();
  const Point from = mesh_.point(v);
  HalfId x;  // to be crossed: its tail lies right of the way, or on it, its head left
  topo.for_each_out(v, [&](HalfId h) {
    if (x.valid() || mesh_.is_outside(h)) return;
    const HalfId rim = topo.next(h);
    if (orientation(from, mesh_.point(topo.tail(rim)), p) >= 0 && orientation(from, mesh_.point(topo.head(rim)), p) < 0)
      x = rim;
  });
  while (x.valid()) {
    if (orientation(mesh_.point(topo.tail(x)), mesh_.point(topo.head(x)), p) >= 0) return topo.face(x);
    if (mesh_.can_cross(x) != Refusal::None) return {};
    const HalfId right = topo.next(twin(x));
    x = orientation(from, p, mesh_.point(topo.head(right))) > 0 ? right : topo.next(right);
  }
  return {};
}

}  // namespace quadline
