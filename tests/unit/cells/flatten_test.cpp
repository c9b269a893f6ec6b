#include "cells/flatten.hpp"

#include <gtest/gtest.h>

#include "unit/grid_patch.hpp"

namespace quadline {
namespace {

std::vector<Point> along(const Mesh& mesh, const EdgeSet& set) {
  std::vector<Point> points{mesh.points[set.edges.front()[0]]};
  for (std::size_t i = 0; i < set.edges.size(); ++i) {
    EXPECT_EQ(mesh.points[set.edges[i][0]], points.back()) << "edge " << i << " of " << set.name;
    points.push_back(mesh.points[set.edges[i][1]]);
  }
  return points;
}

TEST(Flatten, KeepsTheOrderOfNodesAndFaces) {
  const shapes::Patch patch = shapes::patch({.nx = 3, .ny = 2});
  const Mesh mesh = flatten(patch.mesh, patch.domain);
  ASSERT_EQ(mesh.points.size(), 12u);
  EXPECT_EQ(mesh.points[0], (Point{0, 0}));
  EXPECT_EQ(mesh.points[11], (Point{3, 2}));
  ASSERT_EQ(mesh.quads.size(), 6u);
  EXPECT_EQ(mesh.quads[0], (std::array<NodeIndex, 4>{0, 1, 5, 4}));
  EXPECT_EQ(mesh.quad_region, std::vector<std::uint32_t>(6, 0));
  EXPECT_EQ(mesh.regions, patch.domain.regions);
  EXPECT_TRUE(mesh.triangles.empty());
}

TEST(Flatten, CurvesRunFromEndToEnd) {
  const shapes::Patch patch = shapes::patch(
      {.nx = 5, .ny = 5, .keep = [](int i, int j) { return i != 3 || j != 3; }, .lines = {{{{1, 1}, {1, 4}}}}});
  const Mesh mesh = flatten(patch.mesh, patch.domain);
  ASSERT_EQ(mesh.curves.size(), 3u);
  EXPECT_EQ(mesh.curves[0].name, "outer-1");
  EXPECT_EQ(mesh.curves[0].kind, CurveKind::Outer);
  const std::vector<Point> outer = along(mesh, mesh.curves[0]);
  EXPECT_EQ(outer.size(), 21u);
  EXPECT_EQ(outer.front(), outer.back());
  EXPECT_EQ(mesh.curves[1].name, "hole-1");
  EXPECT_EQ(along(mesh, mesh.curves[1]).size(), 5u);
  EXPECT_EQ(along(mesh, mesh.curves[2]), (std::vector<Point>{{1, 1}, {1, 2}, {1, 3}, {1, 4}}));
}

TEST(Flatten, APathMayWalkACurveBackwards) {
  shapes::Patch patch = shapes::patch({.lines = {{{{1, 2}, {3, 2}}}}});
  patch.domain.paths.back().curves[0].reversed = true;
  const Mesh mesh = flatten(patch.mesh, patch.domain);
  EXPECT_EQ(along(mesh, mesh.curves.back()), (std::vector<Point>{{3, 2}, {2, 2}, {1, 2}}));
}

TEST(Flatten, PointsBecomeNodeSets) {
  const shapes::Patch patch = shapes::patch({.points = {{1, 2}, {3, 3}}});
  const Mesh mesh = flatten(patch.mesh, patch.domain);
  ASSERT_EQ(mesh.node_sets.size(), 2u);
  EXPECT_EQ(mesh.node_sets[1].name, "point-2");
  ASSERT_EQ(mesh.node_sets[1].nodes.size(), 1u);
  EXPECT_EQ(mesh.points[mesh.node_sets[1].nodes[0]], (Point{3, 3}));
}

TEST(Flatten, LeavesOutFacesOfNoCellAndTheirNodes) {
  shapes::Patch patch = shapes::patch({.nx = 2, .ny = 1});
  patch.mesh.set_cell(FaceId(1), CellId());
  const Mesh mesh = flatten(patch.mesh, patch.domain);
  EXPECT_EQ(mesh.quads.size(), 1u);
  EXPECT_EQ(mesh.points, (std::vector<Point>{{0, 0}, {1, 0}, {0, 1}, {1, 1}}));
}

TEST(Flatten, CellsNameTheRegionOfTheirFaces) {
  shapes::Patch patch = shapes::patch({.nx = 2, .ny = 1});
  patch.domain.regions.push_back("web");
  patch.domain.cells.push_back({});
  patch.domain.cells[CellId(1)].region = 1;
  patch.mesh.set_cell(FaceId(1), CellId(1));
  EXPECT_EQ(flatten(patch.mesh, patch.domain).quad_region, (std::vector<std::uint32_t>{0, 1}));
}

}  // namespace
}  // namespace quadline
