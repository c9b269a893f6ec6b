#include "stages/discretize/submappable_faces.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/unit/domain/size/size_shapes.hpp"

namespace quadline {
namespace {

IdVector<CurveId, CountTarget> targets_of(std::initializer_list<double> lengths) {
  IdVector<CurveId, CountTarget> targets;
  for (const double length : lengths) targets.push_back({.length = length});
  return targets;
}

using Side = std::vector<CurveId>;

TEST(SubmappableFaces, ARectangleIsOneWithASideInEachDirection) {
  const Domain domain = shapes::rectangle(4, 3, 1);
  const auto faces = find_submappable_faces(domain, targets_of({4, 3, 4, 3}));
  ASSERT_EQ(faces.size(), 1u);
  EXPECT_FALSE(faces[0].is_ring());
  for (std::size_t k = 0; k < 4; ++k) EXPECT_EQ(faces[0].sides[k].size(), 1u);
  EXPECT_EQ(faces[0].is_close, (std::array<bool, 2>{true, true}));
}

TEST(SubmappableFaces, AnLHasTwoCurvesOnTwoOfItsSides) {
  const Domain domain = shapes::Builder({{0, 0}, {8, 0}, {8, 3}, {4, 3}, {4, 6}, {0, 6}},
                                        {{0, 1}, {1, 2}, {2, 3}, {3, 4}, {4, 5}, {5, 0}}, 1)
                            .build();
  const auto faces = find_submappable_faces(domain, targets_of({8, 3, 4, 3, 4, 6}));
  ASSERT_EQ(faces.size(), 1u);
  std::vector<std::size_t> sizes;
  for (const Side& side : faces[0].sides) sizes.push_back(side.size());
  std::sort(sizes.begin(), sizes.end());
  EXPECT_EQ(sizes, (std::vector<std::size_t>{1, 1, 2, 2}));
}

TEST(SubmappableFaces, OppositeSidesThatWantDifferentCountsAreNone) {
  const Domain domain = shapes::rectangle(4, 3, 1);
  EXPECT_TRUE(find_submappable_faces(domain, targets_of({4, 3, 40, 30})).empty());
}

TEST(SubmappableFaces, ATriangleIsNone) {
  const Domain domain = shapes::Builder({{0, 0}, {9, 0}, {4.5, 7}}, {{0, 1}, {1, 2}, {2, 0}}, 1).build();
  EXPECT_TRUE(find_submappable_faces(domain, targets_of({9, 8, 8})).empty());
}

TEST(EvenOut, BringsOppositeSidesTogetherWithinItsLimits) {
  const Domain domain = shapes::rectangle(4, 3, 1);
  auto targets = targets_of({10, 3, 11, 3});
  even_out(find_submappable_faces(domain, targets), targets);
  EXPECT_NEAR(targets[CurveId(0)].length, targets[CurveId(2)].length, 0.05);
  EXPECT_GE(targets[CurveId(2)].length, 11 / kMostCoarsened);
  EXPECT_LE(targets[CurveId(0)].length, 10 * kMostRefined);
  EXPECT_NEAR(targets[CurveId(1)].length, 3, 1e-9);
}

}  // namespace
}  // namespace quadline
