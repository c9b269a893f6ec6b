// The ring between two concentric circles: rays and circles, whose quads are squares where the radii grow by a factor
// from circle to circle.
#include <algorithm>
#include <array>
#include <cmath>

#include "base/constants.hpp"
#include "base/elementary.hpp"
#include "domain/circle_parts.hpp"
#include "geom/angles.hpp"
#include "stages/grid/grid_stops.hpp"
#include "stages/grid/hole_shape.hpp"
#include "stages/grid/propose_grid.hpp"

namespace quadline {

namespace {

constexpr double kConcentric = 1e-6;   // of the radius
constexpr double kLargestRatio = 3.5;  // of the radii: edges would get too unequal
constexpr double kTogether = 0.15;     // rows: holes so near get one ray
constexpr double kMostRays = 6;        // over those that the quads want
constexpr int kLeastRays = 8;
constexpr std::array<double, kProposals> kDenser{1, 1.12, 1.25};
constexpr double kDensities[] = {1, 1.06, 0.94, 1.12, 0.88, 1.18, 1.25};  // tried in turn

class RingGrid {
 public:
  RingGrid(const Domain& domain, CellId c, const WholeCircle& outer, const InnerWalk& inner,
           const std::vector<InnerWalk>& others)
      : outer_(outer), ratio_(outer.radius / inner.circle->radius) {
    const auto& walks = domain.cells[c].walks;
    for (const std::size_t walk : {std::size_t{0}, inner.walk})
      asked_ = std::max(asked_, finer_edges(domain, c, walks[walk]));
    given_ = {given_edges(domain, walks[0]), given_edges(domain, walks[inner.walk])};
    plan_.frame = {outer.center, {1, 0}, true};
    plan_.inner = inner.walk;
    for (const InnerWalk& other : others) {
      const double r = other.circle->radius;
      holes_.push_back({.walk = other.walk,
                        .center = other.circle->center,
                        .across = {2 * r, 2 * r},
                        .radius = r,
                        .arcs = 2,
                        .asked = edges_asked(domain, walks[other.walk]),
                        .given = given_edges(domain, walks[other.walk])});
    }
    if (!holes_.empty()) plan_.frame.axis = unit(holes_[0].center - outer.center);
    // From the first on, which is at 0, whatever rounding makes of its angle.
    std::sort(holes_.begin() + (holes_.empty() ? 0 : 1), holes_.end(), [&](const HoleShape& a, const HoleShape& b) {
      return plan_.frame.to_frame(a.center).y < plan_.frame.to_frame(b.center).y;
    });
  }

  // Rays: for the quads that are asked for, or as the gaps between the holes round to. False where the two circles
  // cannot have so many in two equal arcs of an even number each.
  bool count_rays(double quads, int variant, const std::optional<GivenCircle>& given, const Options& options) {
    if (!can_have_given(given)) return false;
    const std::uint32_t asked = std::max(given_[0], given_[1]);
    const double by_area = std::sqrt(kFullTurn * quads / logarithm(ratio_)),
                 wanted = asked > 0 ? asked : std::max(asked_, by_area);
    if (wanted > kMostRays * by_area) return false;
    start_ = given ? given->start : plan_.frame.axis;
    if (holes_.empty()) {
      if (variant > 0) return false;
      rays_ = given       ? static_cast<int>(given->rays)
              : asked > 0 ? static_cast<int>(asked)
                          : std::max(kLeastRays, 4 * static_cast<int>(std::floor(0.25 * wanted + 0.5)));
      return true;
    }
    if (given) return false;
    for (const double density : kDensities) {
      plan_.holes.clear();
      rays_ = place_holes(density * kDenser[static_cast<std::size_t>(variant)] * wanted, options);
      if (asked > 0 ? rays_ == static_cast<int>(asked) : rays_ % 4 == 0 && rays_ >= kLeastRays) return true;
    }
    return false;
  }

