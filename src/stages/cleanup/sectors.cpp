// Ideal numbers of quads: 4 inside; on curves by the angle of each sector, not by the valence of the whole node
// [Canann1998, Kinney1997]. We differ: a sector near a threshold accepts both numbers, and one that no smoothing can
// make convex costs more than everything else together.
#include "stages/cleanup/sectors.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace quadline::cleanup {

namespace {

constexpr double kDegree = std::numbers::pi / 180;
constexpr double kWidestCorner = 165 * kDegree;  // a wider corner at a fixed node makes a degenerate quad
constexpr double kNearThreshold = 8 * kDegree;
constexpr double kTie = 2 * kDegree;

IdealValence ideal_valence(double angle) {
  IdealValence valence;
  valence.on_curve = true;
  valence.least = static_cast<std::uint8_t>(std::max(1.0, std::ceil(angle / kWidestCorner)));
  const int ideal = std::max<int>(valence.least, quads_for_angle(angle));
  valence.ideal = static_cast<std::uint8_t>(ideal);
  for (const double step : {-kNearThreshold, kNearThreshold}) {
    const int other = quads_for_angle(std::max(angle + step, kDegree));
    if (other != ideal && other >= valence.least) valence.second = static_cast<std::uint8_t>(other);
  }
  for (const double tie : {225 * kDegree, 315 * kDegree}) valence.is_tie |= std::abs(angle - tie) < kTie;
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
    mesh.for_each_sector(v, [&](HalfId first, HalfId, double angle) { ideal_[first] = ideal_valence(angle); });
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
