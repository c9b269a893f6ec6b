#include "stages/grid/grid_map.hpp"

#include <gtest/gtest.h>

namespace quadline {
namespace {

TEST(GridMap, IsLinearBetweenNodes) {
  const GridMap map({{0, 0}, {2, 4}, {3, 5}, {7, 6}});
  ASSERT_TRUE(map.is_valid());
  EXPECT_DOUBLE_EQ(map.to_grid(1), 2);
  EXPECT_DOUBLE_EQ(map.to_grid(2), 4);
  EXPECT_DOUBLE_EQ(map.to_grid(5), 5.5);
  EXPECT_DOUBLE_EQ(map.to_frame(3), 1.5);
  EXPECT_DOUBLE_EQ(map.to_frame(5.25), 4);
}

TEST(GridMap, GrowsAndHasAnInverse) {
  const GridMap map({{7, 6}, {0, 0}, {3, 5}, {2, 4}});  // in any order
  ASSERT_TRUE(map.is_valid());
  double last = map.to_grid(-1.1);
  for (double at = -1; at < 9; at += 0.1) {
    EXPECT_GT(map.to_grid(at), last);
    last = map.to_grid(at);
    EXPECT_NEAR(map.to_frame(last), at, 1e-12);
  }
}

TEST(GridMap, GoesOnBeyondItsEnds) {
  const GridMap map({{0, 0}, {2, 4}, {3, 5}});
  EXPECT_DOUBLE_EQ(map.to_grid(-1), -2);
  EXPECT_DOUBLE_EQ(map.to_grid(5), 7);
  EXPECT_DOUBLE_EQ(map.to_frame(-2), -1);
  EXPECT_DOUBLE_EQ(map.to_frame(7), 5);
}

TEST(GridMap, TakesTheMeanOfNodesWithOneIndex) {
  const GridMap map({{0, 0}, {1.8, 2}, {2.2, 2}, {2.3, 2}, {4, 4}});
  ASSERT_TRUE(map.is_valid());
  EXPECT_NEAR(map.to_frame(2), 2.1, 1e-12);
}

TEST(GridMap, RefusesWhatDoesNotGrow) {
  EXPECT_FALSE(GridMap({{0, 0}, {3, 1}, {2, 2}}).is_valid());
  EXPECT_FALSE(GridMap({{0, 0}, {1, 1}, {1, 2}}).is_valid());
  EXPECT_FALSE(GridMap({{1, 0}, {0, 1}}).is_valid());
}

TEST(GridMap, RefusesFewerThanTwoIndices) {
  EXPECT_FALSE(GridMap({}).is_valid());
  EXPECT_FALSE(GridMap({{0, 3}, {1, 3}}).is_valid());
}

}  // namespace
}  // namespace quadline
