#include "cells/rehearse_grid.hpp"

#include <gtest/gtest.h>

#include <optional>

#include "base/constants.hpp"
#include "domain/whole_circle.hpp"
#include "tests/unit/cells/grid_cells.hpp"

namespace quadline {
namespace {

const CellId kCell(std::size_t{0});

// The first proposal for a plate, in the domain as it wants it.
struct Proposed {
  explicit Proposed(double radius) : domain(shapes::arranged(shapes::square_plate({{{6, 6}, radius}}))) {
    plan_grids(domain, {}, [&](const Domain& turned, CellId, const GridProposal& one) {
      if (!proposal) {
        proposal = one;
        as_turned = turned;
      }
      return kInfinity;
    });
  }
  double cost() const { return rehearsed_cost(as_turned, kCell, *proposal); }

  Domain domain, as_turned;
  std::optional<GridProposal> proposal;
};

TEST(RehearsedCost, OfAGoodGridIsSmall) {
  const Proposed plate(1.3);
  ASSERT_TRUE(plate.proposal);
  EXPECT_GT(plate.cost(), 0);
  EXPECT_LT(plate.cost(), 0.1);  // four irregular nodes, some 140 quads of good beta
}

TEST(RehearsedCost, IsInfiniteWhereTheEdgesOnTheHoleAreTooLong) {
  Proposed plate(2.6);
  ASSERT_LT(plate.cost(), kInfinity);
  GridHole& hole = plate.proposal->plan.holes[0];
  const int k = 2;
  hole.columns = hole.rows = k;
  for (CountWish& wish : plate.proposal->wishes)
    if (plate.domain.curves[wish.curve].piece.is_arc()) wish.count = 2 * k;
  EXPECT_EQ(plate.cost(), kInfinity);
}

TEST(RehearsedCost, IsInfiniteWhereCountsDoNotClose) {
  Proposed plate(1.3);
  for (CountWish& wish : plate.proposal->wishes)
    if (!plate.domain.curves[wish.curve].piece.is_arc()) {
      ++wish.count;
      break;
    }
  EXPECT_EQ(plate.cost(), kInfinity);
}

TEST(RehearsedCost, DecidesWhatIsPlanned) {
  Domain domain = shapes::arranged(shapes::square_plate({{{6, 6}, 1.3}}));
  EXPECT_TRUE(plan_grids(domain, {}, rehearsed_cost).cells[kCell]);
  Domain narrow = shapes::arranged(shapes::square_plate({{{6, 6}, 5.8}}));  // 0.2 from the edges
  EXPECT_FALSE(plan_grids(narrow, {}, rehearsed_cost).cells[kCell]);
}

}  // namespace
}  // namespace quadline
