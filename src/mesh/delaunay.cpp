#include "mesh/delaunay.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "geom/predicates.hpp"

namespace quadline {

FaceId locate(const WorkMesh& mesh, Point p, FaceId near) {
  const Topology& topo = mesh.topo();
  HalfId entry = topo.first(near);
  // A walk that always tries the same side first may run in a circle where the triangles are not Delaunay; so the side
  // that is tried first changes from step to step.
  for (std::uint32_t step = 0;; ++step) {
    std::array<HalfId, 3> sides{entry, topo.next(entry), topo.prev(entry)};
    if ((step * 2654435761u) & 0x10000u) std::swap(sides[1], sides[2]);
    HalfId out;
    for (int i = step == 0 ? 0 : 1; i < 3 && !out.valid(); ++i)
      if (orientation(mesh.point(topo.tail(sides[i])), mesh.point(topo.head(sides[i])), p) < 0) out = sides[i];
    if (!out.valid()) return topo.face(entry);
    entry = twin(out);
  }
}

bool insert_node(WorkMesh& mesh, NodeId v, FaceId f) {
  const Topology& topo = mesh.topo();
  const Point p = mesh.point(v);
  HalfId on;
  bool on_node = false;
  topo.for_each_half(f, [&](HalfId h) {
    on_node |= mesh.point(topo.tail(h)) == p;
    if (orientation(mesh.point(topo.tail(h)), mesh.point(topo.head(h)), p) == 0) on = h;
  });
  if (on_node || (on.valid() && mesh.is_constraint(on))) return false;
  if (on.valid()) {
    mesh.split_edge(edge_of(on), v);
  } else {
    mesh.split_face(f, v);
  }
  std::vector<EdgeId> suspects;
  suspects.reserve(16);
  topo.for_each_out(v, [&](HalfId h) { suspects.push_back(edge_of(topo.next(h))); });
  restore_delaunay(mesh, suspects);
  return true;
}

void restore_delaunay(WorkMesh& mesh, std::vector<EdgeId>& suspects) {
  const Topology& topo = mesh.topo();
  while (!suspects.empty()) {
    const EdgeId e = suspects.back();
    suspects.pop_back();
    if (!topo.is_live(e) || mesh.can_merge(e) != Refusal::None) continue;
    const HalfId h = half_of(e, 0), t = half_of(e, 1);
    // Inside the circle implies that the two triangles form a convex quadrilateral.
    if (in_circle(mesh.point(topo.tail(h)), mesh.point(topo.head(h)), mesh.point(topo.head(topo.next(h))),
                  mesh.point(topo.head(topo.next(t)))) <= 0)
      continue;
    mesh.swap_edge(e);
    for (const HalfId g : {topo.next(h), topo.prev(h), topo.next(t), topo.prev(t)}) suspects.push_back(edge_of(g));
  }
}

}  // namespace quadline
