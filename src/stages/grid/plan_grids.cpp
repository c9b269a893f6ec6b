#include "stages/grid/plan_grids.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include "base/constants.hpp"
#include "domain/whole_circle.hpp"

namespace quadline {

namespace {

constexpr double kSameSize = 0.99;  // sizes that differ less are one

using Cost = std::function<double(const Domain&, CellId, const GridProposal&)>;

void mark_rings(Domain& domain, CellId c, const GridProposal& proposal, bool has_rings) {
  for (const GridHole& hole : proposal.plan.holes)
    for (const DirectedCurve& d : domain.cells[c].walks[hole.walk]) domain.curves[d.curve].has_rings = has_rings;
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

  GridPlans run() {
    if (options_.size_at) return std::move(plans_);
    // Rings come last: their circles may be holes of other cells, and follow them.
    for (const bool is_ring : {false, true})
      for (std::size_t i = 0; i < domain_.cells.count(); ++i) {
        const CellId c(i);
        const std::optional<WholeCircle> outer = circles_.find(domain_, walk(c, 0));
        if (outer.has_value() != is_ring || domain_.cells[c].is_ring || !has_one_size(c)) continue;
        plan(c, outer, inner_walks(c));
      }
    for (const Domain::Washer& washer : domain_.washers) follow(washer);
    for (std::size_t i = 0; i < domain_.cells.count(); ++i)
      if (const CellId c(i); domain_.cells[c].walks.size() == 1 && domain_.cells[c].lone_points.empty())
        if (const std::optional<WholeCircle> circle = circles_.find(domain_, walk(c, 0))) plan_disk(c, *circle);
    return std::move(plans_);
  }

 private:
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

  // Where a grid has turned the outermost circle of a washer, the others turn with it and have its edges.
  void follow(const Domain::Washer& washer) {
    const std::optional<GivenCircle> outermost = given(washer.circles.back());
    if (!outermost) return;
    for (const std::vector<DirectedCurve>& circle : washer.circles) {
      if (is_turned_[circle[0].curve] || !circles_.find(domain_, circle)) continue;
      WholeCircles::turn(domain_, circle, outermost->start);
      for (const DirectedCurve& d : circle) {
        is_turned_[d.curve] = true;
        plans_.counts[d.curve] = outermost->rays / 2;
      }
    }
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
