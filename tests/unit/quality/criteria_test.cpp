#include "quadline/criteria.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "quadline/quality.hpp"

namespace quadline {
namespace {

// A square, a rectangle 1 x 4 and a trapezium with corners of 45 and 135 degrees, apart from each other.
Mesh three_quads() {
  Mesh mesh;
  mesh.points = {{0, 0}, {1, 0}, {1, 1}, {0, 1}, {2, 0}, {6, 0}, {6, 1}, {2, 1}, {10, 0}, {13, 0}, {12, 1}, {11, 1}};
  mesh.quads = {{0, 1, 2, 3}, {4, 5, 6, 7}, {8, 9, 10, 11}};
  return mesh;
}

double worst(const Criteria& criteria, std::optional<double> size = {}) {
  return evaluate(three_quads(), criteria, size).limits.at(0).worst.at(0).value;
}

TEST(Criteria, ValuesByHand) {
  EXPECT_NEAR(worst({.min_angle_deg = 46}), 45, 1e-9);
  EXPECT_NEAR(worst({.max_angle_deg = 134}), 135, 1e-9);
  EXPECT_NEAR(worst({.max_aspect = 2}), 4, 1e-12);
  EXPECT_NEAR(worst({.min_scaled_jacobian = 0.8}), std::sqrt(0.5), 1e-12);
  EXPECT_NEAR(worst({.min_jacobian_ratio = 0.5}), 1.0 / 3, 1e-12);
  EXPECT_NEAR(worst({.max_taper = 0.3}), 0.5, 1e-12);
  EXPECT_NEAR(worst({.min_edge = 1.5}), 1, 1e-12);
  EXPECT_NEAR(worst({.max_edge = 3.5}), 4, 1e-12);
  EXPECT_NEAR(worst({.max_edge_to_size = 1.5}, 2), 2, 1e-12);
  Mesh rhombus;
  rhombus.points = {{0, 0}, {2, 0}, {3, 1}, {1, 1}};
  rhombus.quads = {{0, 1, 2, 3}};
  EXPECT_NEAR(evaluate(rhombus, {.max_skew_deg = 30}).limits[0].worst.at(0).value, 45, 1e-9);
}

TEST(Criteria, CountsPerLimitAndInAllAndNamesThePlace) {
  const CriteriaResult r = evaluate(three_quads(), {.max_aspect = 2, .min_edge = 1.2});
  EXPECT_EQ(r.n_failing, 3u);
  ASSERT_EQ(r.limits.size(), 2u);
  EXPECT_EQ(r.limits[0].n_failing, 2u);
  EXPECT_EQ(r.limits[0].worst[0].quad, 1u);
  EXPECT_NEAR(r.limits[0].worst[0].at.x, 4, 1e-12);
  EXPECT_NEAR(r.limits[0].worst[0].at.y, 0.5, 1e-12);
  EXPECT_EQ(r.limits[1].n_failing, 3u);
  EXPECT_EQ(r.limits[1].worst[0].quad, 0u);
}

TEST(Criteria, GrowthHasALimitOfItsOwn) {
  Mesh mesh;
  mesh.points = {{0, 0}, {1, 0}, {3, 0}, {0, 1}, {1, 1}, {3, 1}};
  mesh.quads = {{0, 1, 4, 3}, {1, 2, 5, 4}};
  EXPECT_EQ(named_criteria("growth")->max_growth, kGrowthLimit);
  const CriteriaResult r = evaluate(mesh, *named_criteria("growth"));
  EXPECT_EQ(r.n_failing, 2u);  // both sides of the shared edge
  EXPECT_NEAR(r.limits.at(0).worst.at(0).value, 2, 1e-12);
  EXPECT_EQ(evaluate(mesh, {.max_growth = 2}).n_failing, 0u);
}

TEST(Criteria, LengthsGoOverTheSizeAtTheirOwnEdge) {
  const Mesh mesh = three_quads();
  const Criteria limits{.min_edge_to_size = 0.9, .max_edge_to_size = 1.1};
  std::vector<double> size;  // each edge as long as asked for
  for (const auto& [a, b] : edges_of(mesh)) size.push_back(distance(mesh.points[a], mesh.points[b]));
  EXPECT_EQ(evaluate(mesh, limits, size).n_failing, 0u);
  EXPECT_EQ(evaluate(mesh, limits, 1.0).n_failing, 2u);
  size[0] *= 2;  // of the square
  const CriteriaResult r = evaluate(mesh, limits, size);
  EXPECT_EQ(r.n_failing, 1u);
  EXPECT_EQ(r.limits.at(0).worst.at(0).quad, 0u);
  EXPECT_NEAR(r.limits.at(0).worst.at(0).value, 0.5, 1e-12);
  EXPECT_FALSE(evaluate(mesh, limits, std::span<const double>()).limits.at(0).is_checked);
}

TEST(Criteria, AValueAtItsLimitPassesAndAnUnknownSizeIsNotChecked) {
  EXPECT_EQ(evaluate(three_quads(), *named_criteria("csr-fine")).limits[0].n_failing, 0u);
  const CriteriaResult r = evaluate(three_quads(), {.max_edge_to_size = 1});
  EXPECT_FALSE(r.limits[0].is_checked);
  EXPECT_EQ(r.n_failing, 0u);
  EXPECT_FALSE(named_criteria("no such set"));
}

}  // namespace
}  // namespace quadline
