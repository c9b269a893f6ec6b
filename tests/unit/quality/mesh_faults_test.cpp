#include "quadline/faults.hpp"

#include <gtest/gtest.h>

#include <map>
#include <string>

namespace quadline {
namespace {

/// The faults that were found, by name.
std::map<std::string, std::size_t> faults_of(std::vector<Point> points, std::vector<std::array<NodeIndex, 4>> quads,
                                             std::vector<std::array<NodeIndex, 3>> triangles = {}) {
  Mesh mesh;
  mesh.points = std::move(points);
  mesh.quads = std::move(quads);
  mesh.triangles = std::move(triangles);
  std::map<std::string, std::size_t> found;
  for (const MeshFault& fault : find_faults(mesh))
    if (fault.count > 0) found[fault.what] = fault.count;
  return found;
}

using Found = std::map<std::string, std::size_t>;

// 3 4 5
// 0 1 2
const std::vector<Point> kRow = {{0, 0}, {1, 0}, {2, 0}, {0, 1}, {1, 1}, {2, 1}};

TEST(MeshFaults, FindsNoneInAGoodMesh) {
  EXPECT_EQ(faults_of(kRow, {{0, 1, 4, 3}, {1, 2, 5, 4}}), Found());
  EXPECT_EQ(faults_of(kRow, {{0, 1, 4, 3}}, {{1, 2, 5}, {1, 5, 4}}), Found());
  EXPECT_EQ(faults_of({}, {}), Found());
}

TEST(MeshFaults, FindsBadElements) {
  EXPECT_EQ(faults_of(kRow, {{0, 3, 4, 1}}), Found({{"inverted elements", 1}}));
  EXPECT_EQ(faults_of(kRow, {{0, 1, 3, 4}}), Found({{"inverted elements", 1}}));  // crosses itself
  EXPECT_EQ(faults_of(kRow, {}, {{0, 4, 1}}), Found({{"inverted elements", 1}}));
  EXPECT_EQ(faults_of({{0, 0}, {1, 0}, {0.2, 0.2}, {0, 1}}, {{0, 1, 2, 3}}),
            Found({{"elements that are flat or not convex", 1}}));
  EXPECT_EQ(faults_of({{0, 0}, {1, 0}, {2, 0}, {0, 1}}, {{0, 1, 2, 3}}).count("elements that are flat or not convex"),
            1u);
  EXPECT_EQ(faults_of(kRow, {{0, 1, 1, 3}}), Found({{"elements that repeat a node", 1}}));
}

TEST(MeshFaults, FindsElementsOnEachOther) {
  const Found found = faults_of(kRow, {{0, 1, 4, 3}, {1, 4, 3, 0}});
  EXPECT_EQ(found.at("duplicate elements"), 1u);
  EXPECT_EQ(found.at("edges with two elements on a side"), 4u);
  EXPECT_EQ(faults_of(kRow, {{0, 1, 4, 3}}, {{0, 1, 5}}).at("edges with two elements on a side"), 1u);
}

TEST(MeshFaults, FindsHangingAndDoubledNodes) {
  // One quad beside two that are half as high.
  EXPECT_EQ(faults_of({{0, 0}, {1, 0}, {1, 1}, {0, 1}, {2, 0}, {2, 1}, {1, 0.5}, {2, 0.5}},
                      {{0, 1, 2, 3}, {1, 4, 7, 6}, {6, 7, 5, 2}}),
            Found({{"hanging nodes", 1}}));
  // Two quads that were not joined.
  EXPECT_EQ(
      faults_of({{0, 0}, {1, 0}, {1, 1}, {0, 1}, {1, 0}, {2, 0}, {2, 1}, {1, 1 + 1e-12}}, {{0, 1, 2, 3}, {4, 5, 6, 7}}),
      Found({{"nodes at the place of another", 2}}));
}

}  // namespace
}  // namespace quadline
