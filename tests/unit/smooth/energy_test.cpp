// The derivatives of the energies against differences of their values.
#include <gtest/gtest.h>

#include <cmath>
#include <utility>

#include "stages/smooth/beta_energy.hpp"
#include "stages/smooth/shape_energy.hpp"
#include "unit/grid_patch.hpp"

namespace quadline::smoothing {
namespace {

constexpr double kStep = 1e-5;

// Stars of a shaken grid with irregular nodes; lengths in units of 3.
class Energies : public testing::Test {
 protected:
  Energies() : patch_(shapes::patch({.nx = 6, .ny = 5, .h = 3, .turned = {{2, 2}}})) {
    patch_.domain.size = 2.5;
    patch_.domain.cells[CellId(0)].size = 2.5;
    shapes::shake(patch_, 0.5, 1);
  }

  template <class Energy, class Check>
  int for_each_star(const Energy& energy, Check check) {
    const SizeField size = patch_.size();
    const Stars stars(patch_.mesh, patch_.domain, size);
    Star star;
    int n = 0;
    for (std::size_t i = 0; i < stars.count(); ++i) {
      star.gather(stars, i);
      if (!energy.takes(star.least_sine2({}))) continue;
      check(star, energy.derivatives(star));
      ++n;
    }
    return n;
  }

  template <class Energy>
  void expect_derivatives(const Energy& energy, bool with_hessian) {
    const auto at = [&](const Star& star, double x, double y) { return energy.value(star, {x, y}, 0); };
    const int n = for_each_star(energy, [&](const Star& star, const Quadratic& q) {
      const double e = kStep, here = at(star, 0, 0), scale = 1e-6 * (1 + q.xx + q.yy);
      EXPECT_NEAR(q.value, here, 1e-12 * here);
      EXPECT_NEAR(q.gradient.x, (at(star, e, 0) - at(star, -e, 0)) / (2 * e), scale);
      EXPECT_NEAR(q.gradient.y, (at(star, 0, e) - at(star, 0, -e)) / (2 * e), scale);
      if (!with_hessian) return;
      EXPECT_NEAR(q.xx, (at(star, e, 0) - 2 * here + at(star, -e, 0)) / (e * e), 100 * scale);
      EXPECT_NEAR(q.yy, (at(star, 0, e) - 2 * here + at(star, 0, -e)) / (e * e), 100 * scale);
      const double mixed = at(star, e, e) - at(star, e, -e) - at(star, -e, e) + at(star, -e, -e);
      EXPECT_NEAR(q.xy, mixed / (4 * e * e), 100 * scale);
    });
    EXPECT_GT(n, 15);
  }

  shapes::Patch patch_;
};

TEST_F(Energies, Shape) { expect_derivatives(ShapeEnergy<1>(), true); }

TEST_F(Energies, HighPowerOfTheShape) { expect_derivatives(ShapeEnergy<8>(), true); }

TEST_F(Energies, ShapeLooksAtPoorStarsOnlyWhenAsked) {
  int n_all = 0, n_poor = 0;
  n_all = for_each_star(ShapeEnergy<1>(), [](const Star&, const Quadratic&) {});
  n_poor = for_each_star(ShapeEnergy<1>(0.5),
                         [](const Star& star, const Quadratic&) { EXPECT_LT(star.least_sine2({}), 0.5); });
  EXPECT_GT(n_poor, 0);
  EXPECT_LT(n_poor, n_all);
}

TEST_F(Energies, Barrier) { expect_derivatives(BarrierEnergy(0.3, HUGE_VAL), true); }

TEST_F(Energies, BarrierOfInvertedStars) {
  shapes::shake(patch_, 4, 2);
  expect_derivatives(BarrierEnergy(0.3, 0), true);
}

TEST_F(Energies, Beta) {
  expect_derivatives(BetaEnergy(0.3), false);
  expect_derivatives(BetaEnergy(0.03), false);
}

TEST_F(Energies, TheHessianOfBetaIsPositive) {
  for_each_star(BetaEnergy(0.03), [](const Star&, const Quadratic& q) {
    EXPECT_GT(q.xx, 0);
    EXPECT_GT(q.xx * q.yy, q.xy * q.xy);
  });
}

TEST(Star, RowsOfAGridAreEvenUntilANodeMoves) {
  shapes::Patch patch = shapes::patch({.nx = 6, .ny = 5, .h = 3});
  const auto missed = [&](NodeId moved) {  // over all stars but the one of the node that moved; of that one
    const SizeField size = patch.size();
    const Stars stars(patch.mesh, patch.domain, size);
    Star star;
    double others = 0, own = 0;
    for (std::size_t i = 0; i < stars.count(); ++i) {
      star.gather(stars, i);
      for (const Star::Row& row : star.rows())
        (stars.at(i) == patch.mesh.point(moved) ? own : others) += row.misses2({});
    }
    return std::pair(others, own);
  };
  const NodeId v = patch.node(3, 2);
  EXPECT_NEAR(missed(v).first + missed(v).second, 0, 1e-20);
  const Point at = patch.mesh.point(v), step{0.6, 0};
  patch.mesh.move(v, at + step);
  // Two rows through it, and four that begin with an edge of it: those beyond its neighbours are 6 away, or 6.6
  // and 5.4.
  EXPECT_NEAR(missed(v).second, 0.36 * (2. / 36 + 0.25 * (1 / 43.56 + 1 / 29.16 + 2 / 36.36)), 1e-12);
  EXPECT_GT(missed(v).first, 0);
}

TEST_F(Energies, AStarBelowTheFloorIsNotAllowed) {
  for_each_star(ShapeEnergy<1>(), [](const Star& star, const Quadratic&) {
    const double least = star.least_sine2({});
    EXPECT_TRUE(std::isfinite(BetaEnergy(0.1).value(star, {}, 0.99 * least)));
    EXPECT_EQ(BetaEnergy(0.1).value(star, {}, 1.01 * least), HUGE_VAL);
    EXPECT_TRUE(std::isfinite(ShapeEnergy<1>().value(star, {}, 0.99 * least)));
    EXPECT_EQ(ShapeEnergy<1>().value(star, {}, 1.01 * least), HUGE_VAL);
    EXPECT_EQ(ShapeEnergy<1>().value(star, {9, 9}, 0), HUGE_VAL);  // inverted
  });
}

TEST(Quadratic, StepGoesToTheMinimum) {
  Quadratic q;  // (x - 1)^2 + (y + 2)^2 + (x - 1) (y + 2) at the origin
  q.gradient = {-2 + 2, 4 - 1};
  q.xx = q.yy = 2;
  q.xy = 1;
  EXPECT_NEAR(q.step(1).x, 1, 1e-15);
  EXPECT_NEAR(q.step(1).y, -2, 1e-15);
  EXPECT_NEAR(q.step_along({0, 1}, 1).y, -1.5, 1e-15);
}

TEST(Quadratic, StepGoesDownhillWhereThereIsNoMinimum) {
  Quadratic q;
  q.gradient = {3, -4};
  q.xx = -1;
  q.yy = 1;
  EXPECT_NEAR(q.step(0.5).x, -0.3, 1e-15);
  EXPECT_NEAR(q.step(0.5).y, 0.4, 1e-15);
  EXPECT_NEAR(q.step_along({1, 0}, 0.5).x, -0.5, 1e-15);
}

}  // namespace
}  // namespace quadline::smoothing
