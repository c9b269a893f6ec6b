// Local smoothing of the front [Owen1999 section 3.5, Blacker1991]. We differ: one target per front node (isoparametric
// direction, length between the row's own and the local size), every move guarded; nodes ahead of the front stay where
// they are, since they may stand in rows already, and the triangles there are kept Delaunay, which keeps their fans
// round.
#include <algorithm>

#include "geom/predicates.hpp"
#include "mesh/delaunay.hpp"
#include "stages/qmorph/morph.hpp"

namespace quadline {

namespace {

constexpr double kWorstQuad = 0.1;  // scaled Jacobian that a move may leave, if it was no worse before

QuadPoints corners_from(const WorkMesh& mesh, HalfId h, Point at) {
  const Topology& topo = mesh.topo();
  const HalfId b = topo.next(h), c = topo.next(b);
  return {at, mesh.point(topo.tail(b)), mesh.point(topo.tail(c)), mesh.point(topo.head(c))};
}

}  // namespace

// Where the quads behind want a front node; for others the mean of the neighbours.
Point Morph::front_target(NodeId v) const {
  const Topology& topo = mesh_.topo();
  const Point here = mesh_.point(v);
  Point mean, iso;
  int n_edges = 0, n_quads = 0;
  HalfId behind;  // the edge between two quads
  bool triangles = false;
  topo.for_each_out(v, [&](HalfId h) {
    mean += mesh_.point(topo.head(h));
    ++n_edges;
    if (mesh_.is_triangle(h)) {
      triangles = true;
      return;
    }
    const QuadPoints q = corners_from(mesh_, h, here);
    iso += q[1] + q[3] - q[2];
    ++n_quads;
    if (!mesh_.is_triangle(twin(h))) behind = h;
  });
  if (n_quads == 0 || !triangles) return (1.0 / n_edges) * mean;
  const Point p = (1.0 / n_quads) * iso;
  if (n_quads != 2 || !behind.valid()) return p;
  const Point j = mesh_.point(topo.head(behind));
  const double reach = distance(j, p);
  if (reach == 0) return here;
  return j + (0.5 * (reach + size_at(here)) / reach) * (p - j);
}

bool Morph::try_move(NodeId v, Point p) {
  const Topology& topo = mesh_.topo();
  const Point from = mesh_.point(v);
  const auto keeps_valid = [&](Point q) {
    bool valid = true;
    topo.for_each_out(v, [&](HalfId h) {
      if (!valid || !topo.face(h).valid()) return;
      if (mesh_.is_triangle(h)) {
        valid = orientation(q, mesh_.point(topo.head(h)), mesh_.point(topo.tail(topo.prev(h)))) > 0;
      } else {
        const double after = scaled_jacobian(corners_from(mesh_, h, q));
        valid = after >= kWorstQuad || after >= scaled_jacobian(corners_from(mesh_, h, from));
      }
    });
    return valid;
  };
  double part = 1;
  for (int halvings = 0; halvings < 3; ++halvings, part *= 0.5) {
    const Point q = from + part * (p - from);
    if (!keeps_valid(q)) continue;
    mesh_.move(v, q);
    return true;
  }
  return false;
}

void Morph::smooth_around(const std::vector<NodeId>& nodes) {
  const Topology& topo = mesh_.topo();
  std::vector<NodeId> ahead;
  suspects_.clear();
  for (const NodeId v : nodes) {
    if (mesh_.is_free(v)) try_move(v, front_target(v));
    topo.for_each_out(v, [&](HalfId h) {
      const NodeId w = topo.head(h);
      if (mesh_.is_free(w) && !is_attached(mesh_, w) && std::find(ahead.begin(), ahead.end(), w) == ahead.end())
        ahead.push_back(w);
    });
  }
  const auto suspect = [&](HalfId h) {
    if (!mesh_.is_triangle(h)) return;
    suspects_.push_back(edge_of(h));
    suspects_.push_back(edge_of(topo.next(h)));
  };
  for (const NodeId v : nodes) topo.for_each_out(v, suspect);
  for (const NodeId v : ahead) topo.for_each_out(v, suspect);
  restore_delaunay(mesh_, suspects_);
}

}  // namespace quadline
