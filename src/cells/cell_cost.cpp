#include "cells/cell_cost.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "geom/element.hpp"
#include "stages/verify/verify.hpp"

namespace quadline {

namespace {

constexpr double kDistortion = 0.1;  // what a quad of no beta counts, in irregular nodes
constexpr double kUnsound = 1000;    // what a quad that is not convex counts
// A corner has the number of quads nearest to its angle in right angles; within two degrees of a tie either will do.
constexpr QuadSwitches kFewest{degrees(137), degrees(227), degrees(317)};
constexpr QuadSwitches kMost{degrees(133), degrees(223), degrees(313)};
constexpr std::size_t kMostQuads = 10000;  // of a cell that is looked at

// Quads too many (too few: negative) for the angle of a sector.
int quads_off(Angle angle, int quads) {
  const int least = quads_for_angle(angle, kFewest), most = quads_for_angle(angle, kMost);
  return quads > most ? quads - most : quads < least ? quads - least : 0;
}

template <class Visit>
void for_each_quad(const WorkMesh& mesh, Visit visit) {
  for (std::size_t i = 0; i < mesh.topo().face_capacity(); ++i)
    if (const FaceId f(i); mesh.topo().is_live(f)) visit(f);
}

// Calls visit(quads too many) for every sector, an inner node's too, that has not the number of quads that suits its
// angle, as the report counts them.
template <class Visit>
void for_each_irregular(const WorkMesh& mesh, Visit visit) {
  const Topology& topo = mesh.topo();
  for (std::size_t i = 0; i < topo.node_capacity(); ++i) {
    const NodeId v(i);
    if (!topo.is_live(v) || !topo.out(v).valid()) continue;
    bool on_curve = false;
    mesh.for_each_sector(v, [&](HalfId first, HalfId last, Angle angle) {
      on_curve = true;
      int quads = 0;
      for (HalfId h = first; quads == 0 || h != last; h = topo.rotate_ccw(h)) ++quads;
      if (const int off = quads_off(angle, quads); off != 0) visit(off);
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
  for_each_quad(part, [&](FaceId f) {
    const QuadPoints q = part.quad_points(f);
    cost += kDistortion * (1 - quad_distortion(q)) + (is_sound(q) ? 0 : kUnsound);
  });
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
