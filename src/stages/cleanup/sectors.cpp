// Ideal numbers of quads: 4 inside; on curves by the angle of each sector, not by the valence of the whole node
// [Canann1998, Kinney1997]. We differ: a sector near a threshold accepts both numbers, and one that no smoothing can
// make convex costs more than everything else together.
#include "stages/cleanup/sectors.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "quality/limits.hpp"

namespace quadline::cleanup {

namespace {

// A corner at a fixed node that is wider than 165 degrees makes a degenerate quad: what needs two quads, and three.
constexpr std::array kTooWide{kWidestCorner, degrees(330)};
// The switches for an angle 8 degrees less, and more
constexpr std::array<QuadSwitches, 2> kNearSwitches{
    {{degrees(133), degrees(226), degrees(318)}, {degrees(117), degrees(210), degrees(302)}}};

// Within two degrees of a number of quads and a half
bool is_tie(Angle angle) {
  return (angle > degrees(223) && angle < degrees(227)) || (angle > degrees(313) && angle < degrees(317));
}

IdealValence ideal_valence(Angle angle) {
  IdealValence valence;
  valence.on_curve = true;
  valence.least = 1;
  for (const Angle& limit : kTooWide) valence.least += angle > limit;
  const int ideal = std::max<int>(valence.least, quads_for_angle(angle));
  valence.ideal = static_cast<std::uint8_t>(ideal);
  for (const QuadSwitches& switches : kNearSwitches) {
    const int other = quads_for_angle(angle, switches);
    if (other != ideal && other >= valence.least) valence.second = static_cast<std::uint8_t>(other);
  }
  valence.is_tie = is_tie(angle);
  return valence;
}

}  // namespace

int valence_cost(const IdealValence& ideal, int quads) {
  const int off = std::abs(quads - ideal.ideal);
  if (off == 0) return 0;
  if (quads < ideal.least) return ideal.on_curve ? kBroken * (ideal.least - quads) : 16 * (ideal.least - quads);
  if (quads == ideal.second) return ideal.is_tie ? 0 : 1;
  if (ideal.on_curve) return off == 1 ? 2 : 4 * off * off;
  return off == 1 ? 1 : 4 * off * off;
}

Sectors::Sectors(const WorkMesh& mesh) : mesh_(mesh), ideal_(2 * mesh.topo().edge_capacity()) {
  for (const NodeId v : mesh.topo().nodes()) {
    if (mesh.is_free(v)) continue;
    mesh.for_each_sector(v, [&](HalfId first, HalfId, Angle angle) { ideal_[first] = ideal_valence(angle); });
  }
}

Sector Sectors::at(HalfId h) const {
  const Topology& topo = mesh_.topo();
  HalfId first = h;
  Sector sector;
  sector.quads = 1;
  if (mesh_.is_free(topo.tail(h))) {
    while ((first = topo.rotate_ccw(first)) != h) ++sector.quads;
    return sector;
  }
  while (!mesh_.is_constraint(first)) {
    first = topo.rotate_cw(first);
    if (first == h) break;  // a point constraint on no curve
    ++sector.quads;
  }
  if (!mesh_.is_constraint(first)) return sector;
  sector.ideal = ideal_[first];
  for (HalfId last = topo.rotate_ccw(h); !mesh_.is_constraint(last); last = topo.rotate_ccw(last)) ++sector.quads;
  return sector;
}

int Sectors::cost(NodeId v) const {
  const Topology& topo = mesh_.topo();
  const HalfId start = topo.out(v);
  if (!start.valid()) return 0;
  if (mesh_.is_free(v)) {
    const Sector s = at(start);
    return valence_cost(s.ideal, s.quads);
  }
  int sum = 0;
  bool has_curve = false;
  topo.for_each_out(v, [&](HalfId h) {
    if (!mesh_.is_constraint(h)) return;
    has_curve = true;
    if (mesh_.is_outside(h)) return;
    const Sector s = at(h);
    sum += valence_cost(s.ideal, s.quads);
  });
  if (has_curve) return sum;
  const Sector s = at(start);
  return valence_cost(s.ideal, s.quads);
}

}  // namespace quadline::cleanup
