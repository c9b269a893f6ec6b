#include "stages/grid/plan_grids.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "base/constants.hpp"
#include "domain/circle_parts.hpp"
#include "domain/size/size_sources.hpp"
#include "domain/whole_circle.hpp"
#include "stages/grid/hole_shape.hpp"

namespace quadline {

namespace {

constexpr double kSameSize = 0.99;  // sizes that differ less are one

using Cost = std::function<double(const Domain&, CellId, const GridProposal&)>;

void mark_rings(Domain& domain, CellId c, const GridProposal& proposal, bool has_rings) {
  for (const GridHole& hole : proposal.plan.holes)
    for (const DirectedCurve& d : domain.cells[c].walks[hole.walk]) domain.curves[d.curve].has_rings = has_rings;
  if (proposal.plan.rings == 0) return;
  for (const DirectedCurve& d : domain.cells[c].walks[1])
    if (domain.curves[d.curve].is_boundary()) domain.curves[d.curve].has_rings = has_rings;
}

void add_wishes(GridPlans& plans, const GridProposal& proposal) {
  for (const CountWish& wish : proposal.wishes)
    plans.counts[wish.curve] = std::max(plans.counts[wish.curve], wish.count);
}

class Planner {
 public:
  Planner(Domain& domain, const Options& options, const Cost& cost)
      : domain_(domain), options_(options), cost_(cost), circles_(domain) {
    plans_.cells.assign(domain.cells.count(), std::nullopt);
    plans_.counts.assign(domain.curves.count(), 0);
    is_turned_.assign(domain.curves.count(), false);
  }

  // What rings of the model get from the grids round them they have for good: the other grids are planned for that.
  GridPlans run() {
    plan_cells();
    if (number_rings()) {
      CellSet all;
      for (std::size_t i = 0; i < domain_.cells.count(); ++i) all.insert(CellId(i));
      plans_.drop(all, domain_);
      is_turned_.assign(domain_.curves.count(), false);
      plan_cells();
    }
    for (std::size_t i = 0; i < domain_.cells.count(); ++i)
      if (domain_.cells[CellId(i)].rings > 0) plan_rings(CellId(i));
    plan_disks();
    return std::move(plans_);
  }

 private:
  bool has_grids() const { return options_.method == Method::Layout && !options_.size_at; }

  void plan_cells() {
    if (!has_grids()) return;
    // Rings come last: their circles may be holes of other cells, and follow them.
    for (const bool is_ring : {false, true})
      for (std::size_t i = 0; i < domain_.cells.count(); ++i) {
        const CellId c(i);
        const std::optional<WholeCircle> outer = circles_.find(domain_, walk(c, 0));
        if (outer.has_value() != is_ring || domain_.cells[c].rings > 0 || !has_one_size(c)) continue;
        plan(c, outer, inner_walks(c));
      }
  }

  // Both circles of rings that are given no number of edges get that of the grid round them, or what suits them.
  bool number_rings() {
    bool is_any = false;
    for (std::size_t i = 0; i < domain_.cells.count(); ++i) {
      const Domain::Cell& cell = domain_.cells[CellId(i)];
      if (cell.rings == 0 || given_edges(domain_, cell.walks[0]) > 0) continue;
      std::uint32_t edges = 0;
      for (const DirectedCurve& d : cell.walks[0]) edges += plans_.counts[d.curve];
      if (edges == 0) edges = common_edges(cell);
      for (const auto& circle : cell.walks) share_edges(domain_, circle, edges);
      is_any = true;
    }
    return is_any;
  }

  // Between what the inner and what the outer circle ask for; such that halves and quarters are even.
  std::uint32_t common_edges(const Domain::Cell& cell) const {
    double product = 1;
    for (const auto& circle : cell.walks) {
      const double radius = domain_.curves[circle[0].curve].piece.radius;
      product *= std::max(edges_asked(domain_, circle), circle_edges(radius, cell.size, options_.edges_per_circle));
    }
    const std::uint32_t step = options_.method == Method::Merge || options_.method == Method::Split ? 8 : 4;
    const double steps = std::floor(std::sqrt(product) / step + 0.5);
    return step * static_cast<std::uint32_t>(std::clamp(steps, 2.0, 0.25 * kMostCircleEdges));
  }

  // Where both circles may be turned they are turned alike, as the grid outside wants it or else the one inside.
  void plan_rings(CellId c) {
    const auto &outer = walk(c, 0), &inner = walk(c, 1);
    if (circles_.find(domain_, outer) && circles_.find(domain_, inner)) {
      const bool follows = is_turned_[outer[0].curve] || !is_turned_[inner[0].curve];
      if (follows && is_turned_[inner[0].curve]) drop_inside(inner[0]);
      const auto &leader = follows ? outer : inner, &other = follows ? inner : outer;
      const CurvePiece& piece = domain_.curves[leader[0].curve].piece;
      WholeCircles::turn(domain_, other, piece.a - piece.center);
      for (const auto& circle : {outer, inner})
        for (const DirectedCurve& d : circle) is_turned_[d.curve] = true;
    }
    GridProposal proposal;
    proposal.plan.frame.origin = domain_.curves[outer[0].curve].piece.center;
    proposal.plan.rings = static_cast<int>(domain_.cells[c].rings);
    mark_rings(domain_, c, proposal, true);
    plans_.cells[c] = std::move(proposal);
  }

