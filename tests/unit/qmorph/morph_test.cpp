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

TEST_F(MorphTest, SideEdgeIsReusedWithinThirtyDegrees) {
  WorkMesh mesh = shapes::triangulated_grid(4, 3);
  Morph morph(mesh, size_);
  const HalfId base = mesh.topo().find(NodeId(1), NodeId(2));
  EXPECT_EQ(morph.side_edge(corner_before(mesh, base), Morph::End::Tail), NodeId(6));
  EXPECT_EQ(morph.side_edge(corner_after(mesh, base), Morph::End::Head), NodeId(7));
  EXPECT_EQ(mesh.topo().node_count(), 20u);
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
  WorkMesh mesh = shapes::mesh_of({{-1, 0}, {0, 0}, {1, 0}, {1, 1.5}, {0, 1.5}, {-1, 1.5}, {-1.5, 0.7}, {1.5, 0.7}},
                                  {{1, 2, 7}, {1, 7, 3}, {1, 3, 4}, {1, 4, 5}, {1, 5, 6}, {1, 6, 0}},
                                  {{0, 1}, {1, 2}, {2, 7}, {7, 3}, {3, 4}, {4, 5}, {5, 6}, {6, 0}});
  Morph morph(mesh, size_);
  const HalfId base = mesh.topo().find(NodeId(1), NodeId(2));
  const NodeId v = morph.side_edge(corner_before(mesh, base), Morph::End::Tail);
  ASSERT_EQ(v, NodeId(8));  // a new node on the way to node 4
  EXPECT_NEAR(mesh.point(v).y, 0.75, 1e-12);
  expect_sound(mesh);
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
  expect_sound(mesh);
  EXPECT_EQ(mesh.topo().node_count(), 10u);
  EXPECT_EQ(shapes::n_triangles(mesh), 2u);
  EXPECT_EQ(shapes::n_constraints(mesh), 8u);
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
  EXPECT_FALSE(morph.transition(corner_before(mesh, mesh.topo().find(NodeId(7), NodeId(6)))));
}

TEST_F(MorphTest, NoTransitionBetweenEdgesOfSimilarLength) {
  WorkMesh mesh = notch(40 * kPi / 180, 1.5);
  Morph morph(mesh, size_);
  EXPECT_FALSE(morph.transition(corner_before(mesh, mesh.topo().find(NodeId(0), NodeId(1)))));
  EXPECT_EQ(mesh.topo().node_count(), 11u);
}

TEST_F(MorphTest, LoopOfFourBecomesAQuad) {
  WorkMesh mesh = shapes::triangulated_grid(1, 1);
  Morph morph(mesh, size_);
  ASSERT_TRUE(morph.close_loop(mesh.topo().find(NodeId(0), NodeId(1))));
  EXPECT_EQ(mesh.topo().face_count(), 1u);
  EXPECT_EQ(shapes::n_triangles(mesh), 0u);
  expect_sound(mesh);
}

TEST_F(MorphTest, LoopOfSixBecomesTwoSquares) {
  WorkMesh mesh = shapes::triangulated_grid(2, 1);
  Morph morph(mesh, size_);
  ASSERT_TRUE(morph.close_loop(mesh.topo().find(NodeId(0), NodeId(1))));
  EXPECT_EQ(mesh.topo().face_count(), 2u);
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
  EXPECT_EQ(mesh.topo().edge_valence(NodeId(6)), 3);
  expect_sound(mesh);
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
