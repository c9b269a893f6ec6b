// A disk: a square grid with rings round it, whose counts follow from the edges on the circle.
#include <algorithm>
#include <cmath>

#include "domain/circle_parts.hpp"
#include "domain/size/size_sources.hpp"
#include "stages/grid/hole_shape.hpp"
#include "stages/grid/propose_grid.hpp"

namespace quadline {

namespace {

constexpr double kSide = 1.17;         // edges on a side of the grid, in radii over size
constexpr double kFewestRings = 0.24;  // for each of these edges: fewer would be longer than the edges of the circle
constexpr double kMostFiner = 4;       // edges over those: where the circle is so much finer the sizes had better grade

// A quarter of what the circle must have; 0 where that is no whole number.
int least_side(const Domain& domain, CellId c, const WholeCircle& circle, const std::optional<GivenCircle>& given,
               const Options& options) {
  const auto& walk = domain.cells[c].walks[0];
  const std::uint32_t own = given_edges(domain, walk), exact = own > 0 || !given ? own : given->rays;
  if (exact > 0) return exact % 4 == 0 ? static_cast<int>(exact / 4) : 0;
  const double bend = circle_edges(circle.radius, domain.cells[c].size, options.edges_per_circle);
  return std::max(1, static_cast<int>(std::ceil(0.25 * std::max(bend, finer_edges(domain, c, walk)))));
}

// As many as make the quads that are asked for.
int rings(double quads, int side) {
  const double n = side, by_area = (quads - n * n) / (4 * n);
  return std::max(1, static_cast<int>(std::floor(std::max(by_area, kFewestRings * n) + 0.5)));
}

}  // namespace

std::optional<GridProposal> propose_disk(const Domain& domain, CellId c, const WholeCircle& circle,
                                         const std::optional<GivenCircle>& given, const Options& options) {
  const auto& walk = domain.cells[c].walks[0];
  const double wanted = kSide * circle.radius / domain.cells[c].size;
  const int least = least_side(domain, c, circle, given, options);
  const bool is_exact = given || given_edges(domain, walk) > 0;
  if (least == 0 || least > kMostFiner * (wanted + 1)) return std::nullopt;
  const int side = is_exact ? least : std::max(least, static_cast<int>(std::floor(wanted + 0.5)));
  GridProposal proposal;
  proposal.plan.is_disk = true;
  proposal.plan.rows = rings(quads_asked(domain, c), side);
  proposal.plan.frame.origin = circle.center;
  for (const DirectedCurve& d : walk) proposal.wishes.push_back({d.curve, static_cast<std::uint32_t>(2 * side)});
  proposal.turns.push_back({0, given ? given->start : Point{1, 1}});
  return proposal;
}

}  // namespace quadline
