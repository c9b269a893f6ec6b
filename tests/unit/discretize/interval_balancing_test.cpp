// Labels make the counts even round every cell; balancing makes opposite sides equal without spoiling that.
#include <gtest/gtest.h>

#include "stages/discretize/count_state.hpp"
#include "tests/unit/domain/size/size_shapes.hpp"

namespace quadline {
namespace {

/// Three squares in a row.
Domain row_of_squares() {
  std::vector<Point> points;
  std::vector<shapes::Link> links;
  for (std::size_t i = 0; i <= 3; ++i) {
    points.push_back({5.0 * static_cast<double>(i), 0});
    points.push_back({5.0 * static_cast<double>(i), 5});
    links.push_back({2 * i, 2 * i + 1});
    if (i == 0) continue;
    links.push_back({2 * i - 2, 2 * i});
    links.push_back({2 * i - 1, 2 * i + 1});
  }
  return shapes::Builder(points, links, 1).build();
}

IdVector<CurveId, CountTarget> fives(std::size_t n) {
  IdVector<CurveId, CountTarget> targets;
  targets.assign(n, CountTarget{.length = 5});
  return targets;
}

void expect_even(const Domain& domain, const CountState& state) {
  for (const Domain::Cell& cell : domain.cells) {
    std::uint32_t sum = 0;
    for (const auto& walk : cell.walks)
      for (const DirectedCurve& d : walk) sum += state.count(d.curve);
    EXPECT_EQ(sum % 2, 0u);
  }
}

TEST(BalanceIntervals, MakesOppositeSidesEqualAcrossTheCells) {
  const Domain domain = row_of_squares();
  const auto targets = fives(domain.curves.count());
  const auto faces = find_submappable_faces(domain, targets);
  ASSERT_EQ(faces.size(), 3u);
  // Floor and roof of the square in the middle (links 5 and 6) differ by two: one edge less here, one more there.
  CountState state(targets, faces);
  IdVector<CurveId, std::uint32_t> counts;
  counts.assign(domain.curves.count(), 5u);
  counts[CurveId(5)] = 4;
  counts[CurveId(6)] = 6;
  state.start(counts);
  expect_even(domain, state);
  balance_intervals(domain, state);
  expect_even(domain, state);
  for (std::uint32_t f = 0; f < faces.size(); ++f) EXPECT_EQ(state.gap(f), 0) << f;
}

TEST(LabelCounts, AreEvenRoundEveryCellAndNearTheTargets) {
  const Domain domain = row_of_squares();
  IdVector<CurveId, CountTarget> targets = fives(domain.curves.count());
  for (std::size_t i = 0; i < targets.count(); ++i) targets[CurveId(i)].length = 4.1 + 0.37 * static_cast<double>(i);
  const std::vector<SubmappableFace> none;
  CountState state(targets, none);
  label_counts(domain, state);
  expect_even(domain, state);
  for (std::size_t i = 0; i < targets.count(); ++i)
    EXPECT_NEAR(state.count(CurveId(i)), targets[CurveId(i)].length, 1) << i;
}

}  // namespace
}  // namespace quadline