  GridProposal proposal(const Domain& domain, CellId c) {
    GridProposal proposal{std::move(plan_), {}, {{0, start_}, {plan_.inner, start_}}};
    const auto& walks = domain.cells[c].walks;
    for (const std::size_t w : {std::size_t{0}, proposal.plan.inner})
      for (const DirectedCurve& d : walks[w])
        proposal.wishes.push_back({d.curve, static_cast<std::uint32_t>(rays_ / 2)});
    for (const GridHole& hole : proposal.plan.holes) {
      const Point out = hole.at - outer_.center;
      proposal.turns.push_back({hole.walk, out + left_normal(out)});
      for (const DirectedCurve& d : walks[hole.walk])
        proposal.wishes.push_back({d.curve, static_cast<std::uint32_t>(2 * hole.rows)});
    }
    return proposal;
  }

 private:
  static Point unit(Point v) { return (1 / norm(v)) * v; }

  // Numbers of edges that circles are to have are the same for both, and multiples of four.
  bool can_have_given(const std::optional<GivenCircle>& given) const {
    for (const std::uint32_t edges : given_) {
      if (edges % 4 != 0 || (edges > 0 && given && given->rays != edges)) return false;
      if (edges > 0 && given_[0] + given_[1] != edges && given_[0] != given_[1]) return false;
    }
    return std::all_of(holes_.begin(), holes_.end(), [](const HoleShape& hole) { return hole.given % 4 == 0; });
  }

  // Returns how many rays there are. The first hole has one in its middle, or two beside it. None where a hole asks for
  // too many.
  int place_holes(double wanted, const Options& options) {
    std::vector<GridStop> stops;
    for (const HoleShape& hole : holes_) {
      const double spacing = distance(hole.center, outer_.center) * kFullTurn / wanted;
      const HoleCounts counts = counts_of(hole, spacing, 0, options);
      stops.push_back({stops.empty() ? 0 : plan_.frame.to_frame(hole.center).y, counts.k[1], 0, 1});
      if (is_too_fine(hole, spacing)) return 0;
      plan_.holes.push_back({hole.walk, counts.k[0], counts.k[1], rings_of(hole, counts, spacing), hole.center});
    }
    GridStop again = stops.front();
    again.at = kFullTurn;
    stops.push_back(again);
    place_stops(stops, wanted / kFullTurn, kTogether * kFullTurn / wanted);
    const int rays = static_cast<int>(stops.back().index);
    start_ = again.k % 2 != 0 ? turned(plan_.frame.axis, 0.5 * kFullTurn / rays) : plan_.frame.axis;
    return rays;
  }

  WholeCircle outer_;
  double ratio_;
  double asked_ = 0;                      // rays, by circles that are finer than the cell
  std::array<std::uint32_t, 2> given_{};  // edges that the outer and the inner circle are to have
  std::vector<HoleShape> holes_;          // by angle
  GridPlan plan_;
  Point start_{};
  int rays_ = 0;
};

}  // namespace

std::optional<GridProposal> propose_ring(const Domain& domain, CellId c, const WholeCircle& outer,
                                         const std::vector<InnerWalk>& holes, int variant,
                                         const std::optional<GivenCircle>& given, const Options& options) {
  std::optional<InnerWalk> inner;
  std::vector<InnerWalk> others;
  for (const InnerWalk& hole : holes) {
    if (!hole.circle) return std::nullopt;
    if (!inner && distance(hole.circle->center, outer.center) < kConcentric * outer.radius)
      inner = hole;
    else
      others.push_back(hole);
  }
  if (!inner || outer.radius > kLargestRatio * inner->circle->radius) return std::nullopt;
  RingGrid grid(domain, c, outer, *inner, others);
  if (!grid.count_rays(quads_asked(domain, c), variant, given, options)) return std::nullopt;
  return grid.proposal(domain, c);
}

}  // namespace quadline
