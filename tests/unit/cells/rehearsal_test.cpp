#include "cells/rehearsal.hpp"

#include <gtest/gtest.h>

#include <optional>

#include "base/constants.hpp"
#include "domain/whole_circle.hpp"
#include "tests/unit/cells/grid_cells.hpp"

namespace quadline {
namespace {

const CellId kCell(std::size_t{0});

bool is_planned(Domain& domain) {
  Context context;
  Rehearsal rehearsal(context);
  const GridPlans plans = plan_grids(domain, {}, [&](const Domain& turned, CellId c, const GridProposal& proposal) {
    return rehearsal.cost(turned, c, proposal);
  });
  return plans.cells[kCell].has_value();
}

Model moved_plate(double radius, Point by) {
  Model model = shapes::square_plate({{Point{6, 6} + by, radius}});
  for (PathItem& item : model.outer[0].items) item.to += by;
  return model;
}

// The first proposal for a plate, in the domain as it wants it.
struct Proposed {
  explicit Proposed(double radius, Point by = {}) : domain(shapes::arranged(moved_plate(radius, by))) {
    plan_grids(domain, {}, [&](const Domain& turned, CellId, const GridProposal& one) {
      if (!proposal) {
        proposal = one;
        as_turned = turned;
      }
      return kInfinity;
    });
  }
  double cost() const {
    Context context;
    return Rehearsal(context).cost(as_turned, kCell, *proposal);
  }

  Domain domain, as_turned;
  std::optional<GridProposal> proposal;
};

TEST(Rehearsal, OfAGoodGridIsSmall) {
  const Proposed plate(1.3);
  ASSERT_TRUE(plate.proposal);
  EXPECT_GT(plate.cost(), 0);
  EXPECT_LT(plate.cost(), 0.1);  // four irregular nodes, some 140 quads of good beta
}

TEST(Rehearsal, IsInfiniteWhereTheEdgesOnTheHoleAreTooLong) {
  Proposed plate(2.6);
  ASSERT_LT(plate.cost(), kInfinity);
  GridHole& hole = plate.proposal->plan.holes[0];
  const int k = 2;
  hole.columns = hole.rows = k;
  for (CountWish& wish : plate.proposal->wishes)
    if (plate.domain.curves[wish.curve].piece.is_arc()) wish.count = 2 * k;
  EXPECT_EQ(plate.cost(), kInfinity);
}

TEST(Rehearsal, IsInfiniteWhereCountsDoNotClose) {
  Proposed plate(1.3);
  for (CountWish& wish : plate.proposal->wishes)
    if (!plate.domain.curves[wish.curve].piece.is_arc()) {
      ++wish.count;
      break;
    }
  EXPECT_EQ(plate.cost(), kInfinity);
}

TEST(Rehearsal, DecidesWhatIsPlanned) {
  Domain domain = shapes::arranged(shapes::square_plate({{{6, 6}, 1.3}}));
  EXPECT_TRUE(is_planned(domain));
  Domain narrow = shapes::arranged(shapes::square_plate({{{6, 6}, 5.8}}));  // 0.2 from the edges
  EXPECT_FALSE(is_planned(narrow));
}

// By the time that it takes: nothing is asked of a context by what is known.
TEST(Rehearsal, OfLikeProposalsOneIsTried) {
  int n_asked = 0;
  Context context;
  context.is_cancelled = [&] { return ++n_asked, false; };
  Rehearsal rehearsal(context);
  const Proposed plate(1.3), moved(1.3, {100, -7}), other(1.4);
  const double cost = rehearsal.cost(plate.as_turned, kCell, *plate.proposal);
  const int n_first = n_asked;
  EXPECT_GT(n_first, 0);
  EXPECT_EQ(rehearsal.cost(moved.as_turned, kCell, *moved.proposal), cost);
  EXPECT_EQ(n_asked, n_first);
  rehearsal.cost(other.as_turned, kCell, *other.proposal);
  EXPECT_GT(n_asked, n_first);
}

TEST(Rehearsal, CancellingStopsIt) {
  Context context;
  context.is_cancelled = [] { return true; };
  const Proposed plate(1.3);
  EXPECT_THROW(Rehearsal(context).cost(plate.as_turned, kCell, *plate.proposal), Cancelled);
}

}  // namespace
}  // namespace quadline
