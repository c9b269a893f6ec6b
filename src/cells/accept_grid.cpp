#include "cells/accept_grid.hpp"

#include <algorithm>
#include <cstddef>
#include <vector>

#include "base/constants.hpp"
#include "base/elementary.hpp"
#include "geom/element.hpp"
#include "stages/verify/verify.hpp"

namespace quadline {

namespace {

constexpr double kLeastJacobian = 0.6;
constexpr double kOfCorner = 0.9;                  // of the sine that a corner of the cell allows its quads
constexpr double kShortest = 0.4, kLongest = 1.8;  // edges, in sizes

// What the scaled Jacobian of every quad must reach: less where the corners of the cell allow no more.
IdVector<FaceId, double> least_jacobians(const WorkMesh& mesh) {
  const Topology& topo = mesh.topo();
  IdVector<FaceId, double> least(topo.face_capacity(), kLeastJacobian);
  for (const NodeId v : topo.nodes()) {
    if (!mesh.tag(v).vertex.valid()) continue;
    mesh.for_each_sector(v, [&](HalfId first, HalfId last, Angle angle) {
      std::vector<FaceId> quads;
      for (HalfId h = first; quads.empty() || h != last; h = topo.rotate_ccw(h)) quads.push_back(topo.face(h));
      const double allowed = sine(radians(angle) / static_cast<double>(quads.size()));
      for (const FaceId f : quads) least[f] = std::min(least[f], kOfCorner * allowed);
    });
  }
  return least;
}

// The shortest edge on a hole with rings, an arc, or a curve with a size of its own: what is near it may be as short.
double shortest_on_arcs(const WorkMesh& mesh, const Domain& domain) {
  double shortest = kInfinity;
  for (const Segment& s : mesh.segments())
    if (const Domain::Curve& curve = domain.curves[s.curve];
        curve.has_rings || curve.piece.is_arc() || curve.size < kInfinity)
      shortest = std::min(shortest, distance(mesh.point(s.a), mesh.point(s.b)));
  return shortest;
}

}  // namespace

bool is_good_grid(const WorkMesh& mesh, const Domain& domain, const SizeField& size) {
  const double shortest = shortest_on_arcs(mesh, domain);
  const IdVector<FaceId, double> least = least_jacobians(mesh);
  for (const FaceId f : mesh.topo().faces()) {
    const QuadPoints q = mesh.quad_points(f);
    if (!is_sound(q) || scaled_jacobian(q) < least[f]) return false;
    for (std::size_t k = 0; k < 4; ++k) {
      const Point a = q[k], b = q[(k + 1) % 4];
      const double h = size.at(midpoint(a, b)), length = distance(a, b);
      if (length < kShortest * std::min(h, shortest) || length > kLongest * h) return false;
    }
  }
  return true;
}

}  // namespace quadline
