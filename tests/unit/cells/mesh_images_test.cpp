#include "cells/mesh_images.hpp"

#include <gtest/gtest.h>

#include <set>

#include "tests/unit/grid_patch.hpp"

namespace quadline {
namespace {

using shapes::Patch;

// Of a square with a hole in its middle: all seven, without the identity.
std::vector<Symmetry> symmetries(const Patch& patch) { return find_symmetries(patch.domain); }

Patch frame(const std::vector<shapes::Spot>& turned = {}) {
  return shapes::patch({.nx = 5, .ny = 5, .keep = [](int i, int j) { return i != 2 || j != 2; }, .turned = turned});
}

TEST(ImagesOf, ASymmetricMeshHasAllOfThem) {
  const Patch patch = frame();
  const std::vector<Symmetry> all = symmetries(patch);
  ASSERT_EQ(all.size(), 7u);
  for (const Symmetry& symmetry : all) {
    const IdVector<NodeId, NodeId> image = images_of(patch.mesh, patch.domain, symmetry);
    std::set<NodeId> reached;
    for (const NodeId v : patch.mesh.topo().nodes()) {
      ASSERT_TRUE(image[v].valid());
      reached.insert(image[v]);
      EXPECT_NEAR(distance(symmetry.move(patch.mesh.point(v)), patch.mesh.point(image[v])), 0, 1e-12);
    }
    EXPECT_EQ(reached.size(), patch.mesh.topo().node_count());
  }
}

TEST(ImagesOf, GoesByConnectivityNotByPlace) {
  Patch patch = frame();
  patch.mesh.move(patch.node(1, 1), {1.3, 0.9});
  for (const Symmetry& symmetry : symmetries(patch)) {
    const IdVector<NodeId, NodeId> image = images_of(patch.mesh, patch.domain, symmetry);
    const Point at = symmetry.move({1, 1});
    EXPECT_EQ(image[patch.node(1, 1)],
              patch.node(static_cast<int>(std::lround(at.x)), static_cast<int>(std::lround(at.y))));
  }
}

TEST(ImagesOf, NoneWhereTheMeshIsNotSymmetric) {
  const Patch patch = frame({{0, 1}});  // an edge inside is turned, near the left edge
  for (const Symmetry& symmetry : symmetries(patch)) {
    const IdVector<NodeId, NodeId> image = images_of(patch.mesh, patch.domain, symmetry);
    std::size_t n_without = 0;
    for (const NodeId v : patch.mesh.topo().nodes()) n_without += !image[v].valid();
    EXPECT_GT(n_without, 0u);
    // None is wrong: edges go to edges wherever both ends have images.
    for (const NodeId v : patch.mesh.topo().nodes())
      if (!patch.mesh.is_free(v)) {
        EXPECT_TRUE(!image[v].valid() ||
                    distance(symmetry.move(patch.mesh.point(v)), patch.mesh.point(image[v])) < 1e-9);
      }
  }
}

}  // namespace
}  // namespace quadline
