#include "cells/cell_cost.hpp"

#include <cstddef>

#include "geom/element.hpp"
#include "quality/regular_quads.hpp"
#include "stages/verify/verify.hpp"

namespace quadline {

namespace {

constexpr double kDistortion = 0.1;        // what a quad of no beta counts, in irregular nodes
constexpr double kUnsound = 1000;          // what a quad that is not convex counts
constexpr std::size_t kMostQuads = 10000;  // of a cell that is looked at

// Calls visit(quads too many) for every sector, an inner node's too, that has not the number of quads that suits its
// angle, as the report counts them.
template <class Visit>
void for_each_irregular(const WorkMesh& mesh, Visit visit) {
  const Topology& topo = mesh.topo();
  for (const NodeId v : topo.nodes()) {
    if (!topo.out(v).valid()) continue;
    bool on_curve = false;
    mesh.for_each_sector(v, [&](HalfId first, HalfId last, Angle angle) {
      on_curve = true;
      int quads = 0;
      for (HalfId h = first; quads == 0 || h != last; h = topo.rotate_ccw(h)) ++quads;
      if (const int off = quads_off(radians(angle), quads); off != 0) visit(off);
    });
    if (on_curve) continue;
    int quads = 0;
    topo.for_each_out(v, [&](HalfId) { ++quads; });
    if (quads != 4) visit(quads - 4);
  }
}

}  // namespace

double cell_cost(const WorkMesh& part) {
  double cost = 0;
  for (const FaceId f : part.topo().faces()) {
    const QuadPoints q = part.quad_points(f);
    cost += kDistortion * (1 - quad_distortion(q)) + (is_sound(q) ? 0 : kUnsound);
  }
  for_each_irregular(part, [&](int) { cost += 1; });
  return cost;
}

bool is_improvable(const WorkMesh& part) {
  if (part.topo().face_count() > kMostQuads) return false;
  bool too_many = false, too_few = false;
  for_each_irregular(part, [&](int off) { (off > 0 ? too_many : too_few) = true; });
  return too_many && too_few;
}

}  // namespace quadline
