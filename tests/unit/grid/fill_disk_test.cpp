#include "stages/grid/fill_disk.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "tests/unit/grid/grid_shapes.hpp"

namespace quadline {
namespace {

const CellId kCell(std::size_t{0});

// A disk of radius 3 about (1, 2) whose arcs end in the direction of an angle.
Domain disk(double angle) {
  const Point center{1, 2}, way = 3.0 * Point{std::cos(angle), std::sin(angle)}, side = left_normal(way);
  return shapes::Builder({center + way, center - way}, {{0, 1, center + side}, {1, 0, center - side}}, 1).build();
}

TEST(FillDisk, HasFourNodesOfThreeQuads) {
  for (const unsigned side : {1u, 2u, 3u, 6u, 9u})
    for (const double angle : {0.0, 0.4, 2.0}) {
      const int rings = 1 + static_cast<int>(side) / 2;
      const Domain domain = disk(angle);
      WorkMesh mesh = shapes::nodes_on(domain, {2 * side, 2 * side});
      ASSERT_TRUE(fill_disk(mesh, domain, kCell, rings));
      EXPECT_EQ(shapes::unsound_count(mesh), 0u) << side;
      EXPECT_EQ(shapes::irregular_valences(mesh), std::vector<int>(4, 3)) << side;
      EXPECT_EQ(mesh.topo().face_count(), side * side + 4 * side * static_cast<unsigned>(rings));
      for (const FaceId f : mesh.topo().faces()) EXPECT_EQ(mesh.cell(f), kCell);
      for (const Segment& s : mesh.segments()) EXPECT_EQ(mesh.curve(edge_of(mesh.topo().find(s.a, s.b))), s.curve);
    }
}

// A quarter turn about the middle takes its nodes to its nodes.
TEST(FillDisk, IsTheSameFromAllFourSides) {
  const Domain domain = disk(0.25 * std::numbers::pi);
  WorkMesh mesh = shapes::nodes_on(domain, {10, 10});
  ASSERT_TRUE(fill_disk(mesh, domain, kCell, 3));
  for (const NodeId v : mesh.topo().nodes()) {
    const Point image = Point{1, 2} + left_normal(mesh.point(v) - Point{1, 2});
    double nearest = 1;
    for (const NodeId w : mesh.topo().nodes()) nearest = std::min(nearest, distance(mesh.point(w), image));
    EXPECT_LT(nearest, 1e-9);
  }
}

TEST(FillDisk, EdgesThatAreNoMultipleOfFourAreRefused) {
  const Domain domain = disk(0);
  WorkMesh mesh = shapes::nodes_on(domain, {7, 7});
  EXPECT_FALSE(fill_disk(mesh, domain, kCell, 3));
  EXPECT_EQ(mesh.topo().face_count(), 0u);
}

}  // namespace
}  // namespace quadline
