#include "stages/field_points/field_points.hpp"

#include "base/check.hpp"
#include "geom/predicates.hpp"
#include "mesh/delaunay.hpp"
#include "stages/field_points/insertion.hpp"

namespace quadline {

namespace {

constexpr int kRounds = 2;

bool stays_positive(const WorkMesh& mesh, NodeId v, Point p) {
  const Topology& topo = mesh.topo();
  bool positive = true;
  topo.for_each_out(v, [&](HalfId h) {
    const HalfId rim = topo.next(h);
    if (positive) positive = orientation(p, mesh.point(topo.tail(rim)), mesh.point(topo.head(rim))) > 0;
  });
  return positive;
}

// Evens out the distances of free nodes, and keeps the triangles Delaunay.
void relax(WorkMesh& mesh) {
  const Topology& topo = mesh.topo();
  std::vector<EdgeId> suspects;
  for (int round = 0; round < kRounds; ++round) {
    for (const NodeId v : topo.nodes()) {
      if (!mesh.is_free(v)) continue;
      Point mean;
      int n = 0;
      topo.for_each_out(v, [&](HalfId h) {
        mean += mesh.point(topo.head(h));
        ++n;
      });
      const Point p = (1.0 / n) * mean;
      if (stays_positive(mesh, v, p)) mesh.move(v, p);
    }
    for (const EdgeId e : topo.edges()) suspects.push_back(e);
    restore_delaunay(mesh, suspects);
  }
}

}  // namespace

void insert_field_points(WorkMesh& mesh, const SizeField& size, Triangles triangles, Context& context) {
  const bool is_marched = triangles != Triangles::Delaunay;
  if (is_marched) march_from_constraints(mesh, size, context);
  subdivide_edges(mesh, size, is_marched ? kMarchShare : 0, context);
  mesh.drop_outside();
  mesh.sort_in_space();
  if (!is_marched) relax(mesh);  // else it would bend the rows
  QUADLINE_DEBUG_CHECK(defect(mesh).empty());
}

}  // namespace quadline
