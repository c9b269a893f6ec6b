#include "cells/cell_cache.hpp"

#include <gtest/gtest.h>

#include "tests/unit/grid_patch.hpp"

namespace quadline {
namespace {

TEST(CellCache, FingerprintTellsMeshesApart) {
  const shapes::Patch patch = shapes::patch({.nx = 3, .ny = 2}),
                      turned = shapes::patch({.nx = 3, .ny = 2, .turned = {{0, 0}}});
  shapes::Patch moved = patch;
  moved.mesh.move(moved.node(1, 1), {1, 1 + 1e-15});
  EXPECT_EQ(fingerprint(patch.mesh), fingerprint(shapes::patch({.nx = 3, .ny = 2}).mesh));
  EXPECT_NE(fingerprint(patch.mesh), fingerprint(turned.mesh));
  EXPECT_NE(fingerprint(patch.mesh), fingerprint(moved.mesh));
}

TEST(CellCache, KnowsACellThatBeginsTheSame) {
  const shapes::Patch patch = shapes::patch({.nx = 3, .ny = 2});
  CellCache cache(2);
  const CellId first(std::size_t{0}), second(std::size_t{1});
  EXPECT_EQ(cache.find(first, 7), nullptr);
  MorphCounts counts;
  counts.seams = 3;
  cache.keep(first, {7, patch.mesh, counts});
  ASSERT_NE(cache.find(first, 7), nullptr);
  EXPECT_EQ(cache.find(first, 7)->mesh.topo().face_count(), 6u);
  EXPECT_EQ(cache.find(first, 7)->counts, counts);
  EXPECT_EQ(cache.find(first, 8), nullptr);
  EXPECT_EQ(cache.find(second, 7), nullptr);
}

}  // namespace
}  // namespace quadline
