#include "stages/cleanup/grow_patch.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "quad_shapes.hpp"

namespace quadline::cleanup {
namespace {

// Nodes of an 8 x 8 grid: 9 j + i.
struct Fixture {
  explicit Fixture(const WorkMesh& m) : mesh(m), sectors(mesh), size(mesh.topo().node_capacity(), 1.0) {}
  WorkMesh mesh;
  Sectors sectors;
  IdVector<NodeId, double> size;
  PatchGrower grower{mesh, sectors, size};
};

constexpr std::size_t kMiddle = 40;

TEST(GrowPatch, StartsWithTheStarOfTheNode) {
  Fixture f(shapes::grid(8, 8));
  ASSERT_TRUE(f.grower.start(NodeId(kMiddle)));
  EXPECT_EQ(f.grower.cavity().faces.size(), 4u);
  EXPECT_EQ(f.grower.corner_count(), 4);
  ASSERT_EQ(f.grower.rim().size(), 8u);
  EXPECT_EQ(f.grower.rim_cost(), 0);
  for (const PatchNode& r : f.grower.rim()) EXPECT_EQ(r.size, 1);
}

// A row at a time, along one of its sides; the same patch is never met twice.
TEST(GrowPatch, GrowsByRows) {
  Fixture f(shapes::grid(8, 8));
  ASSERT_TRUE(f.grower.start(NodeId(kMiddle)));
  std::size_t before = 4;
  int n_rows = 0;
  while (f.grower.grow()) {
    ++n_rows;
    const std::size_t n = f.grower.cavity().faces.size();
    EXPECT_GT(n, before);
    EXPECT_EQ(f.grower.corner_count(), 4);
    EXPECT_EQ(std::set<FaceId>(f.grower.cavity().faces.begin(), f.grower.cavity().faces.end()).size(), n);
    before = n;
  }
  EXPECT_EQ(n_rows, 12);  // from 2 x 2 to 8 x 8
  EXPECT_EQ(before, 64u);
}

// Row after row on the nearest side: a square round the node again after every four.
TEST(GrowPatch, GrowsRoundTheNode) {
  Fixture f(shapes::grid(8, 8));
  ASSERT_TRUE(f.grower.start(NodeId(kMiddle)));
  for (int reach = 2; reach <= 4; ++reach) {
    for (int row = 0; row < 4; ++row) ASSERT_TRUE(f.grower.grow());
    for (const PatchNode& r : f.grower.rim())
      EXPECT_EQ(std::max(std::abs(r.at.x - 4), std::abs(r.at.y - 4)), reach) << r.at.x << ", " << r.at.y;
  }
}

// Where a rim node wants three quads inside, the patch takes in all round it.
TEST(GrowPatch, GrowsOverNotches) {
  Fixture f(shapes::split_triangles(5, 1, 1, false));
  std::size_t n_over = 0;
  for (const NodeId v : f.mesh.topo().nodes()) {
    if (!f.mesh.is_free(v)) continue;
    bool more = f.grower.start(v);
    n_over += more && static_cast<int>(f.grower.cavity().faces.size()) > f.mesh.topo().edge_valence(v);
    for (; more; more = f.grower.grow())
      for (const Cavity::RimNode& r : f.grower.cavity().rim) EXPECT_LT(r.ideal.ideal - r.outside, 3);
  }
  EXPECT_GT(n_over, 0u);
}

TEST(GrowPatch, StopsAtLines) {
  Fixture f(shapes::grid(8, 8, 1, {{27, 28}, {28, 29}, {29, 30}, {30, 31}, {31, 32}, {32, 33}, {33, 34}, {34, 35}}));
  ASSERT_TRUE(f.grower.start(NodeId(kMiddle)));
  while (f.grower.grow()) continue;
  for (const FaceId face : f.grower.cavity().faces)
    for (const NodeId v : f.mesh.topo().polygon(face).nodes) EXPECT_TRUE(!v.valid() || f.mesh.point(v).y >= 3);
  EXPECT_EQ(f.grower.cavity().faces.size(), 40u);  // 8 x 5 above the line
}

// A node of three quads has a patch of three corners round it.
TEST(GrowPatch, KnowsTheCornersOfAnIrregularNode) {
  const WorkMesh triangles = shapes::split_triangles(2, 1, 1, false);
  Fixture f(triangles);
  std::size_t n_found = 0;
  for (const NodeId v : f.mesh.topo().nodes()) {
    if (!f.mesh.is_free(v) || f.mesh.topo().edge_valence(v) != 3 || !f.grower.start(v)) continue;
    n_found += f.grower.cavity().faces.size() == 3 && f.grower.rim().size() == 6;
  }
  EXPECT_GT(n_found, 0u);
}

}  // namespace
}  // namespace quadline::cleanup
