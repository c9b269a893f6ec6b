#include "mesh/recover_edge.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace quadline {
namespace {

NodeId n(std::size_t i) { return NodeId(i); }

// A strip of two rows of nodes, 0 .. k below and k + 1 .. 2 k + 1 above, each square cut from lower left to upper
// right.
WorkMesh strip(std::size_t k, double height = 1) {
  std::vector<Point> points;
  for (const double y : {0.0, height})
    for (std::size_t i = 0; i <= k; ++i) points.push_back({double(i), y});
  std::vector<Polygon> triangles;
  for (std::size_t i = 0; i < k; ++i) {
    const std::size_t up = i + k + 1;
    triangles.emplace_back(n(i), n(i + 1), n(up + 1));
    triangles.emplace_back(n(i), n(up + 1), n(up));
  }
  WorkMesh mesh;
  mesh.build(points, std::vector<NodeTag>(points.size()), triangles);
  for (std::size_t f = 0; f < triangles.size(); ++f) mesh.set_cell(FaceId(f), CellId(std::size_t{0}));
  return mesh;
}

EdgeId edge(const WorkMesh& mesh, std::size_t a, std::size_t b) { return edge_of(mesh.topo().find(n(a), n(b))); }

TEST(WayBetween, ListsWhatItCrossesFromTheFirstNodeOn) {
  const WorkMesh mesh = strip(4);
  const Way way = way_between(mesh, n(5), n(4), EdgeId(), 100);  // from upper left to lower right
  std::vector<EdgeId> expected;
  for (std::size_t i = 0; i < 4; ++i) {
    expected.push_back(edge(mesh, i, i + 6));
    if (i < 3) expected.push_back(edge(mesh, i + 1, i + 6));
  }
  EXPECT_EQ(way.crossed, expected);
  EXPECT_FALSE(way.obstacle.node.valid());
  EXPECT_FALSE(way.obstacle.edge.valid());
}

TEST(WayBetween, ANodeOnTheWayIsAnObstacle) {
  const WorkMesh mesh = strip(4);
  EXPECT_EQ(way_between(mesh, n(0), n(3), EdgeId(), 100).obstacle.node, n(1));
}

TEST(WayBetween, ANodeBehindACrossedEdgeIsAnObstacle) {
  WorkMesh mesh;
  mesh.build({{0, 0}, {2, 1}, {1, 2}, {2, 2}, {3, 3}}, std::vector<NodeTag>(5),
             std::vector<Polygon>{{n(0), n(1), n(2)}, {n(1), n(3), n(2)}, {n(1), n(4), n(3)}, {n(3), n(4), n(2)}});
  for (std::size_t f = 0; f < 4; ++f) mesh.set_cell(FaceId(f), CellId(std::size_t{0}));
  const Way way = way_between(mesh, n(0), n(4), EdgeId(), 100);
  EXPECT_EQ(way.obstacle.node, n(3));
  EXPECT_EQ(way.crossed, std::vector<EdgeId>{edge(mesh, 1, 2)});
}

TEST(WayBetween, AConstraintAndAHeldEdgeAreObstacles) {
  WorkMesh mesh = strip(4);
  EXPECT_EQ(way_between(mesh, n(5), n(4), edge(mesh, 1, 7), 100).obstacle.edge, edge(mesh, 1, 7));
  mesh.set_curve(edge(mesh, 2, 7), CurveId(std::size_t{3}));
  const Way way = way_between(mesh, n(5), n(4), EdgeId(), 100);
  EXPECT_EQ(way.obstacle.edge, edge(mesh, 2, 7));
  EXPECT_EQ(way.crossed.size(), 3u);
}

TEST(WayBetween, GivesUpWhereMoreAreCrossed) {
  const WorkMesh mesh = strip(4);
  const Way way = way_between(mesh, n(5), n(4), EdgeId(), 6);
  EXPECT_TRUE(way.crossed.empty());
  EXPECT_FALSE(way.obstacle.edge.valid());
  EXPECT_EQ(way_between(mesh, n(5), n(4), EdgeId(), 7).crossed.size(), 7u);
}

TEST(RecoverEdge, MakesTheEdgeAndTellsTheOthers) {
  WorkMesh mesh = strip(4);
  Way way = way_between(mesh, n(5), n(4), EdgeId(), 100);
  std::vector<EdgeId> made;
  const HalfId h = recover_edge(mesh, n(5), n(4), way.crossed, made);
  ASSERT_TRUE(h.valid());
  EXPECT_EQ(mesh.topo().tail(h), n(5));
  EXPECT_EQ(mesh.topo().head(h), n(4));
  EXPECT_TRUE(way.crossed.empty());
  EXPECT_EQ(made.size(), 6u);  // seven were crossed, one became the edge
  for (const EdgeId e : made) EXPECT_NE(e, edge_of(h));
  EXPECT_EQ(mesh.topo().face_count(), 8u);
  for (const FaceId f : mesh.topo().faces()) {
    const Polygon p = mesh.topo().polygon(f);
    EXPECT_GT(cross(mesh.point(p.nodes[1]) - mesh.point(p.nodes[0]), mesh.point(p.nodes[2]) - mesh.point(p.nodes[0])),
              0);
  }
}

// Whatever the triangles are: every pair of nodes of a small patch that sees each other gets its edge.
TEST(RecoverEdge, EveryPairOfAStripInAnyOrder) {
  for (std::size_t a = 0; a < 6; ++a)
    for (std::size_t b = 6; b < 12; ++b) {
      WorkMesh mesh = strip(5, 0.3);
      if (mesh.topo().find(n(a), n(b)).valid()) continue;
      Way way = way_between(mesh, n(a), n(b), EdgeId(), 100);
      ASSERT_FALSE(way.crossed.empty());
      std::vector<EdgeId> made;
      EXPECT_TRUE(recover_edge(mesh, n(a), n(b), way.crossed, made).valid()) << a << " " << b;
    }
}

}  // namespace
}  // namespace quadline
