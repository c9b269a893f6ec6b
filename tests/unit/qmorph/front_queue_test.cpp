#include "stages/qmorph/front_queue.hpp"

#include <gtest/gtest.h>

#include "shapes.hpp"

namespace quadline {
namespace {

using Edge = shapes::Edge;

// The edges, pushed in the order given, in the order in which they become base edges.
std::vector<Edge> order(const Morph& morph, const std::vector<Edge>& edges) {
  const Topology& topo = morph.mesh().topo();
  FrontQueue queue(morph);
  for (const Edge& e : edges) queue.push(topo.find(NodeId(e[0]), NodeId(e[1])));
  std::vector<Edge> popped;
  for (HalfId h = queue.pop(); h.valid(); h = queue.pop()) popped.push_back({topo.tail(h).value, topo.head(h).value});
  return popped;
}

class FrontQueueTest : public testing::Test {
 protected:
  SizeField size_ = shapes::unit_size();
};

// A strip one square wide: its end has two closed corners, the side edges beside that one, the others none.
TEST_F(FrontQueueTest, StatesComeBeforeLength) {
  WorkMesh mesh = shapes::triangulated_grid(1, 4);
  mesh.move(NodeId(5), {1, 1.9});  // the side edge with open corners is shorter than both
  mesh.move(NodeId(3), {1, 1.1});
  const Morph morph(mesh, size_);
  EXPECT_EQ(order(morph, {{3, 5}, {1, 3}, {0, 1}}), (std::vector<Edge>{{0, 1}, {1, 3}, {3, 5}}));
}

TEST_F(FrontQueueTest, LevelComesBeforeStates) {
  WorkMesh mesh = shapes::triangulated_grid(1, 4);
  Morph morph(mesh, size_);
  morph.set_level(edge_of(mesh.topo().find(NodeId(0), NodeId(1))), 1);
  EXPECT_EQ(order(morph, {{0, 1}, {1, 3}, {3, 5}}), (std::vector<Edge>{{1, 3}, {3, 5}, {0, 1}}));
}

TEST_F(FrontQueueTest, CornersToBeSeamedComeBeforeStates) {
  // A gap of 20 degrees among four quads: its third edge, the shortest, has two closed corners of 80 degrees.
  WorkMesh mesh = shapes::gap(20, 4, {{1, 2}});
  const Morph morph(mesh, size_);
  const HalfId sharp = mesh.topo().find(NodeId(0), NodeId(1)), other = mesh.topo().find(NodeId(1), NodeId(2));
  ASSERT_EQ(corner_before(mesh, sharp).quads, 0);
  ASSERT_EQ(corner_before(mesh, other).quads, 1);
  ASSERT_EQ(corner_after(mesh, other).quads, 1);
  ASSERT_LT(mesh.edge_length(edge_of(other)), mesh.edge_length(edge_of(sharp)));
  EXPECT_EQ(order(morph, {{1, 2}, {0, 1}}), (std::vector<Edge>{{0, 1}, {1, 2}}));
}

TEST_F(FrontQueueTest, ShorterEdgesComeFirstThenSmallerIds) {
  WorkMesh mesh = shapes::triangulated_grid(6, 1);
  mesh.move(NodeId(3), {3.25, 0});
  const Morph morph(mesh, size_);
  EXPECT_EQ(order(morph, {{2, 3}, {1, 2}, {3, 4}}), (std::vector<Edge>{{3, 4}, {1, 2}, {2, 3}}));
  mesh.move(NodeId(3), {3, 0});
  EXPECT_EQ(order(morph, {{3, 4}, {1, 2}, {2, 3}}), (std::vector<Edge>{{1, 2}, {2, 3}, {3, 4}}));
}

TEST_F(FrontQueueTest, AnEdgePushedAgainComesOnce) {
  WorkMesh mesh = shapes::triangulated_grid(6, 1);
  const Morph morph(mesh, size_);
  EXPECT_EQ(order(morph, {{1, 2}, {2, 3}, {1, 2}}), (std::vector<Edge>{{1, 2}, {2, 3}}));
}

}  // namespace
}  // namespace quadline
