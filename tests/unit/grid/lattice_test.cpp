#include "stages/grid/lattice.hpp"

#include <gtest/gtest.h>

#include "tests/unit/grid/grid_shapes.hpp"

namespace quadline {
namespace {

using shapes::WalkMaker;

const std::vector<GridPlace> kRectangle{{0, 0}, {5, 0}, {5, 3}, {0, 3}};
const std::vector<GridPlace> kL{{0, 0}, {6, 0}, {6, 2}, {2, 2}, {2, 5}, {0, 5}};
const std::vector<GridPlace> kT{{2, 0}, {4, 0}, {4, 3}, {6, 3}, {6, 5}, {0, 5}, {0, 3}, {2, 3}};
const std::vector<GridPlace> kSlit{{0, 0}, {3, 0}, {3, 2}, {3, 0}, {6, 0}, {6, 4}, {0, 4}};

// Puts one walk that begins at (0, 0) or, by `origin`, elsewhere.
bool put(Lattice& lattice, const NodeWalk& walk, GridPlace origin, int direction = 0) {
  std::vector<GridPlace> places = traced(walk, direction);
  for (GridPlace& p : places) p = {p.i + origin.i, p.j + origin.j};
  return lattice.put(walk, places);
}

TEST(Traced, AWalkThatTurnsOnceComesBack) {
  for (const auto& corners : {kRectangle, kL, kT, kSlit}) {
    WalkMaker maker;
    const NodeWalk walk = maker.walk(corners);
    EXPECT_EQ(walk.turns, 4);
    const std::vector<GridPlace> places = traced(walk, 0);
    ASSERT_EQ(places.size(), walk.nodes.size() + 1);
    EXPECT_EQ(places.back(), GridPlace{});
    for (std::size_t n = 0; n < walk.nodes.size(); ++n) {
      const GridPlace at{places[n].i + corners[0].i, places[n].j + corners[0].j};
      EXPECT_EQ(maker.node(at), walk.nodes[n].node);
    }
  }
}

TEST(Traced, TheDirectionTurnsItAll) {
  WalkMaker maker;
  const NodeWalk walk = maker.walk(kL);
  const std::vector<GridPlace> level = traced(walk, 0), up = traced(walk, 1), back = traced(walk, 2);
  for (std::size_t n = 0; n < level.size(); ++n) {
    EXPECT_EQ(up[n], (GridPlace{-level[n].j, level[n].i}));
    EXPECT_EQ(back[n], (GridPlace{-level[n].i, -level[n].j}));
  }
}

TEST(Traced, TheTurnOfTheFirstNodeIsThatOfTheDirection) {
  WalkMaker maker;
  NodeWalk walk = maker.walk(kRectangle);
  const std::vector<GridPlace> places = traced(walk, 0);
  walk.nodes[0].turn = -2;
  EXPECT_EQ(traced(walk, 0), places);
}

TEST(Traced, OppositeSidesThatDifferLeaveAGap) {
  WalkMaker maker;
  NodeWalk walk = maker.walk(kRectangle);
  walk.nodes.erase(walk.nodes.begin() + 2);
  EXPECT_EQ(traced(walk, 0).back(), (GridPlace{-1, 0}));
}

TEST(Traced, AWalkWithoutTurnsGoesStraight) {
  NodeWalk walk;
  for (std::size_t n = 0; n < 7; ++n) walk.nodes.push_back({NodeId(n), 0});
  EXPECT_EQ(traced(walk, 1).back(), (GridPlace{0, 7}));
  EXPECT_EQ(traced(walk, 3).back(), (GridPlace{0, -7}));
}

TEST(Lattice, KnowsTheInsideOfOneWalk) {
  const struct {
    std::vector<GridPlace> corners;
    int columns, rows, quads;
  } cases[] = {{kRectangle, 5, 3, 15}, {kL, 6, 5, 12 + 6}, {kT, 6, 5, 12 + 6}, {kSlit, 6, 4, 24}};
  for (const auto& c : cases) {
    WalkMaker maker;
    Lattice lattice(c.columns, c.rows, false);
    ASSERT_TRUE(put(lattice, maker.walk(c.corners), c.corners[0]));
    ASSERT_TRUE(lattice.find_inside());
    EXPECT_EQ(shapes::quad_count(lattice), c.quads);
  }
}

TEST(Lattice, TheInsideOfAnLIsWhereItIs) {
  WalkMaker maker;
  Lattice lattice(6, 5, false);
  ASSERT_TRUE(put(lattice, maker.walk(kL), {}));
  ASSERT_TRUE(lattice.find_inside());
  EXPECT_TRUE(lattice.is_quad(5, 1));
  EXPECT_TRUE(lattice.is_quad(1, 4));
  EXPECT_FALSE(lattice.is_quad(2, 2));
  EXPECT_TRUE(lattice.is_used({2, 5}));
  EXPECT_FALSE(lattice.is_used({3, 3}));
}

TEST(Lattice, ASlitHasItsNodesOnceAndIsBoundary) {
  WalkMaker maker;
  Lattice lattice(6, 4, false);
  ASSERT_TRUE(put(lattice, maker.walk(kSlit), {}));
  ASSERT_TRUE(lattice.find_inside());
  for (const int j : {0, 1, 2}) {
    EXPECT_EQ(lattice.node({3, j}), maker.node({3, j}));
    EXPECT_TRUE(lattice.is_on_boundary({3, j}));
  }
  EXPECT_FALSE(lattice.node({3, 3}).valid());
  EXPECT_FALSE(lattice.is_on_boundary({3, 3}));
}

TEST(Lattice, AClockwiseWalkInsideIsAHole) {
  WalkMaker maker;
  Lattice lattice(7, 6, false);
  ASSERT_TRUE(put(lattice, maker.walk({{0, 0}, {7, 0}, {7, 6}, {0, 6}}), {}));
  ASSERT_TRUE(put(lattice, maker.walk({{2, 2}, {2, 4}, {5, 4}, {5, 2}}), {2, 2}, 1));
  ASSERT_TRUE(lattice.find_inside());
  EXPECT_EQ(shapes::quad_count(lattice), 42 - 6);
  EXPECT_FALSE(lattice.is_quad(3, 3));
}

TEST(Lattice, RefusesTwoNodesAtOnePlace) {
  WalkMaker one, other;
  for (int n = 0; n < 100; ++n) other.node({-1, -n});  // its nodes are not those of the first
  Lattice lattice(7, 6, false);
  ASSERT_TRUE(put(lattice, one.walk({{0, 0}, {7, 0}, {7, 6}, {0, 6}}), {}));
  EXPECT_FALSE(put(lattice, other.walk({{0, 2}, {0, 4}, {5, 4}, {5, 2}}), {0, 2}, 1));
}

TEST(Lattice, RefusesWhatWindsTwice) {
  WalkMaker maker;
  Lattice lattice(7, 6, false);
  ASSERT_TRUE(put(lattice, maker.walk({{0, 0}, {7, 0}, {7, 6}, {0, 6}}), {}));
  ASSERT_TRUE(put(lattice, maker.walk({{2, 2}, {5, 2}, {5, 4}, {2, 4}}), {2, 2}));
  EXPECT_FALSE(lattice.find_inside());
}

TEST(Lattice, RefusesWhatWindsTheWrongWay) {
  WalkMaker maker;
  Lattice lattice(5, 3, false);
  ASSERT_TRUE(put(lattice, maker.walk({{0, 0}, {0, 3}, {5, 3}, {5, 0}}), {}, 1));
  EXPECT_FALSE(lattice.find_inside());
}

TEST(Lattice, RefusesPlacesBesideIt) {
  WalkMaker maker;
  Lattice lattice(4, 3, false);
  EXPECT_FALSE(put(lattice, maker.walk(kRectangle), {}));
  EXPECT_FALSE(put(lattice, maker.walk({{0, 0}, {2, 0}, {2, 2}, {0, 2}}), {0, -1}));
  EXPECT_FALSE(put(lattice, maker.walk({{0, 0}, {2, 0}, {2, 2}, {0, 2}}), {3, 0}));
}

class RingLattice : public testing::Test {
 protected:
  static constexpr int kRows = 12, kColumns = 4;
  RingLattice() {
    NodeWalk outer, inner;
    for (std::size_t n = 0; n < kRows; ++n) outer.nodes.push_back({NodeId(n), 0});
    for (std::size_t n = 0; n < kRows; ++n) inner.nodes.push_back({NodeId(kRows + n), 0});
    EXPECT_TRUE(put(lattice_, outer, {kColumns, 0}, 1));
    EXPECT_TRUE(put(lattice_, inner, {0, 5}, 3));
  }
  Lattice lattice_{kColumns, kRows, true};
};

TEST_F(RingLattice, IsAllInside) {
  ASSERT_TRUE(lattice_.find_inside());
  EXPECT_EQ(shapes::quad_count(lattice_), kRows * kColumns);
}

TEST_F(RingLattice, WrapsRows) {
  EXPECT_EQ(lattice_.node({kColumns, 0}), lattice_.node({kColumns, kRows}));
  EXPECT_EQ(lattice_.node({0, 5}), NodeId(kRows + std::size_t{0}));
  EXPECT_EQ(lattice_.node({0, -1}), NodeId(kRows + std::size_t{6}));  // six steps down from row 5
}

TEST_F(RingLattice, CutsPatchesOverRowZero) {
  ASSERT_TRUE(lattice_.find_inside());
  ASSERT_TRUE(lattice_.cut({{1, -1}, 2, 2}));
  for (const int j : {-1, 0, kRows - 1}) EXPECT_FALSE(lattice_.is_quad(1, j));
  EXPECT_TRUE(lattice_.is_quad(1, 1));
  EXPECT_EQ(shapes::quad_count(lattice_), kRows * kColumns - 4);
  EXPECT_FALSE(lattice_.cut({{1, kRows - 2}, 2, 2}));  // what is left out already
}

TEST_F(RingLattice, NoPatchGoesAllRound) {
  ASSERT_TRUE(lattice_.find_inside());
  EXPECT_FALSE(lattice_.cut({{1, 0}, 2, kRows}));
}

class CutLattice : public testing::Test {
 protected:
  CutLattice() {
    EXPECT_TRUE(put(lattice_, maker_.walk(kSlit), {}));
    EXPECT_TRUE(lattice_.find_inside());
  }
  WalkMaker maker_;
  Lattice lattice_{6, 4, false};
};

TEST_F(CutLattice, LeavesOutAPatch) {
  ASSERT_TRUE(lattice_.cut({{4, 1}, 2, 3}));
  EXPECT_EQ(shapes::quad_count(lattice_), 24 - 6);
  EXPECT_FALSE(lattice_.is_quad(4, 1));
  EXPECT_FALSE(lattice_.is_used({5, 2}));  // inside it
  EXPECT_TRUE(lattice_.is_used({4, 2}));   // on its rim
  EXPECT_TRUE(lattice_.is_used({5, 1}));
}

TEST_F(CutLattice, RefusesPatchesBeyondTheEdge) {
  EXPECT_FALSE(lattice_.cut({{5, 1}, 2, 2}));
  EXPECT_FALSE(lattice_.cut({{-1, 1}, 2, 2}));
  EXPECT_FALSE(lattice_.cut({{1, 3}, 2, 2}));
}

TEST_F(CutLattice, RefusesPatchesOverALine) {
  EXPECT_TRUE(lattice_.cut({{1, 0}, 2, 1}));  // beside it
  EXPECT_TRUE(lattice_.cut({{3, 0}, 2, 1}));
  EXPECT_FALSE(lattice_.cut({{2, 1}, 2, 3}));
}

TEST_F(CutLattice, RefusesPatchesThatOverlap) {
  EXPECT_TRUE(lattice_.cut({{0, 0}, 2, 2}));
  EXPECT_TRUE(lattice_.cut({{0, 2}, 2, 2}));
  EXPECT_FALSE(lattice_.cut({{1, 1}, 2, 2}));
}

}  // namespace
}  // namespace quadline
