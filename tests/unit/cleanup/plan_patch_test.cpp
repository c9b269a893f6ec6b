#include "stages/cleanup/plan_patch.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace quadline::cleanup {
namespace {

// A regular polygon of unit edges, about, with these numbers of edges along its sides.
std::vector<PatchNode> patch(const std::vector<int>& sides, double size = 1) {
  int n_edges = 0;
  for (const int s : sides) n_edges += s;
  std::vector<PatchNode> rim;
  for (const int s : sides)
    for (int k = 0; k < s; ++k) {
      const double a = 2 * std::numbers::pi * static_cast<double>(rim.size()) / n_edges;
      rim.push_back({n_edges / (2 * std::numbers::pi) * Point{std::cos(a), std::sin(a)}, size, k == 0});
    }
  return rim;
}

// s(i) = t(i-1) + t(i+1), by a look at all rows there can be.
bool has_rows(const std::vector<int>& sides, Numbers& rows) {
  const std::size_t n = sides.size();
  Numbers t{};
  const auto look = [&](const auto& self, std::size_t k) -> bool {
    if (k == n) {
      for (std::size_t i = 0; i < n; ++i)
        if (sides[i] != t[(i + n - 1) % n] + t[(i + 1) % n]) return false;
      rows = t;
      return true;
    }
    for (t[k] = 1; t[k] < 8; ++t[k])
      if (self(self, k + 1)) return true;
    return false;
  };
  return look(look, 0);
}

TEST(SolveRows, FindsTheRowsOfTrianglesAndPentagons) {
  for (int a = 1; a < 7; ++a)
    for (int b = 1; b < 7; ++b)
      for (int c = 1; c < 7; ++c) {
        Numbers rows{}, expected{};
        const bool has = has_rows({a, b, c}, expected);
        ASSERT_EQ(solve_rows({a, b, c}, 3, false, rows), has) << a << b << c;
        for (std::size_t k = 0; has && k < 3; ++k) EXPECT_EQ(rows[k], expected[k]);
      }
  for (int a = 2; a < 5; ++a)
    for (int b = 2; b < 5; ++b)
      for (int c = 2; c < 6; ++c) {
        Numbers rows{}, expected{};
        const bool has = has_rows({a, b, c, b, 3}, expected);
        ASSERT_EQ(solve_rows({a, b, c, b, 3}, 5, false, rows), has) << a << b << c;
        for (std::size_t k = 0; has && k < 5; ++k) EXPECT_EQ(rows[k], expected[k]);
      }
}

TEST(SolveRows, FourSidesMatchOrDoNot) {
  Numbers rows{};
  EXPECT_TRUE(solve_rows({3, 5, 3, 5}, 4, false, rows));
  EXPECT_FALSE(solve_rows({3, 5, 4, 5}, 4, false, rows));
  EXPECT_FALSE(solve_rows({3, 5, 3, 4}, 4, false, rows));
  EXPECT_FALSE(solve_rows({4, 4}, 2, false, rows));
}

TEST(SolveRows, OnlyACutMayHoldTheNodeItself) {
  Numbers rows{};
  EXPECT_FALSE(solve_rows({2, 2, 4}, 3, false, rows));
  ASSERT_TRUE(solve_rows({2, 2, 4}, 3, true, rows));  // the last side is the cut
  EXPECT_EQ(rows[2], 0);
  EXPECT_FALSE(solve_rows({4, 2, 2}, 3, true, rows));
}

TEST(PlanPatch, AWholePatchNeedsNoCut) {
  for (const auto& sides : {std::vector{3, 4, 3, 4}, std::vector{4, 4, 4}, std::vector{4, 4, 4, 4, 4}}) {
    const std::vector<PatchPlan> plans = plan_patch(patch(sides), 2);
    ASSERT_EQ(plans.size(), 1u);
    EXPECT_EQ(plans[0].from, plans[0].to);
    EXPECT_EQ(plans[0].n_irregular, sides.size() == 4 ? 0 : 1);
  }
}

TEST(PlanPatch, NoPlanHasMoreIrregularNodesThanAllowed) {
  EXPECT_TRUE(plan_patch(patch({4, 4, 4}), 0).empty());
  EXPECT_TRUE(plan_patch(patch({4, 3, 4, 5}), 1).empty());
  EXPECT_FALSE(plan_patch(patch({4, 3, 4, 5}), 2).empty());
}

TEST(PlanPatch, TheBestComesFirst) {
  const std::vector<PatchPlan> plans = plan_patch(patch({5, 4, 3, 6}), 2);
  ASSERT_GT(plans.size(), 1u);
  for (std::size_t i = 1; i < plans.size(); ++i) {
    EXPECT_LE(plans[i - 1].n_irregular, plans[i].n_irregular);
    if (plans[i - 1].n_irregular == plans[i].n_irregular) {
      EXPECT_LE(plans[i - 1].strain, plans[i].strain);
    }
  }
}

// Rows of a third of the size would be planned here.
TEST(PlanPatch, ARimThatDoesNotFitTheSizesHasNoPlan) {
  EXPECT_FALSE(plan_patch(patch({4, 4, 4, 4}, 1), 0).empty());
  EXPECT_TRUE(plan_patch(patch({4, 4, 4, 4}, 8), 0).empty());
  for (int a = 2; a < 10; ++a)
    for (int b = 2; b < 10; ++b)
      for (const PatchPlan& plan : plan_patch(patch({a, b, 3, a}), 2)) EXPECT_LE(plan.strain, 3);
  EXPECT_TRUE(plan_patch(patch({4, 3, 4, 5}, 8), 2).empty());
}

}  // namespace
}  // namespace quadline::cleanup
