#include "cells/accept_grid.hpp"

#include <algorithm>
#include <cstddef>

#include "base/constants.hpp"
#include "geom/element.hpp"
#include "stages/verify/verify.hpp"

namespace quadline {

namespace {

constexpr double kLeastJacobian = 0.6, kLeastAtVertices = 0.35;
constexpr double kShortest = 0.4, kLongest = 1.8;  // edges, in sizes

double least_jacobian(const WorkMesh& mesh, FaceId f) {
  const Polygon p = mesh.topo().polygon(f);
  const bool at_vertex =
      std::any_of(p.nodes.begin(), p.nodes.end(), [&](NodeId v) { return mesh.tag(v).kind == NodeKind::Fixed; });
  return at_vertex ? kLeastAtVertices : kLeastJacobian;
}

// The shortest edge on a hole with rings: what is near it may be as short.
double shortest_round_hole(const WorkMesh& mesh, const Domain& domain) {
  double shortest = kInfinity;
  for (const Segment& s : mesh.segments())
    if (domain.curves[s.curve].has_rings) shortest = std::min(shortest, distance(mesh.point(s.a), mesh.point(s.b)));
  return shortest;
}

}  // namespace

bool is_good_grid(const WorkMesh& mesh, const Domain& domain, const SizeField& size) {
  const double shortest = shortest_round_hole(mesh, domain);
  for (const FaceId f : mesh.topo().faces()) {
    const QuadPoints q = mesh.quad_points(f);
    if (!is_sound(q) || scaled_jacobian(q) < least_jacobian(mesh, f)) return false;
    for (std::size_t k = 0; k < 4; ++k) {
      const Point a = q[k], b = q[(k + 1) % 4];
      const double h = size.at(midpoint(a, b)), length = distance(a, b);
      if (length < kShortest * std::min(h, shortest) || length > kLongest * h) return false;
    }
  }
  return true;
}

}  // namespace quadline
