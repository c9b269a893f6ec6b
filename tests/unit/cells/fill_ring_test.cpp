#include "cells/fill_ring.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "tests/unit/grid/grid_shapes.hpp"

namespace quadline {
namespace {

const CellId kCell(std::size_t{0});

TEST(FillRing, IsOneRowOfFrozenQuads) {
  const Domain domain = shapes::ring(1, 2, 0.3);
  WorkMesh mesh = shapes::nodes_on(domain, {6, 6, 6, 6});
  ASSERT_TRUE(fill_ring(mesh, domain, kCell));
  EXPECT_EQ(mesh.topo().face_count(), 12u);
  EXPECT_EQ(shapes::unsound_count(mesh), 0u);
  EXPECT_TRUE(shapes::irregular_valences(mesh).empty());
  for (const FaceId f : mesh.topo().faces()) {
    EXPECT_EQ(mesh.cell(f), kCell);
    EXPECT_TRUE(mesh.is_frozen(f));
  }
  for (const Segment& s : mesh.segments()) EXPECT_EQ(mesh.curve(edge_of(mesh.topo().find(s.a, s.b))), s.curve);
}

// Spokes join nodes on one ray, wherever the two circles begin.
TEST(FillRing, SpokesAreRays) {
  const Domain domain =
      shapes::Builder({{2, 0}, {-2, 0}, {0, 1}, {0, -1}},
                      {{0, 1, Point{0, 2}}, {1, 0, Point{0, -2}}, {2, 3, Point{-1, 0}}, {3, 2, Point{1, 0}}}, 0.3)
          .build({{0, 0}});
  WorkMesh mesh = shapes::nodes_on(domain, {6, 6, 6, 6});
  ASSERT_TRUE(fill_ring(mesh, domain, kCell));
  for (const EdgeId e : mesh.topo().edges()) {
    if (mesh.curve(e).valid()) continue;
    const Point a = mesh.point(mesh.topo().tail(half_of(e, 0))), b = mesh.point(mesh.topo().tail(half_of(e, 1)));
    EXPECT_NEAR(cross(a, b), 0, 1e-9);
  }
}

TEST(FillRing, DifferentNumbersAreRefused) {
  const Domain domain = shapes::ring(1, 2, 0.3);
  WorkMesh mesh = shapes::nodes_on(domain, {6, 6, 6, 4});
  EXPECT_FALSE(fill_ring(mesh, domain, kCell));
  EXPECT_EQ(mesh.topo().face_count(), 0u);
}

}  // namespace
}  // namespace quadline
