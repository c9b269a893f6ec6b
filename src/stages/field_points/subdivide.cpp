// Points on edges that are too long in the size metric, filtered and inserted, until no edge is too long
// [BorouchakiGeorge1997]. We differ: candidates are taken in Hilbert order and filtered by the triangulation itself.
#include <cmath>

#include "stages/field_points/insertion.hpp"
#include "mesh/delaunay.hpp"
#include "search/hilbert.hpp"

namespace quadline {

namespace {

constexpr double kTooLong = 1.42;  // length in the size metric; the diagonal of a square is not too long
constexpr Spacing kSpacing{0.75, 0.5, false};
constexpr int kMostRounds = 64;  // each round at least halves the longest edge: never reached

// Points at equal metric distance along the edge a-b where the size runs linearly from ha to hb.
void points_along(Point a, Point b, double ha, double hb, std::vector<Point>& points) {
  const double d = distance(a, b), r = hb / ha;
  const bool even = std::fabs(r - 1) < 1e-3;
  const double length = even ? d / ha : d * std::log(r) / (hb - ha);
  if (length <= kTooLong) return;
  const int n = static_cast<int>(std::lround(length));
  for (int i = 1; i < n; ++i) {
    const double part = static_cast<double>(i) / n;
    points.push_back(a + (even ? part : (std::pow(r, part) - 1) / (r - 1)) * (b - a));
  }
  if (n < 2) points.push_back(midpoint(a, b));
}

}  // namespace

void subdivide_edges(WorkMesh& mesh, const SizeField& size, Context& context) {
  const Topology& topo = mesh.topo();
  Insertion insertion(mesh, size);
  IdVector<NodeId, double> h;
  std::vector<Point> candidates;
  for (int round = 0; round < kMostRounds; ++round) {
    for (std::size_t i = h.count(); i < topo.node_capacity(); ++i) h.push_back(size.at(mesh.point(NodeId(i))));
    candidates.clear();
    FaceId near;
    for (std::size_t i = 0; i < topo.edge_capacity(); ++i) {
      const EdgeId e(i);
      if (!topo.is_live(e) || mesh.is_constraint(e) || mesh.is_outside(half_of(e))) continue;
      const NodeId a = topo.tail(half_of(e)), b = topo.head(half_of(e));
      points_along(mesh.point(a), mesh.point(b), h[a], h[b], candidates);
      if (!near.valid()) near = topo.face(half_of(e));
    }
    std::size_t inserted = 0, seen = 0;
    for (const std::uint32_t i : hilbert_order(candidates)) {
      near = locate(mesh, candidates[i], near);
      const NodeId v = insertion.try_insert(candidates[i], near, kSpacing, {});
      if (v.valid()) {
        near = topo.face(topo.out(v));
        ++inserted;
      }
      if (++seen % 4096 == 0) context.progress("field points", 0.1 * std::fmin(round, 9));
    }
    if (inserted == 0) return;
  }
}

}  // namespace quadline