  void drop_inside(DirectedCurve d) {
    const Domain::Curve& curve = domain_.curves[d.curve];
    const CellId inside = d.reversed ? curve.left : curve.right;
    CellSet dropped;
    if (inside.valid()) dropped.insert(inside);
    plans_.drop(dropped, domain_);
  }

  const std::vector<DirectedCurve>& walk(CellId c, std::size_t w) const { return domain_.cells[c].walks[w]; }

  bool has_one_size(CellId c) const {
    const Domain::Cell& cell = domain_.cells[c];
    if (cell.walks.size() < 2 || !cell.lone_points.empty()) return false;
    const auto is_less = [&](CellId other) {
      return other.valid() && domain_.cells[other].size < kSameSize * cell.size;
    };
    for (const auto& curves : cell.walks) {
      if (circles_.find(domain_, curves)) continue;  // rings grade
      for (const DirectedCurve& d : curves) {
        const Domain::Curve& curve = domain_.curves[d.curve];
        if (curve.size < kSameSize * cell.size || is_less(curve.left) || is_less(curve.right)) return false;
      }
    }
    return true;
  }

  std::vector<InnerWalk> inner_walks(CellId c) const {
    std::vector<InnerWalk> inner;
    for (std::size_t w = 1; w < domain_.cells[c].walks.size(); ++w)
      inner.push_back({w, circles_.find(domain_, walk(c, w))});
    return inner;
  }

  // At last: their circles may be holes of grids, or of rings.
  void plan_disks() {
    for (std::size_t i = 0; has_grids() && i < domain_.cells.count(); ++i)
      if (const CellId c(i); domain_.cells[c].walks.size() == 1 && domain_.cells[c].lone_points.empty())
        if (const std::optional<WholeCircle> circle = circles_.find(domain_, walk(c, 0))) plan_disk(c, *circle);
  }

  void plan_disk(CellId c, const WholeCircle& circle) {
    std::optional<GridProposal> proposal = propose_disk(domain_, c, circle, given(walk(c, 0)), options_);
    if (proposal && cost(c, *proposal) < kInfinity) keep(c, std::move(*proposal));
  }

  // In the domain as it is turned for it, and then turned back.
  double cost(CellId c, const GridProposal& proposal) {
    const std::vector<GridProposal::Turn> back = turn(c, proposal.turns);
    mark_rings(domain_, c, proposal, true);
    const double cost = cost_(domain_, c, proposal);
    mark_rings(domain_, c, proposal, false);
    turn(c, back);
    return cost;
  }

  void plan(CellId c, const std::optional<WholeCircle>& outer, const std::vector<InnerWalk>& holes) {
    std::optional<GridProposal> best;
    double least = kInfinity;
    for (int variant = 0; variant < kProposals && !(outer && best); ++variant) {
      std::optional<GridProposal> proposal =
          outer ? propose_ring(domain_, c, *outer, holes, variant, given(walk(c, 0)), options_)
                : propose_straight(domain_, c, holes, variant, options_);
      if (!proposal) continue;
      const double cost = this->cost(c, *proposal);
      if (!(cost < least)) continue;
      least = cost;
      best = std::move(proposal);
    }
    if (best) keep(c, std::move(*best));
  }

  std::optional<GivenCircle> given(const std::vector<DirectedCurve>& curves) const {
    if (!is_turned_[curves[0].curve]) return std::nullopt;
    const CurvePiece& piece = domain_.curves[curves[0].curve].piece;
    return GivenCircle{piece.a - piece.center, 2 * plans_.counts[curves[0].curve]};
  }

  // Returns what turns them back.
  std::vector<GridProposal::Turn> turn(CellId c, const std::vector<GridProposal::Turn>& turns) {
    std::vector<GridProposal::Turn> back;
    for (const GridProposal::Turn& t : turns) {
      const Domain::Curve& curve = domain_.curves[walk(c, t.walk)[0].curve];
      back.push_back({t.walk, domain_.vertices[curve.tail].at - curve.piece.center});
      if (!is_turned_[walk(c, t.walk)[0].curve]) WholeCircles::turn(domain_, walk(c, t.walk), t.direction);
    }
    return back;
  }

  void keep(CellId c, GridProposal proposal) {
    turn(c, proposal.turns);
    for (const GridProposal::Turn& t : proposal.turns)
      for (const DirectedCurve& d : walk(c, t.walk)) is_turned_[d.curve] = true;
    mark_rings(domain_, c, proposal, true);
    add_wishes(plans_, proposal);
    plans_.cells[c] = std::move(proposal);
  }

  Domain& domain_;
  const Options& options_;
  const Cost& cost_;
  WholeCircles circles_;
  IdVector<CurveId, bool> is_turned_;  ///< as a cell wants it
  GridPlans plans_;
};

}  // namespace

void GridPlans::drop(const CellSet& dropped, Domain& domain) {
  for (std::size_t i = 0; i < cells.count(); ++i) {
    const CellId c(i);
    if (!cells[c] || !dropped.contains(c)) continue;
    mark_rings(domain, c, *cells[c], false);
    cells[c].reset();
  }
  counts.assign(counts.count(), 0);
  for (const std::optional<GridProposal>& proposal : cells)
    if (proposal) add_wishes(*this, *proposal);
}

GridPlans plan_grids(Domain& domain, const Options& options, const Cost& cost) {
  return Planner(domain, options, cost).run();
}

}  // namespace quadline
