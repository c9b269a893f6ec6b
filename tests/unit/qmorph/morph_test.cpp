// Each step of the front, on a shape that forces it.
#include "stages/qmorph/morph.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "shapes.hpp"

namespace quadline {
namespace {

constexpr double kPi = std::numbers::pi;

class MorphTest : public testing::Test {
 protected:
  void expect_sound(const WorkMesh& mesh) { EXPECT_EQ(defect(mesh), ""); }
  SizeField size_ = shapes::unit_size();
};

TEST_F(MorphTest, FormsASquareFromABaseWithTwoOpenCorners) {
  WorkMesh mesh = shapes::triangulated_grid(4, 3);
  Morph morph(mesh, size_);
  ASSERT_TRUE(morph.form_quad(mesh.topo().find(NodeId(1), NodeId(2))));
  expect_sound(mesh);
  EXPECT_EQ(shapes::n_triangles(mesh), 22u);
  const HalfId h = mesh.topo().find(NodeId(1), NodeId(2));
  EXPECT_EQ(mesh.topo().polygon(mesh.topo().face(h)).n, 4);
  EXPECT_TRUE(mesh.topo().find(NodeId(2), NodeId(7)).valid());
  EXPECT_EQ(morph.level(edge_of(mesh.topo().find(NodeId(7), NodeId(6)))), 1);
}

TEST_F(MorphTest, CountsTheQuadItFormsAndItsEdges) {
  WorkMesh mesh = shapes::triangulated_grid(4, 3);
  Morph morph(mesh, size_);
  ASSERT_TRUE(morph.form_quad(mesh.topo().find(NodeId(0), NodeId(1))));  // in a corner of the plate
  MorphCounts expected;
  expected.n_triangles = 24;
  expected.quads[1][0] = 1;
  expected.side_neighbour = expected.side_chosen = expected.top_found = 1;
  EXPECT_EQ(morph.counts(), expected);
}

// Node 1 on a straight boundary, and above it the triangle of the three nodes that are given, all free: `right` and
// `left` are on its fan, `behind` lies beyond their edge. The boundary 2-6-8-7-0 is far away.
WorkMesh fan_above(Point right, Point left, Point behind, const std::vector<shapes::Edge>& lines = {}) {
  std::vector<shapes::Edge> constraints{{0, 1}, {1, 2}, {2, 6}, {6, 8}, {8, 7}, {7, 0}};
  constraints.insert(constraints.end(), lines.begin(), lines.end());
  return shapes::mesh_of(
      {{-1, 0}, {0, 0}, {1, 0}, right, left, behind, {4, 3}, {-4, 3}, {0, 3}},
      {{1, 2, 3}, {1, 3, 4}, {1, 4, 0}, {3, 5, 4}, {2, 6, 3}, {3, 6, 5}, {5, 6, 8}, {5, 8, 7}, {5, 7, 4}, {4, 7, 0}},
      constraints);
}

// So many degrees right of the vertical, at a distance.
Point off_vertical(double degrees, double r) {
  return {r * std::sin(degrees * kPi / 180), r * std::cos(degrees * kPi / 180)};
}

NodeId side_edge_above(WorkMesh& mesh, Morph& morph) {
  const HalfId base = mesh.topo().find(NodeId(1), NodeId(2));
  return morph.side_edge(corner_before(mesh, base), Morph::End::Tail);
}

TEST_F(MorphTest, SideEdgeIsReusedWithinThirtyDegrees) {
  WorkMesh near = fan_above(off_vertical(29, 1.2), off_vertical(-50, 1.5), {0, 1.5});
  Morph morph(near, size_);
  EXPECT_EQ(side_edge_above(near, morph), NodeId(3));
  EXPECT_EQ(morph.counts().side_chosen, 1u);
  WorkMesh far = fan_above(off_vertical(31, 1.2), off_vertical(-50, 1.5), {0, 1.5});
  Morph other(far, size_);
  EXPECT_EQ(side_edge_above(far, other), NodeId(5));  // rather by a swap
  EXPECT_EQ(other.counts().side_swapped, 1u);
  expect_sound(far);
}

TEST_F(MorphTest, NoSwapForALongSideEdge) {
  // The front edges have length 1, so the limit is the square root of 3.
  WorkMesh near = fan_above(off_vertical(46, 1.2), off_vertical(-50, 1.5), {0, 1.70});
  Morph morph(near, size_);
  EXPECT_EQ(side_edge_above(near, morph), NodeId(5));
  WorkMesh far = fan_above(off_vertical(46, 1.2), off_vertical(-50, 1.5), {0, 1.76});
  Morph other(far, size_);
  EXPECT_EQ(side_edge_above(far, other), NodeId(9));  // a new node
  EXPECT_EQ(other.counts().side_split_direction, 1u);
  expect_sound(far);
}

TEST_F(MorphTest, SideEdgeWithinFortyFiveDegreesComesBeforeASplit) {
  WorkMesh near = fan_above(off_vertical(44, 1.2), off_vertical(-50, 1.5), {0, 2});
  Morph morph(near, size_);
  EXPECT_EQ(side_edge_above(near, morph), NodeId(3));
  WorkMesh far = fan_above(off_vertical(46, 1.2), off_vertical(-50, 1.5), {0, 2});
  Morph other(far, size_);
  EXPECT_EQ(side_edge_above(far, other), NodeId(9));
}

TEST_F(MorphTest, SideEdgeWithinSixtyDegreesIsTheLastResort) {
  // The edge above is a line: it cannot be swapped or split.
  WorkMesh near = fan_above(off_vertical(59, 1.2), off_vertical(-62, 1.2), {0, 2}, {{3, 4}});
  Morph morph(near, size_);
  EXPECT_EQ(side_edge_above(near, morph), NodeId(3));
  WorkMesh far = fan_above(off_vertical(61, 1.2), off_vertical(-62, 1.2), {0, 2}, {{3, 4}});
  Morph other(far, size_);
  EXPECT_FALSE(side_edge_above(far, other).valid());
}

TEST_F(MorphTest, FarNodeOfASplitIsDrawnIn) {
  WorkMesh near = fan_above(off_vertical(46, 1.8), off_vertical(-46, 1.8), {0, 2.5});
  Morph morph(near, size_);
  ASSERT_EQ(side_edge_above(near, morph), NodeId(9));
  EXPECT_NEAR(near.point(NodeId(9)).y, 1.8 * std::cos(46 * kPi / 180), 1e-12);  // 1.25 sizes
  WorkMesh far = fan_above(off_vertical(46, 2), off_vertical(-46, 2), {0, 2.5});
  Morph other(far, size_);
  ASSERT_EQ(side_edge_above(far, other), NodeId(9));
  EXPECT_NEAR(far.point(NodeId(9)).y, 1, 1e-12);  // in the place of 1.39
  expect_sound(far);
}

// A strip of the given height: the nodes above are on the front already, and the loops stay even.
TEST_F(MorphTest, SideEdgeToAnotherFrontIsSplitAbove1Point7Sizes) {
  for (const double height : {1.65, 1.75, 2.5}) {
    WorkMesh mesh = shapes::triangulated_grid(4, 1);
    for (std::size_t i = 5; i < 10; ++i) mesh.move(NodeId(i), {static_cast<double>(i - 5), height});
    Morph morph(mesh, size_);
    const NodeId v = side_edge_above(mesh, morph);
    ASSERT_EQ(v, height < 1.7 ? NodeId(6) : NodeId(10)) << height;
    EXPECT_EQ(morph.counts().side_split_length, height < 1.7 ? 0u : 1u);
    EXPECT_NEAR(mesh.point(v).y, height < 1.7 ? height : height < 2 ? height / 2 : 1, 1e-12);
  }
}

TEST_F(MorphTest, SideEdgeComesFromASwap) {
  // Above node 1 the fan has edges at 45 and 135 degrees only; the node straight above lies behind their chord.
  WorkMesh mesh =
      shapes::mesh_of({{-1, 0}, {0, 0}, {1, 0}, {1, 1}, {-1, 1}, {0, 1.3}},
                      {{1, 2, 3}, {1, 3, 4}, {1, 4, 0}, {3, 5, 4}}, {{0, 1}, {1, 2}, {2, 3}, {3, 5}, {5, 4}, {4, 0}});
  Morph morph(mesh, size_);
  const HalfId base = mesh.topo().find(NodeId(1), NodeId(2));
  // The node behind is on the front: the loop 1-2-3-5 has four edges, so it may be joined.
  EXPECT_EQ(morph.side_edge(corner_before(mesh, base), Morph::End::Tail), NodeId(5));
  EXPECT_TRUE(mesh.topo().find(NodeId(1), NodeId(5)).valid());
  expect_sound(mesh);
}

TEST_F(MorphTest, SideEdgeComesFromASplit) {
  // As before, but the node behind is too far away for a swap.
  WorkMesh mesh =
      shapes::mesh_of({{-1, 0}, {0, 0}, {1, 0}, {1.2, 1}, {-1.2, 1}, {0, 4}},
                      {{1, 2, 3}, {1, 3, 4}, {1, 4, 0}, {3, 5, 4}}, {{0, 1}, {1, 2}, {2, 3}, {3, 5}, {5, 4}, {4, 0}});
  Morph morph(mesh, size_);
  const HalfId base = mesh.topo().find(NodeId(1), NodeId(2));
  const NodeId v = morph.side_edge(corner_before(mesh, base), Morph::End::Tail);
  ASSERT_TRUE(v.valid());
  EXPECT_EQ(v, NodeId(6));  // a new node
  EXPECT_NEAR(mesh.point(v).x, 0, 1e-12);
  EXPECT_NEAR(mesh.point(v).y, 1, 1e-12);
  expect_sound(mesh);
}

TEST_F(MorphTest, OddLoopSplitsTheSideEdge) {
  // Straight above node 1 lies a front node whose edge would leave an odd loop on either side.
  for (const double height : {1.5, 0.71, 0.69}) {
    WorkMesh mesh =
        shapes::mesh_of({{-1, 0}, {0, 0}, {1, 0}, {1, height}, {0, height}, {-1, height}, {-1.5, 0.7}, {1.5, 0.7}},
                        {{1, 2, 7}, {1, 7, 3}, {1, 3, 4}, {1, 4, 5}, {1, 5, 6}, {1, 6, 0}},
                        {{0, 1}, {1, 2}, {2, 7}, {7, 3}, {3, 4}, {4, 5}, {5, 6}, {6, 0}});
    Morph morph(mesh, size_);
    const NodeId v = side_edge_above(mesh, morph);
    if (height > 0.7) {
      ASSERT_EQ(v, NodeId(8));  // a new node on the way to node 4
      EXPECT_NEAR(mesh.point(v).y, height / 2, 1e-12);
      EXPECT_EQ(morph.counts().side_split_parity, 1u);
    } else {
      EXPECT_LT(v, NodeId(8));  // no piece below 0.35 sizes is made
      EXPECT_NE(v, NodeId(4));
    }
    expect_sound(mesh);
  }
}

TEST_F(MorphTest, LineEndTakesTheNormalDirection) {
  WorkMesh mesh = shapes::triangulated_grid(4, 4, {{10, 11}, {11, 12}});
  Morph morph(mesh, size_);
  const HalfId base = mesh.topo().find(NodeId(11), NodeId(12));
  EXPECT_EQ(morph.side_edge(corner_after(mesh, base), Morph::End::Head), NodeId(17));
  ASSERT_TRUE(morph.form_quad(base));
  expect_sound(mesh);
  EXPECT_EQ(shapes::n_constraints(mesh), 16u + 2);
}

TEST_F(MorphTest, TopEdgeIsRecoveredBySwaps) {
  WorkMesh mesh = shapes::triangulated_grid(3, 1);
  Morph morph(mesh, size_);
  const HalfId h = morph.recover_edge(NodeId(1), NodeId(4));  // against the rising diagonal
  ASSERT_TRUE(h.valid());
  EXPECT_EQ(mesh.topo().tail(h), NodeId(1));
  EXPECT_EQ(mesh.topo().head(h), NodeId(4));
  expect_sound(mesh);
}

TEST_F(MorphTest, TopEdgeDoesNotCrossALine) {
  WorkMesh mesh = shapes::triangulated_grid(2, 1, {{1, 4}});
  Morph morph(mesh, size_);
  EXPECT_FALSE(morph.recover_edge(NodeId(0), NodeId(5)).valid());
  expect_sound(mesh);
}

TEST_F(MorphTest, TopEdgeDoesNotPassThroughANode) {
  WorkMesh mesh = shapes::triangulated_grid(2, 2);
  Morph morph(mesh, size_);
  EXPECT_FALSE(morph.recover_edge(NodeId(3), NodeId(5)).valid());
}

TEST_F(MorphTest, NothingIsSwappedForATopEdgeThatWouldPassThroughANode) {
  // From (0, 2) to (4, 0): before and behind the node at (2, 1) it would cross edges that can be swapped.
  WorkMesh mesh = shapes::triangulated_grid(4, 2);
  Morph morph(mesh, size_);
  EXPECT_FALSE(morph.recover_edge(NodeId(10), NodeId(4)).valid());
  for (std::size_t v : {0u, 1u, 2u, 3u, 5u, 6u, 7u, 8u})
    EXPECT_TRUE(mesh.topo().find(NodeId(v), NodeId(v + 6)).valid());
}

TEST_F(MorphTest, NoQuadIsFormedWithAFlatCornerAtAFixedNode) {
  for (const double degrees : {167.0, 169.0}) {
    // The corner at node 3 opens so far; it stands above the middle of the diagonal.
    const double h = std::sqrt(2.0) / std::tan(degrees * kPi / 360);
    WorkMesh mesh = shapes::mesh_of({{0, 0}, {2, 0}, {2, 2}, {1 - h / std::sqrt(2.0), 1 + h / std::sqrt(2.0)}},
                                    {{0, 1, 2}, {0, 2, 3}}, {{0, 1}, {1, 2}, {2, 3}, {3, 0}});
    Morph morph(mesh, size_);
    EXPECT_EQ(morph.form_quad(mesh.topo().find(NodeId(0), NodeId(1))), degrees < 168);
    EXPECT_EQ(morph.counts().refused_shape, degrees < 168 ? 0u : 1u);
    EXPECT_EQ(morph.counts().side_neighbour, degrees < 168 ? 2u : 0u);  // of what was refused nothing counts
    expect_sound(mesh);
  }
}

TEST_F(MorphTest, TopOfAFreshQuadBecomesAParallelogram) {
  WorkMesh mesh = shapes::triangulated_grid(4, 3);
  mesh.move(NodeId(6), {1.1, 1.2});
  Morph morph(mesh, size_);
  ASSERT_TRUE(morph.form_quad(mesh.topo().find(NodeId(1), NodeId(2))));
  EXPECT_NEAR(distance(mesh.point(NodeId(7)), {2.1, 1.2}), 0, 1e-12);
  expect_sound(mesh);
}

TEST_F(MorphTest, HeightOfARowGoesHalfWayToTheSize) {
  WorkMesh mesh = shapes::triangulated_grid(4, 3);
  for (const std::size_t v : {6u, 7u, 8u}) mesh.move(NodeId(v), {static_cast<double>(v - 5), 1.2});
  Morph morph(mesh, size_);
  ASSERT_TRUE(morph.form_quad(mesh.topo().find(NodeId(1), NodeId(2))));
  EXPECT_NEAR(mesh.point(NodeId(7)).y, 1.2, 1e-12);
  ASSERT_TRUE(morph.form_quad(mesh.topo().find(NodeId(2), NodeId(3))));
  EXPECT_NEAR(mesh.point(NodeId(7)).y, 1.1, 1e-12);
  expect_sound(mesh);
}

// Quads round the node 0 but for a notch of `half_angle` on either side of the vertical, with triangles in it and
// ahead.
WorkMesh notch(double half_angle, double right_length) {
  const double s = std::sin(half_angle), c = std::cos(half_angle), r = right_length, top = r + 1.4;
  return shapes::mesh_of(
      {{0, 0},
       {r * s, r * c},
       {-s, c},
       {3, 0.2},
       {0, -1},
       {-1.5, 0.2},
       {0, top},
       {3.4, r * c + 0.3},
       {-1.6, top},
       {3, -1},
       {-1.6, -1}},
      {{0, 4, 9, 3}, {0, 3, 7, 1}, {0, 2, 8, 5}, {0, 5, 10, 4}, {0, 1, 2}, {1, 6, 2}, {1, 7, 6}, {2, 6, 8}},
      {{4, 9}, {9, 3}, {3, 7}, {7, 6}, {6, 8}, {8, 5}, {5, 10}, {10, 4}});
}

TEST_F(MorphTest, SeamClosesASharpCorner) {
  WorkMesh mesh = notch(10 * kPi / 180, 1);
  const Corner corner = corner_before(mesh, mesh.topo().find(NodeId(0), NodeId(1)));
  ASSERT_EQ(corner.quads, 0);
  Morph morph(mesh, size_);
  ASSERT_TRUE(morph.seam(corner));
  EXPECT_EQ(morph.counts().seams, 1u);
  expect_sound(mesh);
  EXPECT_EQ(mesh.topo().node_count(), 10u);
  EXPECT_EQ(shapes::n_triangles(mesh), 2u);
  EXPECT_EQ(shapes::n_constraints(mesh), 8u);
}

TEST_F(MorphTest, SeamLooksForAPlaceWhereNothingInverts) {
  WorkMesh mesh = notch(10 * kPi / 180, 1);
  mesh.move(NodeId(6), {-0.45, 1.3});  // joined at the right end, or half-way, the triangle 2-6-8 would invert
  expect_sound(mesh);
  Morph morph(mesh, size_);
  ASSERT_TRUE(morph.seam(corner_before(mesh, mesh.topo().find(NodeId(0), NodeId(1)))));
  expect_sound(mesh);
}

TEST_F(MorphTest, NoSeamWhereBothEndsAreFixed) {
  // A constrained wedge: two lines meet below thirty degrees.
  WorkMesh mesh =
      shapes::mesh_of({{0, 0}, {1, 0.1}, {1, -0.1}, {2, 0}}, {{0, 2, 1}, {2, 3, 1}}, {{0, 2}, {2, 3}, {3, 1}, {1, 0}});
  const Corner corner = corner_before(mesh, mesh.topo().find(NodeId(0), NodeId(2)));
  EXPECT_EQ(corner.quads, 1);
  Morph morph(mesh, size_);
  EXPECT_FALSE(morph.seam(corner));
  EXPECT_EQ(mesh.topo().node_count(), 4u);
}

TEST_F(MorphTest, TransitionSeamSplitsTheLongEdge) {
  WorkMesh mesh = notch(10 * kPi / 180, 2.7);
  Morph morph(mesh, size_);
  const Corner corner = corner_before(mesh, mesh.topo().find(NodeId(0), NodeId(1)));
  ASSERT_EQ(corner.quads, 0);
  ASSERT_TRUE(morph.transition(corner));
  EXPECT_EQ(morph.counts().transition_seams, 1u);
  expect_sound(mesh);
  EXPECT_EQ(mesh.topo().node_count(), 12u);
  EXPECT_EQ(shapes::n_triangles(mesh), 6u);  // one ahead cut in two, one taken back
  EXPECT_FALSE(mesh.topo().find(NodeId(0), NodeId(1)).valid());
}

TEST_F(MorphTest, TransitionSplitMakesTwoQuadsAndATriangle) {
  WorkMesh mesh = notch(40 * kPi / 180, 2.7);
  Morph morph(mesh, size_);
  const Corner corner = corner_before(mesh, mesh.topo().find(NodeId(0), NodeId(1)));
  ASSERT_NE(corner.quads, 0);
  ASSERT_TRUE(morph.transition(corner));
  expect_sound(mesh);
  EXPECT_EQ(mesh.topo().node_count(), 13u);
  EXPECT_EQ(mesh.topo().face_count(), 11u);
  EXPECT_EQ(morph.counts().transition_splits, 1u);
}

TEST_F(MorphTest, NoTransitionBelowARatioOf2Point5) {
  for (const double ratio : {2.4, 2.6}) {
    WorkMesh mesh = notch(40 * kPi / 180, ratio);
    Morph morph(mesh, size_);
    EXPECT_EQ(morph.transition(corner_before(mesh, mesh.topo().find(NodeId(0), NodeId(1)))), ratio > 2.5);
    EXPECT_EQ(mesh.topo().node_count(), ratio > 2.5 ? 13u : 11u);
  }
}

TEST_F(MorphTest, NoTransitionThroughAThinQuad) {
  // The scaled Jacobian of the quad behind is that of its corner at node 0, of 16 or 20 degrees: 0.28 or 0.34.
  for (const double degrees : {16.0, 20.0}) {
    WorkMesh mesh = notch(40 * kPi / 180, 2.7);
    mesh.move(NodeId(3), off_vertical(40 + degrees, 3));
    mesh.move(NodeId(7), off_vertical(40 + degrees / 2, 5.4));
    Morph morph(mesh, size_);
    EXPECT_EQ(morph.transition(corner_before(mesh, mesh.topo().find(NodeId(0), NodeId(1)))), degrees > 18);
  }
}

TEST_F(MorphTest, AQuadOfATransitionIsNotSplitAgain) {
  WorkMesh mesh = notch(40 * kPi / 180, 2.7);
  Morph morph(mesh, size_);
  ASSERT_TRUE(morph.transition(corner_before(mesh, mesh.topo().find(NodeId(0), NodeId(1)))));
  const NodeId middle(12);  // of the quad that was split; with it as far away the front at node 0 is as uneven again
  mesh.move(middle, off_vertical(45, 2.3));
  mesh.move(NodeId(2), off_vertical(-40, 0.88));
  const Corner corner = corner_before(mesh, mesh.topo().find(NodeId(0), middle));
  ASSERT_EQ(corner.in, mesh.topo().find(NodeId(2), NodeId(0)));
  ASSERT_GT(mesh.edge_length(edge_of(corner.out)), 2.6 * mesh.edge_length(edge_of(corner.in)));
  ASSERT_LT(radians(corner.angle), kPi);
  ASSERT_GT(scaled_jacobian(mesh.quad_points(mesh.topo().face(twin(corner.out)))), 0.35);
  EXPECT_FALSE(morph.transition(corner));
  EXPECT_EQ(morph.counts().transition_splits, 1u);
}

TEST_F(MorphTest, LoopOfFourBecomesAQuad) {
  WorkMesh mesh = shapes::triangulated_grid(1, 1);
  Morph morph(mesh, size_);
  ASSERT_TRUE(morph.close_loop(mesh.topo().find(NodeId(0), NodeId(1))));
  EXPECT_EQ(mesh.topo().face_count(), 1u);
  EXPECT_EQ(morph.counts().closures_of_4, 1u);
  EXPECT_EQ(shapes::n_triangles(mesh), 0u);
  expect_sound(mesh);
}

TEST_F(MorphTest, LoopOfSixBecomesTwoSquares) {
  WorkMesh mesh = shapes::triangulated_grid(2, 1);
  Morph morph(mesh, size_);
  ASSERT_TRUE(morph.close_loop(mesh.topo().find(NodeId(0), NodeId(1))));
  EXPECT_EQ(mesh.topo().face_count(), 2u);
  EXPECT_EQ(morph.counts().closures_of_6_by_2, 1u);
  EXPECT_TRUE(mesh.topo().find(NodeId(1), NodeId(4)).valid());
  expect_sound(mesh);
}

TEST_F(MorphTest, TriangularLoopOfSixBecomesThreeQuads) {
  const double h = std::sqrt(3.0);
  WorkMesh mesh =
      shapes::mesh_of({{0, 0}, {1, 0}, {2, 0}, {1.5, h / 2}, {1, h}, {0.5, h / 2}},
                      {{0, 1, 5}, {1, 2, 3}, {3, 4, 5}, {1, 3, 5}}, {{0, 1}, {1, 2}, {2, 3}, {3, 4}, {4, 5}, {5, 0}});
  Morph morph(mesh, size_);
  ASSERT_TRUE(morph.close_loop(mesh.topo().find(NodeId(0), NodeId(1))));
  EXPECT_EQ(mesh.topo().face_count(), 3u);
  EXPECT_EQ(morph.counts().closures_of_6_by_3, 1u);
  EXPECT_EQ(mesh.topo().edge_valence(NodeId(6)), 3);
  expect_sound(mesh);
}

TEST_F(MorphTest, NewNodeInALoopOfSixMustBeWorthIt) {
  // With every other corner this much farther out, three quads are better by 0.09 or 0.20 of scaled Jacobian.
  for (const double out : {1.1, 1.2}) {
    std::vector<Point> points;
    for (int i = 0; i < 6; ++i) points.push_back(off_vertical(90 - 60 * i, i % 2 == 0 ? 1 : out));
    WorkMesh mesh = shapes::mesh_of(points, {{0, 1, 5}, {1, 2, 3}, {3, 4, 5}, {1, 3, 5}},
                                    {{0, 1}, {1, 2}, {2, 3}, {3, 4}, {4, 5}, {5, 0}});
    Morph morph(mesh, size_);
    ASSERT_TRUE(morph.close_loop(mesh.topo().find(NodeId(0), NodeId(1))));
    EXPECT_EQ(mesh.topo().face_count(), out < 1.15 ? 2u : 3u);
    expect_sound(mesh);
  }
}

TEST_F(MorphTest, PoorLoopOfFourIsSeamed) {
  // A kite with a corner of 4 degrees at node 0 would have a scaled Jacobian of 0.07, one of 8 degrees has 0.14.
  for (const double half_angle : {2.0, 4.0}) {
    const double s = std::sin(half_angle * kPi / 180), c = std::cos(half_angle * kPi / 180);
    WorkMesh mesh = shapes::mesh_of(
        {{0, 0},
         {s, c},
         {-s, c},
         {3, 0.2},
         {0, -1},
         {-1.5, 0.2},
         {0, 1.2},
         {3.4, c + 0.3},
         {-1.6, 2},
         {3, -1},
         {-1.6, -1},
         {0, 4}},
        {{0, 4, 9, 3}, {0, 3, 7, 1}, {0, 2, 8, 5}, {0, 5, 10, 4}, {1, 7, 11, 6}, {2, 6, 11, 8}, {0, 1, 2}, {1, 6, 2}},
        {{4, 9}, {9, 3}, {3, 7}, {7, 11}, {11, 8}, {8, 5}, {5, 10}, {10, 4}});
    Morph morph(mesh, size_);
    ASSERT_TRUE(morph.close_loop(mesh.topo().find(NodeId(0), NodeId(1))));
    EXPECT_EQ(shapes::n_triangles(mesh), 0u);
    EXPECT_EQ(morph.counts().seams, half_angle < 3 ? 1u : 0u);
    EXPECT_EQ(morph.counts().closures_of_4, half_angle < 3 ? 0u : 1u);
    expect_sound(mesh);
  }
}

TEST_F(MorphTest, QuadNeverSwallowsAPointConstraint) {
  WorkMesh mesh;
  mesh.build({{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0.5, 0.5}}, std::vector<NodeTag>(5, NodeTag{NodeKind::Fixed, {}, 0, {}}),
             std::vector<Polygon>{{NodeId(0), NodeId(1), NodeId(4)},
                                  {NodeId(1), NodeId(2), NodeId(4)},
                                  {NodeId(2), NodeId(3), NodeId(4)},
                                  {NodeId(3), NodeId(0), NodeId(4)}});
  for (std::size_t i = 0; i < 4; ++i) {
    mesh.set_cell(FaceId(i), CellId(0));
    mesh.set_curve(edge_of(mesh.topo().find(NodeId(i), NodeId((i + 1) % 4))), CurveId(0));
  }
  Morph morph(mesh, size_);
  EXPECT_FALSE(morph.close_loop(mesh.topo().find(NodeId(0), NodeId(1))));
  morph.complete();
  EXPECT_TRUE(mesh.topo().is_live(NodeId(4)));
  EXPECT_EQ(shapes::n_triangles(mesh), 0u);
}

TEST_F(MorphTest, CompletionTakesTheBestPairsFirst) {
  // The squares, not the slanted quads between them; round a node there is a choice.
  WorkMesh mesh = shapes::shuffled_grid(4, 4);
  Morph morph(mesh, size_);
  morph.complete();
  EXPECT_EQ(mesh.topo().face_count(), 16u);
  EXPECT_EQ(mesh.topo().node_count(), 25u);
  for (std::size_t i = 0; i < mesh.topo().face_capacity(); ++i) {
    if (!mesh.topo().is_live(FaceId(i))) continue;
    EXPECT_NEAR(scaled_jacobian(mesh.quad_points(FaceId(i))), 1, 1e-12);
  }
  EXPECT_EQ(morph.counts().completion_triangles, 32u);
  EXPECT_EQ(morph.counts().completion_quads, 16u);
}

TEST_F(MorphTest, CompletionLeavesNoTriangleAndKeepsEveryLine) {
  for (std::size_t n : {1u, 2u, 3u, 5u, 8u}) {
    WorkMesh mesh = shapes::triangulated_grid(2 * n, n + 1, {{2 * n + 1, 4 * n + 2}});
    const std::size_t constraints = shapes::n_constraints(mesh);
    Morph morph(mesh, size_);
    morph.complete();
    EXPECT_EQ(shapes::n_triangles(mesh), 0u);
    EXPECT_EQ(shapes::n_constraints(mesh), constraints);
    EXPECT_EQ(mesh.topo().defect(), nullptr);
  }
}

TEST_F(MorphTest, OddCellIsRefused) {
  WorkMesh mesh = shapes::mesh_of({{0, 0}, {1, 0}, {0, 1}}, {{0, 1, 2}}, {{0, 1}, {1, 2}, {2, 0}});
  EXPECT_THROW(Morph(mesh, size_), InternalError);
}

}  // namespace
}  // namespace quadline
