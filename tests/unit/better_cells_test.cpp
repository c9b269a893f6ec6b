#include "better_cells.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "tests/unit/grid_patch.hpp"

namespace quadline {
namespace {

constexpr CellId kLeft(std::size_t{0}), kRight(std::size_t{1});

/// 8 x 4 squares, a line across the middle, a cell on each side of it.
shapes::Patch two_cells() {
  shapes::Patch patch = shapes::PatchMaker({.nx = 8, .ny = 4, .lines = {{{{4, 0}, {4, 4}}}}}).make();
  for (std::size_t i = 0; i < patch.mesh.topo().face_capacity(); ++i) {
    const QuadPoints q = patch.mesh.quad_points(FaceId(i));
    patch.mesh.set_cell(FaceId(i), midpoint(q[0], q[2]).x < 4 ? kLeft : kRight);
  }
  const Topology& topo = patch.mesh.topo();
  for (std::size_t e = 0; e < topo.edge_capacity(); ++e)
    if (patch.mesh.is_constraint(EdgeId(e)))
      patch.mesh.segments.push_back(
          {topo.tail(half_of(EdgeId(e))), topo.head(half_of(EdgeId(e))), patch.mesh.curve(EdgeId(e))});
  return patch;
}

/// The two squares above and right of a place, split along the other way: nodes of three and of five quads.
void turn(shapes::Patch& patch, int i, int j) {
  const auto n = [&](int k, int l) { return patch.node(i + k, j + l); };
  const Topology& topo = patch.mesh.topo();
  const std::vector<FaceId> pair{topo.face(topo.find(n(0, 0), n(1, 0))), topo.face(topo.find(n(1, 0), n(2, 0)))};
  std::vector<FaceId> made;
  patch.mesh.replace_cavity(
      pair, std::vector<Polygon>{{n(0, 0), n(1, 0), n(2, 0), n(2, 1)}, {n(2, 1), n(1, 1), n(0, 1), n(0, 0)}}, made);
}

std::size_t count(const CellSet& cells) { return std::size_t{cells.contains(kLeft)} + cells.contains(kRight); }

TEST(ImprovableCells, HaveNodesOfTooManyAndOfTooFewQuads) {
  shapes::Patch patch = two_cells();
  EXPECT_TRUE(improvable_cells(patch.mesh, {}).empty());
  turn(patch, 1, 1);
  EXPECT_TRUE(improvable_cells(patch.mesh, {}).contains(kLeft));
  EXPECT_EQ(count(improvable_cells(patch.mesh, {})), 1u);
  CellSet left;
  left.insert(kLeft);
  EXPECT_TRUE(improvable_cells(patch.mesh, left).empty());
}

TEST(ImprovableCells, AreNotThoseWhoseIrregularNodesHaveToBe) {
  // A hexagon of three quads: the node in the middle has three, and its corners one or two, as their angles want.
  std::vector<Point> points{{0, 0}};
  for (int k = 0; k < 6; ++k) points.push_back({std::cos(k * 1.0471975511965976), std::sin(k * 1.0471975511965976)});
  std::vector<Polygon> quads;
  const auto n = [](int i) { return NodeId(static_cast<std::size_t>(i)); };
  for (int k = 0; k < 6; k += 2) quads.push_back({n(0), n(k + 1), n(k + 2), n((k + 2) % 6 + 1)});
  std::vector<NodeTag> tags(7, {NodeKind::Fixed, CurveId(), 0, VertexId(std::size_t{0})});
  tags[0] = {};
  WorkMesh mesh;
  mesh.build(points, tags, quads);
  for (std::size_t i = 0; i < 3; ++i) mesh.set_cell(FaceId(i), kLeft);
  EXPECT_TRUE(improvable_cells(mesh, {}).empty());
}

TEST(KeepCells, DropsTheOthers) {
  shapes::Patch patch = two_cells();
  CellSet left;
  left.insert(kLeft);
  keep_cells(patch.mesh, left);
  patch.mesh.drop_outside();
  patch.mesh.compact();
  EXPECT_EQ(patch.mesh.topo().face_count(), 16u);
  EXPECT_EQ(patch.mesh.segments.size(), 16u);  // of 28
  EXPECT_EQ(defect(patch.mesh), "");
}

TEST(BetterCells, AreJoinedAcrossTheLine) {
  shapes::Patch right_good = two_cells(), left_good = two_cells();
  turn(right_good, 1, 1);
  turn(left_good, 5, 2);
  const CellSet better = better_cells(right_good.mesh, left_good.mesh);
  EXPECT_TRUE(better.contains(kLeft));
  EXPECT_FALSE(better.contains(kRight));
  WorkMesh mesh = joined(right_good.mesh, left_good.mesh, better);
  EXPECT_EQ(defect(mesh), "");
  EXPECT_EQ(mesh.topo().face_count(), 32u);
  EXPECT_EQ(mesh.topo().node_count(), 45u);
  EXPECT_EQ(mesh.segments.size(), right_good.mesh.segments.size());
  EXPECT_TRUE(improvable_cells(mesh, {}).empty());
  for (const Segment& s : mesh.segments) EXPECT_EQ(mesh.curve(edge_of(mesh.topo().find(s.a, s.b))), s.curve);
}

TEST(BetterCells, AreNoneWhereTheOtherMeshIsDistorted) {
  shapes::Patch good = two_cells(), bad = two_cells();
  bad.mesh.move(bad.node(2, 2), {2.2, 2.2});
  EXPECT_TRUE(better_cells(good.mesh, bad.mesh).empty());
  EXPECT_TRUE(better_cells(bad.mesh, good.mesh).contains(kLeft));
  bad.mesh.move(bad.node(6, 2), {7.5, 3.5});  // tangled
  turn(good, 5, 1);
  EXPECT_FALSE(better_cells(good.mesh, bad.mesh).contains(kRight));
}

TEST(BetterCells, MayBeMissingInTheOtherMesh) {
  shapes::Patch all = two_cells(), left = two_cells();
  turn(all, 1, 1);
  CellSet cells;
  cells.insert(kLeft);
  keep_cells(left.mesh, cells);
  left.mesh.drop_outside();
  left.mesh.compact();
  const CellSet better = better_cells(all.mesh, left.mesh);
  EXPECT_EQ(count(better), 1u);
  EXPECT_EQ(joined(all.mesh, left.mesh, better).topo().face_count(), 32u);
}

}  // namespace
}  // namespace quadline
