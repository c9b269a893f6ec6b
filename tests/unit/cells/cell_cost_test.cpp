#include "cells/cell_cost.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "tests/unit/grid_patch.hpp"

namespace quadline {
namespace {

shapes::Patch plate() { return shapes::patch({.nx = 8, .ny = 4}); }

/// The two squares above and right of a place, split along the other way: nodes of three and of five quads.
void turn(shapes::Patch& patch, int i, int j) {
  const auto n = [&](int k, int l) { return patch.node(i + k, j + l); };
  const Topology& topo = patch.mesh.topo();
  const std::vector<FaceId> pair{topo.face(topo.find(n(0, 0), n(1, 0))), topo.face(topo.find(n(1, 0), n(2, 0)))};
  std::vector<FaceId> made;
  patch.mesh.replace_cavity(
      pair, std::vector<Polygon>{{n(0, 0), n(1, 0), n(2, 0), n(2, 1)}, {n(2, 1), n(1, 1), n(0, 1), n(0, 0)}}, made);
}

TEST(Improvable, HasNodesOfTooManyAndOfTooFewQuads) {
  shapes::Patch patch = plate();
  EXPECT_FALSE(is_improvable(patch.mesh));
  turn(patch, 1, 1);
  EXPECT_TRUE(is_improvable(patch.mesh));
}

TEST(Improvable, IsNotWhereTheIrregularNodesHaveToBe) {
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
  for (std::size_t i = 0; i < 3; ++i) mesh.set_cell(FaceId(i), CellId(std::size_t{0}));
  EXPECT_FALSE(is_improvable(mesh));
}

TEST(Improvable, IsNoLargeCell) {
  shapes::Patch patch = shapes::patch({.nx = 101, .ny = 100});
  turn(patch, 1, 1);
  EXPECT_FALSE(is_improvable(patch.mesh));
}

TEST(CellCost, CountsIrregularNodesThenDistortionAndTanglesMost) {
  shapes::Patch good = plate(), distorted = plate(), turned = plate(), tangled = plate();
  distorted.mesh.move(distorted.node(2, 2), {2.2, 2.2});
  turn(turned, 1, 1);
  tangled.mesh.move(tangled.node(6, 2), {7.5, 3.5});
  EXPECT_NEAR(cell_cost(good.mesh), 0, 1e-12);
  EXPECT_GT(cell_cost(distorted.mesh), 0);
  EXPECT_LT(cell_cost(distorted.mesh), 1);
  EXPECT_GT(cell_cost(turned.mesh), 2);
  EXPECT_GT(cell_cost(tangled.mesh), 1000);
}

}  // namespace
}  // namespace quadline
