#include "stages/grid/hole_shape.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "domain/circle_parts.hpp"
#include "domain/size/size_sources.hpp"
#include "domain/walk_turns.hpp"

namespace quadline {

namespace {

constexpr std::array<double, kProposals> kRooms{0.3, 0.3, 0.8};  // sizes that rings take across, beside the hole
constexpr double kTwoRings = 0.35, kThreeRings = 0.175;  // a hole that takes less of its patch across gets so many
constexpr double kWayOut = 1.15;                         // from a hole to its patch, over that to the sides
constexpr double kMostFiner = 1.7;                       // squares of a patch for each that the hole would need
constexpr double kFiner = 1.01;                          // edges over those that the size of the cell asks for
constexpr double kAlike = 1e-3;                          // lengths that differ less are equal

bool is_about(double a, double b, double whole) { return std::abs(a - b) <= kAlike * whole; }

// The nearest whole number of the parity of another.
int nearest_like(double x, int other) {
  const int odd = other & 1;
  return 2 * static_cast<int>(std::floor(0.5 * (x - odd) + 0.5)) + odd;
}

}  // namespace

double edges_asked(const Domain& domain, const std::vector<DirectedCurve>& walk) {
  double sum = 0;
  for (const DirectedCurve& d : walk) {
    const Domain::Curve& curve = domain.curves[d.curve];
    sum += curve.edges > 0 ? curve.edges : length(curve.piece) / std::min(curve.size, base_size(domain, curve));
  }
  return sum;
}

double finer_edges(const Domain& domain, CellId c, const std::vector<DirectedCurve>& walk) {
  double around = 0;
  for (const DirectedCurve& d : walk) around += length(domain.curves[d.curve].piece);
  const double edges = edges_asked(domain, walk);
  return edges * domain.cells[c].size > kFiner * around ? edges : 0;
}

std::optional<HoleShape> shape_of(const Domain& domain, CellId c, const InnerWalk& inner, const GridFrame& frame) {
  const auto& walk = domain.cells[c].walks[inner.walk];
  HoleShape shape{.walk = inner.walk, .asked = edges_asked(domain, walk)};
  for (const DirectedCurve& d : walk) {
    shape.around += length(domain.curves[d.curve].piece);
    shape.area -= (d.reversed ? -0.5 : 0.5) * twice_area_under(domain.curves[d.curve].piece, domain.box.lo);
  }
  if (inner.circle) {
    shape.center = inner.circle->center;
    shape.radius = inner.circle->radius;
    shape.across = {2 * shape.radius, 2 * shape.radius};
    shape.arcs = 2;
    shape.given = given_edges(domain, walk);
    if (shape.given % 4 != 0 || shape.given == 4) return std::nullopt;
    return shape;
  }
  const std::vector<int> quads = quads_along(domain, walk);
  if (std::any_of(quads.begin(), quads.end(), [](int k) { return k != 2; })) return std::nullopt;
  if (walk.size() != 4 && walk.size() != 8) return std::nullopt;
  shape.arcs = static_cast<int>(walk.size() / 2);
  for (std::size_t n = 0; n < walk.size(); ++n) {
    const Domain::Curve &curve = domain.curves[walk[n].curve], &next = domain.curves[walk[(n + 1) % walk.size()].curve];
    if (curve.piece.is_arc() == next.piece.is_arc()) return std::nullopt;
    shape.center += (0.5 / static_cast<double>(walk.size())) * (curve.piece.a + curve.piece.b);
    if (curve.piece.is_arc()) shape.radius = curve.piece.radius;
  }
  for (const DirectedCurve& d : walk) {
    const CurvePiece& piece = domain.curves[d.curve].piece;
    const Point v = frame.to_frame(piece.b) - frame.to_frame(piece.a);
    if (!piece.is_arc() && std::min(std::abs(v.x), std::abs(v.y)) > kAlike * shape.around) return std::nullopt;
    if (!piece.is_arc()) shape.along = std::abs(v.x) > std::abs(v.y) ? 0 : 1;
    if (piece.is_arc() && !is_about(piece.radius, shape.radius, shape.around)) return std::nullopt;
    const Point off = frame.to_frame(piece.a) - frame.to_frame(shape.center);
    shape.across[0] = std::max(shape.across[0], 2 * std::abs(off.x));
    shape.across[1] = std::max(shape.across[1], 2 * std::abs(off.y));
  }
  if (shape.arcs == 2) shape.across[shape.along] += 2 * shape.radius;
  // Else it is not the one it looks like.
  const double round = (4 - std::numbers::pi) * shape.radius * shape.radius;
  if (!is_about(shape.area, shape.across[0] * shape.across[1] - round, shape.area)) return std::nullopt;
  return shape;
}

HoleCounts counts_of(const HoleShape& hole, double h, int variant, const Options& options) {
  const double turn = circle_edges(hole.radius, h, options.edges_per_circle);  // least edges on its arcs together
  HoleCounts counts;
  for (std::size_t side : {0u, 1u})
    counts.k[side] = std::max(
        2, static_cast<int>(std::floor(hole.across[side] / h + kRooms[static_cast<std::size_t>(variant)] + 0.5)));
  if (hole.given > 0) {
    counts.k[0] = counts.k[1] = static_cast<int>(hole.given / 4);
    counts.arc = hole.given / 2;
    counts.more_rings = kRooms[static_cast<std::size_t>(variant)] > kRooms[0] ? 1 : 0;
    return counts;
  }
  if (hole.is_circle()) {
    const double asked = std::floor(0.25 * hole.asked + 0.5);
    counts.k[0] = counts.k[1] = std::max({counts.k[0], static_cast<int>(0.25 * turn), static_cast<int>(asked)});
    counts.arc = static_cast<std::uint32_t>(2 * counts.k[0]);
    return counts;
  }
  const double edges = counts.edges() / hole.around;  // for each unit of length
  if (hole.arcs == 2) {
    const std::size_t along = hole.along;
    const double length = std::numbers::pi * hole.radius;
    const int arc =
        std::max(counts.k[1 - along], nearest_like(std::max(edges * length, 0.5 * turn), counts.k[1 - along]));
    counts.k[along] = std::max(counts.k[along], arc - counts.k[1 - along] + 1);
    counts.arc = static_cast<std::uint32_t>(arc);
    counts.straight[along] = static_cast<std::uint32_t>(counts.k[along] - (arc - counts.k[1 - along]));
    return counts;
  }
  const double length = 0.5 * std::numbers::pi * hole.radius;
  const int arc = std::max(2, nearest_like(std::max(edges * length, 0.25 * turn), 0));
  counts.arc = static_cast<std::uint32_t>(arc);
  for (std::size_t side : {0u, 1u}) {
    counts.k[side] = std::max(counts.k[side], arc + 1);
    counts.straight[side] = static_cast<std::uint32_t>(counts.k[side] - arc);
  }
  return counts;
}

bool is_too_fine(const HoleShape& hole, double h) {
  return hole.asked > 4 * kMostFiner * (std::max(hole.across[0], hole.across[1]) / h + 1);
}

void grow(HoleCounts& counts, const HoleShape& hole, std::size_t side) {
  ++counts.k[side];
  if (hole.is_circle()) {
    counts.k[1 - side] = counts.k[side];
    counts.arc += 2;
    return;
  }
  const bool is_across_slot = hole.arcs == 2 && side != hole.along;
  ++(is_across_slot ? counts.arc : counts.straight[side]);
}

int rings_of(const HoleShape& hole, const HoleCounts& counts, double h) {
  const double share = std::min(hole.across[0] / counts.k[0], hole.across[1] / counts.k[1]) / h;
  // As many as make the quads between about square, in the mean from the hole to the sides and corners of its patch.
  const double chord = 0.25 * std::numbers::pi * share;
  const int k = std::min(counts.k[0], counts.k[1]);
  const double square = kWayOut * k * (1 - share) / (1 + chord);
  return counts.more_rings + std::max({share < kThreeRings ? 3
                                       : share < kTwoRings ? 2
                                                           : 1,
                                       static_cast<int>(std::floor(square + 0.5))});
}

}  // namespace quadline
