#include "stages/cleanup/fill_patch.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>

namespace quadline::cleanup {
namespace {

// A round patch of unit edges, about, with the given numbers of edges along its sides.
std::vector<PatchNode> patch(const std::vector<int>& sides) {
  int n_edges = 0;
  for (const int s : sides) n_edges += s;
  std::vector<PatchNode> rim;
  for (const int s : sides) {
    for (int k = 0; k < s; ++k) {
      const double a = 2 * std::numbers::pi * static_cast<double>(rim.size()) / n_edges;
      rim.push_back({n_edges / (2 * std::numbers::pi) * Point{std::cos(a), std::sin(a)}, 1, k == 0});
    }
  }
  return rim;
}

// Fills the disk, with one quad at corners and two at sides, and as many irregular nodes as it says.
void expect_sound(const std::vector<PatchNode>& rim, const Filling& filling) {
  std::map<std::pair<int, int>, int> halves;
  std::map<int, int> quads;
  for (const auto& q : filling.quads) {
    for (int k = 0; k < 4; ++k) {
      EXPECT_EQ((++halves[{q[k], q[(k + 1) % 4]}]), 1);
      ++quads[q[k]];
    }
  }
  const int n_rim = static_cast<int>(rim.size());
  EXPECT_EQ(static_cast<int>(quads.size()), n_rim + filling.n_inner);
  EXPECT_EQ(static_cast<int>(filling.quads.size()), filling.n_inner + n_rim / 2 - 1);
  for (const auto& [half, n] : halves) {
    const bool on_rim = half.first < n_rim && half.second == (half.first + 1) % n_rim;
    EXPECT_EQ(halves.count({half.second, half.first}), on_rim ? 0u : 1u);
  }
  int n_irregular = 0;
  for (const auto& [v, n] : quads) {
    if (v < n_rim) {
      EXPECT_EQ(n, rim[static_cast<std::size_t>(v)].is_corner ? 1 : 2) << v;
    } else {
      n_irregular += n != 4;
    }
  }
  EXPECT_LE(n_irregular, filling.n_irregular);
}

int least_irregular(const std::vector<int>& sides) {
  const auto rim = patch(sides);
  const auto fillings = fill_patch(rim, 3, 2);
  for (const Filling& filling : fillings) expect_sound(rim, filling);
  return fillings.empty() ? -1 : fillings[0].n_irregular;
}

TEST(FillPatch, MakesAGridOfFourMatchingSides) {
  EXPECT_EQ(least_irregular({4, 3, 4, 3}), 0);
  EXPECT_EQ(least_irregular({1, 1, 1, 1}), 0);
  EXPECT_EQ(least_irregular({6, 5, 6, 5}), 0);
}

TEST(FillPatch, PutsOneNodeOfThreeQuadsInATriangle) {
  EXPECT_EQ(least_irregular({2, 2, 2}), 1);
  EXPECT_EQ(least_irregular({5, 4, 3}), 1);
  EXPECT_EQ(least_irregular({8, 6, 8}), 1);
}

TEST(FillPatch, PutsOneNodeOfFiveQuadsInAPentagon) {
  EXPECT_EQ(least_irregular({4, 4, 4, 4, 4}), 1);
  EXPECT_EQ(least_irregular({6, 6, 7, 6, 7}), 1);
}

TEST(FillPatch, CutsFourSidesThatDoNotMatch) {
  EXPECT_EQ(least_irregular({4, 3, 4, 5}), 2);
  EXPECT_EQ(least_irregular({4, 4, 5, 5}), 2);
  EXPECT_EQ(least_irregular({5, 4, 3, 6}), 2);
}

TEST(FillPatch, CutsTwoCornersInTwoTriangles) { EXPECT_EQ(least_irregular({8, 8}), 2); }

TEST(FillPatch, GivesUpWhatDoesNotFit) {
  EXPECT_EQ(least_irregular({7, 1, 2}), -1);  // no triangle
  EXPECT_EQ(least_irregular({6}), -1);        // one corner
  EXPECT_TRUE(fill_patch(patch({4, 4, 5, 5}), 3, 1).empty());
}

}  // namespace
}  // namespace quadline::cleanup
