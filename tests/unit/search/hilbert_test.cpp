#include "search/hilbert.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace quadline {
namespace {

std::vector<Point> grid(int side) {
  std::vector<Point> points;
  for (int j = 0; j < side; ++j)
    for (int i = 0; i < side; ++i) points.push_back({i + 0.0, j + 0.0});
  return points;
}

void expect_each_once(std::vector<std::uint32_t> order, std::size_t n) {
  ASSERT_EQ(order.size(), n);
  std::sort(order.begin(), order.end());
  for (std::uint32_t i = 0; i < n; ++i) EXPECT_EQ(order[i], i);
}

TEST(HilbertOrder, GoesRoundByShortSteps) {
  const std::vector<Point> points = grid(32);
  const auto order = hilbert_order(points);
  expect_each_once(order, points.size());
  double way = 0;
  for (std::size_t i = 1; i < order.size(); ++i) way += distance(points[order[i - 1]], points[order[i]]);
  EXPECT_LT(way, 1.1 * static_cast<double>(points.size()));
}

TEST(HilbertOrder, TakesPointsAtOnePlaceInTheirOrder) {
  const std::vector<Point> points(5, Point{2, 3});
  EXPECT_EQ(hilbert_order(points), (std::vector<std::uint32_t>{0, 1, 2, 3, 4}));
  EXPECT_TRUE(hilbert_order({}).empty());
}

TEST(HilbertOrder, DoesNotDependOnThePlaceOrAPowerOfTwo) {
  std::vector<Point> points = grid(20), other = points;
  for (Point& p : other) p = 0x1p-20 * (p + Point{1024, -512});
  EXPECT_EQ(hilbert_order(points), hilbert_order(other));
}

TEST(InsertionOrder, DoublesFromRoundToRound) {
  const std::vector<Point> points = grid(64);
  const auto order = insertion_order(points);
  expect_each_once(order, points.size());
  // Each half of the order is spread over the whole plane: the first 1/16 of it comes near every point.
  double farthest = 0;
  for (const Point p : points) {
    double nearest = 1e9;
    for (std::size_t i = 0; i < order.size() / 16; ++i) nearest = std::min(nearest, distance(p, points[order[i]]));
    farthest = std::max(farthest, nearest);
  }
  EXPECT_LT(farthest, 16);
}

}  // namespace
}  // namespace quadline
