#include "stages/discretize/cell_targets.hpp"

#include <gtest/gtest.h>

#include "stages/discretize/intervals.hpp"
#include "tests/unit/domain/size/size_shapes.hpp"

namespace quadline {
namespace {

IdVector<CurveId, CountTarget> targets_of(std::initializer_list<double> lengths) {
  IdVector<CurveId, CountTarget> targets;
  for (const double length : lengths) targets.push_back({.length = length});
  return targets;
}

Domain triangle() { return shapes::Builder({{0, 0}, {9, 0}, {4.5, 7}}, {{0, 1}, {1, 2}, {2, 0}}, 9).build(); }

TEST(WidenTriangles, AsksForTwoEdgesOnEachSide) {
  const Domain domain = triangle();
  auto targets = targets_of({1, 1, 1});
  widen_triangles(domain, targets);
  for (const CountTarget& target : targets) EXPECT_EQ(target.least, 2u);
}

TEST(WidenTriangles, AsksForNothingElsewhere) {
  const Domain domain = shapes::rectangle(4, 3, 4);
  auto targets = targets_of({1, 1, 1, 1});
  widen_triangles(domain, targets);
  for (const CountTarget& target : targets) EXPECT_EQ(target.least, 1u);
}

TEST(ChooseCounts, GivesNoSideOfATriangleOneEdge) {
  const Domain domain = triangle();
  // By the targets alone two, one and one would do.
  for (const std::uint32_t count : choose_counts(domain, targets_of({2, 1, 1}))) EXPECT_GE(count, 2u);
}

}  // namespace
}  // namespace quadline
