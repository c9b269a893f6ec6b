#include "stages/pair/pair.hpp"

#include <gtest/gtest.h>

#include "unit/qmorph/shapes.hpp"

namespace quadline {
namespace {

TEST(Pair, HalvesOfSquaresFindEachOther) {
  WorkMesh mesh = shapes::triangulated_grid(6, 4, {{8, 9}, {9, 10}});
  Context context;
  pair_triangles(mesh, context);
  EXPECT_EQ(defect(mesh), "");
  EXPECT_EQ(mesh.topo().face_count(), 24u);
  EXPECT_EQ(shapes::n_triangles(mesh), 0u);
  EXPECT_EQ(shapes::n_constraints(mesh), 20u + 2);
}

TEST(Pair, TheBestPairGoesFirst) {  // the square of the three triangles, not the lozenge
  WorkMesh mesh = shapes::mesh_of({{0, 0}, {1, 0}, {1, 1}, {0, 1}, {1.6, 0.5}}, {{0, 1, 2}, {0, 2, 3}, {1, 4, 2}}, {});
  Context context;
  pair_triangles(mesh, context);
  ASSERT_EQ(mesh.topo().face_count(), 2u);
  ASSERT_EQ(shapes::n_triangles(mesh), 1u);
  const FaceId quad(mesh.topo().is_triangle(FaceId(0)) ? 1 : 0);
  EXPECT_EQ(scaled_jacobian(mesh.quad_points(quad)), 1);
}

TEST(Pair, NotAcrossALineNorWhereTheQuadWouldBePoor) {
  WorkMesh line = shapes::mesh_of({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, {{0, 1, 2}, {0, 2, 3}}, {{0, 2}});
  WorkMesh dart = shapes::mesh_of({{0, 0}, {2, 1}, {0, 2}, {0.5, 1}}, {{0, 1, 3}, {1, 2, 3}}, {});
  Context context;
  pair_triangles(line, context);
  pair_triangles(dart, context);
  EXPECT_EQ(shapes::n_triangles(line), 2u);
  EXPECT_EQ(shapes::n_triangles(dart), 2u);
}

TEST(Pair, QuadsStay) {
  WorkMesh mesh = shapes::mesh_of({{0, 0}, {1, 0}, {1, 1}, {0, 1}, {1.6, 0.5}}, {{0, 1, 2, 3}, {1, 4, 2}}, {});
  Context context;
  pair_triangles(mesh, context);
  EXPECT_EQ(mesh.topo().face_count(), 2u);
  EXPECT_EQ(shapes::n_triangles(mesh), 1u);
}

}  // namespace
}  // namespace quadline
