#include "stages/grid/walk_nodes.hpp"

#include <gtest/gtest.h>

#include "tests/unit/grid/grid_shapes.hpp"

namespace quadline {
namespace {

const CellId kCell(std::size_t{0});

std::vector<int> turns_of(const NodeWalk& walk) {
  std::vector<int> turns;
  for (const WalkNode& w : walk.nodes) turns.push_back(w.turn);
  return turns;
}

TEST(WalksOf, ARectangleTurnsAtItsCorners) {
  const Domain domain = shapes::rectangle(3, 2, 1);
  const std::vector<NodeWalk> walks = walks_of(shapes::nodes_on(domain, {3, 2, 3, 2}), domain, kCell);
  ASSERT_EQ(walks.size(), 1u);
  EXPECT_EQ(walks[0].turns, 4);
  EXPECT_EQ(turns_of(walks[0]), (std::vector<int>{1, 0, 0, 1, 0, 1, 0, 0, 1, 0}));
}

TEST(WalksOf, NodesFollowEachOther) {
  const Domain domain = shapes::plate_with_hole(6, 5, {3, 2.5}, 1);
  const WorkMesh mesh = shapes::nodes_on(domain, {6, 5, 6, 5, 4, 4});
  const std::vector<NodeWalk> walks = walks_of(mesh, domain, kCell);
  ASSERT_EQ(walks.size(), 2u);
  double area = 0;  // twice that of the plate without the hole, whose walk is clockwise
  for (const NodeWalk& walk : walks)
    for (std::size_t n = 0; n < walk.nodes.size(); ++n)
      area += cross(mesh.point(walk.nodes[n].node), mesh.point(walk.nodes[(n + 1) % walk.nodes.size()].node));
  EXPECT_NEAR(area, 2 * (30 - 2 * std::sqrt(2.0)), 1e-12);  // an octagon
  EXPECT_EQ(walks[1].nodes.size(), 8u);
  EXPECT_EQ(walks[1].turns, 0);
}

TEST(WalksOf, ARectangularHoleTurnsBack) {
  const Domain domain = shapes::Builder({{0, 0}, {6, 0}, {6, 6}, {0, 6}, {2, 2}, {4, 2}, {4, 4}, {2, 4}},
                                        {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {4, 5}, {5, 6}, {6, 7}, {7, 4}}, 1)
                            .build({{3, 3}});
  const std::vector<NodeWalk> walks = walks_of(shapes::nodes_on(domain, {6, 6, 6, 6, 2, 2, 2, 2}), domain, kCell);
  ASSERT_EQ(walks.size(), 2u);
  EXPECT_EQ(walks[0].turns, 4);
  EXPECT_EQ(walks[1].turns, -4);
}

TEST(WalksOf, ALineThatEndsIsWalkedOnBothSides) {
  const Domain domain = shapes::Builder({{0, 0}, {3, 0}, {6, 0}, {6, 4}, {0, 4}, {3, 2}},
                                        {{0, 1}, {1, 2}, {2, 3}, {3, 4}, {4, 0}, {1, 5}}, 1)
                            .build();
  const WorkMesh mesh = shapes::nodes_on(domain, {3, 3, 4, 6, 4, 2});
  const std::vector<NodeWalk> walks = walks_of(mesh, domain, kCell);
  ASSERT_EQ(walks.size(), 1u);
  EXPECT_EQ(walks[0].nodes.size(), 3u + 3 + 4 + 6 + 4 + 2 * 2);
  EXPECT_EQ(walks[0].turns, 4);
  const std::vector<int> turns = turns_of(walks[0]);
  EXPECT_EQ(std::count(turns.begin(), turns.end(), -2), 1);
  for (const WalkNode& w : walks[0].nodes)
    if (w.turn == -2) {
      EXPECT_EQ(mesh.point(w.node), (Point{3, 2}));
    }
}

}  // namespace
}  // namespace quadline
