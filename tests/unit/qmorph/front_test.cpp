#include "stages/qmorph/front.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "shapes.hpp"
#include "stages/qmorph/parity.hpp"

namespace quadline {
namespace {

constexpr double kPi = std::numbers::pi;

TEST(Front, IsTheRimOfTheTrianglesAndBothSidesOfALine) {
  const WorkMesh mesh = shapes::triangulated_grid(4, 4, {{11, 12}, {12, 13}});
  int n = 0;
  for (std::size_t i = 0; i < mesh.topo().edge_capacity(); ++i)
    for (int side = 0; side < 2; ++side) n += is_front(mesh, half_of(EdgeId(i), side));
  EXPECT_EQ(n, 16 + 4);
}

TEST(Front, WalksRoundAnOpenLineAndBack) {
  const WorkMesh mesh = shapes::triangulated_grid(4, 4, {{11, 12}, {12, 13}});
  const HalfId start = mesh.topo().find(NodeId(11), NodeId(12));
  HalfId h = start;
  int n = 0;
  do {
    EXPECT_EQ(previous_front(mesh, next_front(mesh, h)), h);
    h = next_front(mesh, h);
    ++n;
  } while (h != start && n < 100);
  EXPECT_EQ(n, 4);  // two edges, both sides: always even
}

TEST(Front, CornerOfARectangleIsClosed) {
  const WorkMesh mesh = shapes::triangulated_grid(3, 3);
  const Corner c = corner_before(mesh, mesh.topo().find(NodeId(0), NodeId(1)));
  EXPECT_EQ(c.state, State::Closed);
  EXPECT_EQ(c.quads, 1);
  EXPECT_NEAR(radians(c.angle), kPi / 2, 1e-12);
}

TEST(Front, StraightBoundaryIsOpenForTwoQuads) {
  const WorkMesh mesh = shapes::triangulated_grid(3, 3);
  const Corner c = corner_after(mesh, mesh.topo().find(NodeId(0), NodeId(1)));
  EXPECT_EQ(c.state, State::Open);
  EXPECT_EQ(c.quads, 2);
}

TEST(Front, EndOfAnOpenLineIsStateTwoForFourQuads) {
  const WorkMesh mesh = shapes::triangulated_grid(4, 4, {{11, 12}, {12, 13}});
  const Corner c = corner_after(mesh, mesh.topo().find(NodeId(12), NodeId(13)));
  EXPECT_EQ(c.state, State::LineEnd);
  EXPECT_EQ(c.quads, 4);
  EXPECT_EQ(radians(c.angle), 2 * kPi);
}

TEST(Front, ReentrantCornerGetsThreeQuads) {
  // An L of three unit squares round the node 3
  const WorkMesh mesh = shapes::mesh_of({{0, 0}, {1, 0}, {2, 0}, {1, 1}, {2, 1}, {0, 1}, {0, 2}, {1, 2}},
                                        {{0, 1, 3}, {0, 3, 5}, {1, 2, 4}, {1, 4, 3}, {5, 3, 7}, {5, 7, 6}},
                                        {{0, 1}, {1, 2}, {2, 4}, {4, 3}, {3, 7}, {7, 6}, {6, 5}, {5, 0}});
  const Corner c = corner_after(mesh, mesh.topo().find(NodeId(4), NodeId(3)));
  EXPECT_EQ(c.quads, 3);
  EXPECT_NEAR(radians(c.angle), 1.5 * kPi, 1e-12);
}

Corner corner_of_gap(double angle_deg, int n_quads) {
  const WorkMesh mesh = shapes::gap(angle_deg, n_quads);
  return corner_before(mesh, mesh.topo().find(NodeId(0), NodeId(1)));
}

TEST(Front, CornerBelowThirtyDegreesIsSeamedWhateverTheValence) {
  EXPECT_EQ(corner_of_gap(29, 1).quads, 0);
  EXPECT_NE(corner_of_gap(31, 1).quads, 0);
}

TEST(Front, CornerIsSeamedWhereThatCostsLessThanAQuad) {
  EXPECT_EQ(corner_of_gap(49, 4).quads, 0);
  EXPECT_EQ(corner_of_gap(51, 4).quads, 1);
}

TEST(Front, NoCornerAboveSixtyDegreesIsSeamed) {
  EXPECT_EQ(corner_of_gap(59, 6).quads, 0);
  EXPECT_EQ(corner_of_gap(61, 6).quads, 1);
}

TEST(Front, ValenceDecidesBetweenOneQuadAndTwo) {
  EXPECT_EQ(corner_of_gap(128, 3).quads, 1);  // equal at 129 degrees: one more quad makes four
  EXPECT_EQ(corner_of_gap(130, 3).quads, 2);
  EXPECT_EQ(corner_of_gap(108, 2).quads, 1);  // at 109: two more make four
  EXPECT_EQ(corner_of_gap(110, 2).quads, 2);
}

TEST(Front, QuadsEdgeIsSeamedToALineBelowThirtyDegrees) {
  for (const double angle_deg : {29.0, 31.0}) {
    const double angle = angle_deg * kPi / 180;
    const WorkMesh mesh = shapes::mesh_of({{0, 0}, {1, 0}, {std::cos(angle), std::sin(angle)}, {-1, 1}, {-1, 0}},
                                          {{0, 1, 2}, {0, 2, 3, 4}}, {{4, 0}, {0, 1}});
    EXPECT_EQ(corner_before(mesh, mesh.topo().find(NodeId(0), NodeId(1))).quads, angle_deg < 30 ? 0 : 1);
  }
}

TEST(Parity, NeighboursDifferAndOddRingsAreRefused) {
  Parity parity;
  EXPECT_TRUE(parity.tie(NodeId(0), NodeId(1), true));
  EXPECT_TRUE(parity.tie(NodeId(1), NodeId(2), true));
  EXPECT_FALSE(parity.tie(NodeId(2), NodeId(0), true));
  EXPECT_TRUE(parity.tie(NodeId(2), NodeId(0), false));
}

TEST(Parity, TiesCanBeTakenBack) {
  Parity parity;
  parity.tie(NodeId(0), NodeId(1), true);
  parity.tie(NodeId(5), NodeId(6), true);
  const std::size_t mark = parity.mark();
  EXPECT_TRUE(parity.tie(NodeId(1), NodeId(5), true));
  EXPECT_FALSE(parity.tie(NodeId(0), NodeId(6), true) && parity.tie(NodeId(0), NodeId(6), false));
  parity.rollback(mark);
  EXPECT_TRUE(parity.tie(NodeId(1), NodeId(5), false));
  EXPECT_TRUE(parity.tie(NodeId(0), NodeId(6), false));
}

TEST(Parity, AnIdUsedAgainHasNoColour) {
  Parity parity;
  parity.tie(NodeId(0), NodeId(1), true);
  parity.tie(NodeId(1), NodeId(2), true);
  parity.forget(NodeId(1));
  EXPECT_TRUE(parity.tie(NodeId(1), NodeId(0), false));
  EXPECT_TRUE(parity.tie(NodeId(0), NodeId(2), false));  // what went through the old node still holds
}

}  // namespace
}  // namespace quadline
