#include "quality/mesh_edges.hpp"

#include <gtest/gtest.h>

#include "quadline/quality.hpp"

namespace quadline {
namespace {

// A quad with a triangle on its right.
Mesh quad_and_triangle() {
  Mesh mesh;
  mesh.points = {{0, 0}, {1, 0}, {1, 1}, {0, 1}, {2, 0}};
  mesh.quads = {{2, 3, 0, 1}};
  mesh.triangles = {{4, 2, 1}};
  return mesh;
}

TEST(MeshEdges, AreInTheOrderOfEdgesOf) {
  const Mesh mesh = quad_and_triangle();
  const MeshEdges edges(mesh);
  const auto expected = edges_of(mesh);
  ASSERT_EQ(edges.count(), expected.size());
  for (std::size_t e = 0; e < edges.count(); ++e) EXPECT_EQ(edges.nodes(e), expected[e]);
}

TEST(MeshEdges, AreFoundFromEitherEnd) {
  const MeshEdges edges(quad_and_triangle());
  for (std::size_t e = 0; e < edges.count(); ++e) {
    const auto [a, b] = edges.nodes(e);
    EXPECT_EQ(edges.find(a, b), e);
    EXPECT_EQ(edges.find(b, a), e);
  }
  EXPECT_EQ(edges.find(0, 2), edges.count());  // a diagonal
  EXPECT_EQ(edges.find(3, 4), edges.count());
  EXPECT_EQ(edges.find(7, 9), edges.count());  // nodes that are not there
  EXPECT_EQ(edges.find(1, 9), edges.count());
}

TEST(MeshEdges, KnowTheSidesOfTheFacesAtThem) {
  const MeshEdges edges(quad_and_triangle());
  const auto shared = edges.sides(edges.find(1, 2));
  ASSERT_EQ(shared.size(), 2u);
  EXPECT_EQ(shared[0].face, 0u);
  EXPECT_EQ(shared[0].corner, 3u);
  EXPECT_TRUE(shared[0].forward);  // from 1 to 2
  EXPECT_EQ(shared[1].face, 1u);
  EXPECT_EQ(shared[1].corner, 1u);
  EXPECT_FALSE(shared[1].forward);
  const auto rim = edges.sides(edges.find(2, 4));
  ASSERT_EQ(rim.size(), 1u);
  EXPECT_EQ(rim[0].face, 1u);
  EXPECT_FALSE(rim[0].forward);
}

TEST(MeshEdges, KeepAllSidesWhereFacesOverlap) {
  Mesh mesh = quad_and_triangle();
  mesh.quads.push_back(mesh.quads[0]);
  const MeshEdges edges(mesh);
  EXPECT_EQ(edges.sides(edges.find(1, 2)).size(), 3u);
  EXPECT_EQ(edges.sides(edges.find(0, 1)).size(), 2u);
}

}  // namespace
}  // namespace quadline
