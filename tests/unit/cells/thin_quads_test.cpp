#include "cells/thin_quads.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>
#include <vector>

#include "cells/mesh_cell.hpp"
#include "domain/arrange/arrange.hpp"
#include "stages/verify/verify.hpp"
#include "tests/unit/cells/two_cells.hpp"
#include "tests/unit/grid_patch.hpp"

namespace quadline {
namespace {

std::size_t n_frozen(const WorkMesh& mesh) {
  std::size_t n = 0;
  for (std::size_t i = 0; i < mesh.topo().face_capacity(); ++i)
    n += mesh.topo().is_live(FaceId(i)) && mesh.is_frozen(FaceId(i));
  return n;
}

FaceId face_at(const shapes::Patch& patch, int i, int j) {
  return patch.mesh.topo().face(patch.mesh.topo().find(patch.node(i, j), patch.node(i + 1, j)));
}

TEST(ThinQuads, UnsoundAreReflexAndFlatOnes) {
  shapes::Patch patch = shapes::patch({.nx = 4, .ny = 4});
  EXPECT_TRUE(unsound_faces(patch.mesh).empty());
  patch.mesh.move(patch.node(1, 1), {0.5, 0.5 + 1e-9});
  EXPECT_EQ(unsound_faces(patch.mesh), std::vector<FaceId>{face_at(patch, 0, 0)});
  patch.mesh.move(patch.node(1, 1), {0.4, 0.4});
  EXPECT_EQ(unsound_faces(patch.mesh), std::vector<FaceId>{face_at(patch, 0, 0)});
  EXPECT_EQ(centre_of(patch.mesh, face_at(patch, 2, 3)), (Point{2.5, 3.5}));
}

// A spike of a quad in the middle, its corners in the plate.
shapes::Patch with_spike(double sine) {
  shapes::Patch patch = shapes::patch({.nx = 4, .ny = 4});
  patch.mesh.move(patch.node(2, 2), {2.02, 1.02});
  patch.mesh.move(patch.node(1, 2), {1 + std::sqrt(1 - sine * sine), 1 + sine});
  return patch;
}

TEST(ThinQuads, AreFrozenBelowAScaledJacobianOfOneTwentieth) {
  for (const double sine : {0.045, 0.055}) {
    shapes::Patch patch = with_spike(sine);
    freeze_thin_quads(patch.mesh);
    EXPECT_EQ(patch.mesh.is_frozen(face_at(patch, 1, 1)), sine < 0.05) << sine;
    EXPECT_FALSE(patch.mesh.is_frozen(face_at(patch, 3, 3)));
  }
}

// Its corner at (2, 2) has 175 degrees.
TEST(ThinQuads, AreFrozenWithAWideCornerAtANodeThatStays) {
  for (const bool stays : {false, true}) {
    shapes::Patch patch =
        shapes::patch({.nx = 4, .ny = 4, .points = {stays ? shapes::Spot{2, 2} : shapes::Spot{3, 3}}});
    patch.mesh.move(patch.node(2, 1), {2.5, 1.45});
    patch.mesh.move(patch.node(1, 2), {1.45, 2.5});
    freeze_thin_quads(patch.mesh);
    EXPECT_EQ(patch.mesh.is_frozen(face_at(patch, 1, 1)), stays);
  }
}

TEST(ThinQuads, NearPlacesAreFrozenUpToTheReach) {
  shapes::Patch patch = shapes::patch({.nx = 8, .ny = 8});
  freeze_near(patch.mesh, {{0.5, 0.5}, {7.5, 7.5}}, 2.1, patch.size());
  EXPECT_EQ(n_frozen(patch.mesh), 18u);
}

// Halved triangles between lines that end beside another.
TEST(ThinQuads, AreKeptByCleanUpWhereTheRecipeSaysSo) {
  Context context;
  const Domain domain = arrange(shapes::near_ends(), {}, context);
  const SizeField size = make_size_field(domain, {}, context);
  SpacedSizes sizes(size);
  sizes.add(kHalvedSpacing);
  const cleanup::TemplateTable templates;
  CellSet halved;
  halved.insert(CellId(std::size_t{0}));
  const CurveNodes nodes(domain, size, {}, {}, halved, context);
  const CellInput input{domain, CellId(std::size_t{0}), nodes, sizes, templates};
  const auto thin_quads = [](const WorkMesh& mesh) {
    std::set<std::vector<std::pair<double, double>>> quads;
    for (std::size_t i = 0; i < mesh.topo().face_capacity(); ++i) {
      if (!mesh.topo().is_live(FaceId(i))) continue;
      const QuadPoints q = mesh.quad_points(FaceId(i));
      if (scaled_jacobian(q) > 0.05 || !is_sound(q)) continue;
      std::vector<std::pair<double, double>> corners;
      for (const Point p : q) corners.push_back({p.x, p.y});
      std::sort(corners.begin(), corners.end());
      quads.insert(corners);
    }
    return quads;
  };
  const CellResult kept = mesh_cell(input, {.method = Method::Merge, .keeps_thin_quads = true}, context);
  EXPECT_GT(thin_quads(kept.raw).size(), 3u);
  EXPECT_EQ(thin_quads(kept.mesh), thin_quads(kept.raw));
  EXPECT_NE(thin_quads(mesh_cell(input, {.method = Method::Merge}, context).mesh), thin_quads(kept.raw));
}

}  // namespace
}  // namespace quadline
