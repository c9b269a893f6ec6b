// A grid is kept where its quads are as good as a grid's should be.
#include "cells/accept_grid.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "base/constants.hpp"
#include "geom/angles.hpp"
#include "tests/unit/grid_patch.hpp"

namespace quadline {
namespace {

using shapes::Patch;

bool is_good(const Patch& patch, double size = 1) {
  return is_good_grid(patch.mesh, patch.domain, SizeField::constant(size));
}

TEST(IsGoodGrid, ARegularOneIs) { EXPECT_TRUE(is_good(shapes::patch({.nx = 5, .ny = 4}))); }

TEST(IsGoodGrid, NotWithEdgesFarFromTheSize) {
  const Patch patch = shapes::patch({.nx = 5, .ny = 4});
  EXPECT_TRUE(is_good(patch, 1 / 1.75));
  EXPECT_FALSE(is_good(patch, 1 / 1.85));
  EXPECT_TRUE(is_good(patch, 1 / 0.45));
  EXPECT_FALSE(is_good(patch, 1 / 0.35));
}

TEST(IsGoodGrid, ShortEdgesAreAllowedRoundAHoleWithRings) {
  Patch patch = shapes::patch({.nx = 5, .ny = 5, .keep = [](int i, int j) { return i != 2 || j != 2; }});
  EXPECT_FALSE(is_good(patch, 3));
  const std::vector<DirectedCurve>& hole = patch.domain.cells[CellId(std::size_t{0})].walks[1];
  WorkMesh& mesh = patch.mesh;
  for (const EdgeId e : mesh.topo().edges())
    if (mesh.curve(e).valid())
      mesh.add_segment({mesh.topo().tail(half_of(e)), mesh.topo().head(half_of(e)), mesh.curve(e)});
  EXPECT_FALSE(is_good(patch, 3));
  for (const DirectedCurve& d : hole) patch.domain.curves[d.curve].has_rings = true;
  EXPECT_TRUE(is_good(patch, 3));
}

TEST(IsGoodGrid, NotWithAnObliqueQuadInside) {
  Patch patch = shapes::patch({.nx = 5, .ny = 5});
  patch.mesh.move(patch.node(2, 2), {2.25, 2.25});
  EXPECT_TRUE(is_good(patch));
  patch.mesh.move(patch.node(2, 2), {2.38, 2.38});  // a corner gets a sine of 0.45
  EXPECT_GT(shapes::least_jacobian(patch.mesh), 0.35);
  EXPECT_FALSE(is_good(patch));
}

TEST(IsGoodGrid, LessIsAllowedWhereACornerOfTheDomainIsSharp) {
  Patch patch = shapes::patch({.nx = 1, .ny = 1});
  for (const double degrees : {30.0, 20.0}) {
    for (const int i : {0, 1})
      patch.mesh.move(patch.node(i, 1), Point{i + 0.0, 0} + turned({1, 0}, degrees / kDegreesPerRadian));
    EXPECT_NEAR(shapes::least_jacobian(patch.mesh), std::sin(degrees / kDegreesPerRadian), 1e-12);
    EXPECT_TRUE(is_good(patch)) << degrees;
  }
  // Where all corners of the domain are right there is no reason.
  Patch square = shapes::patch({.nx = 2, .ny = 2, .h = 1});
  EXPECT_TRUE(is_good(square));
  square.mesh.move(square.node(1, 1), {1.35, 1.35});
  EXPECT_GT(shapes::least_jacobian(square.mesh), 0.35);
  EXPECT_FALSE(is_good(square));
}

TEST(IsGoodGrid, NotWithAQuadThatIsNotConvex) {
  Patch patch = shapes::patch({.nx = 5, .ny = 5});
  patch.mesh.move(patch.node(2, 2), {3.1, 3.1});
  EXPECT_FALSE(is_good(patch));
}

}  // namespace
}  // namespace quadline
