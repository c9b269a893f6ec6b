#include "search/box_tree.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace quadline {
namespace {

constexpr double kNone = std::numeric_limits<double>::infinity();

// Boxes of all sizes in a square of 100: points and long thin ones too.
std::vector<Box> random_boxes(std::size_t n, std::uint32_t seed) {
  std::mt19937 random(seed);
  const auto uniform = [&](double most) { return most * static_cast<double>(random()) / 4294967296.0; };
  std::vector<Box> boxes;
  for (std::size_t i = 0; i < n; ++i) {
    const Point lo{uniform(100), uniform(100)};
    boxes.push_back(
        {lo, {lo.x + (i % 5 == 0 ? 0 : uniform(i % 7 == 0 ? 40 : 3)), lo.y + (i % 3 == 0 ? 0 : uniform(3))}});
  }
  return boxes;
}

std::vector<std::size_t> hits(const BoxTree& tree, const Box& query) {
  std::vector<std::size_t> found;
  tree.query(query, [&](std::uint32_t i) { found.push_back(i); });
  std::sort(found.begin(), found.end());
  return found;
}

// Sizes round the powers of the fan of eight.
TEST(BoxTree, FindsWhatALookAtEachFinds) {
  for (const std::size_t n : {1u, 2u, 7u, 8u, 9u, 63u, 64u, 65u, 500u, 513u}) {
    const std::vector<Box> boxes = random_boxes(n, static_cast<std::uint32_t>(n));
    const BoxTree tree(boxes);
    EXPECT_EQ(tree.count(), n);
    for (const Box& query : random_boxes(60, 77)) {
      std::vector<std::size_t> expected;
      for (std::size_t i = 0; i < n; ++i)
        if (overlap(boxes[i], query)) expected.push_back(i);
      EXPECT_EQ(hits(tree, query), expected);
    }
  }
}

TEST(BoxTree, BoxesThatTouchOverlap) {
  const BoxTree tree({{{0, 0}, {1, 1}}, {{2, 0}, {3, 1}}, {{5, 5}, {5, 5}}});
  EXPECT_EQ(hits(tree, {{1, 1}, {1.5, 2}}), (std::vector<std::size_t>{0}));
  EXPECT_EQ(hits(tree, {{1, 0.5}, {2, 0.5}}), (std::vector<std::size_t>{0, 1}));
  EXPECT_EQ(hits(tree, {{5, 5}, {5, 5}}), (std::vector<std::size_t>{2}));
  EXPECT_TRUE(hits(tree, {{1.1, 0}, {1.9, 1}}).empty());
}

TEST(BoxTree, AnEmptyOneHasNoHits) {
  const BoxTree tree(std::vector<Box>{});
  EXPECT_EQ(tree.count(), 0u);
  EXPECT_TRUE(hits(tree, {{-1e9, -1e9}, {1e9, 1e9}}).empty());
  tree.ray({0, 0}, {1, 1}, [](std::uint32_t) -> double {
    ADD_FAILURE();
    return 0;
  });
}

// The first hit is that with the nearest circle round the middle of its box, of all that are there.
TEST(BoxTree, ARayFindsItsFirstHit) {
  std::vector<Point> centers;
  std::vector<Box> boxes;
  for (const Box& b : random_boxes(300, 5)) {
    centers.push_back(b.lo);
    boxes.push_back(inflated({b.lo, b.lo}, 1));
  }
  const BoxTree tree(boxes);
  const auto hit = [&](std::size_t i, Point start, Point way) {  // of the ray and a circle of radius 1
    const Point to = centers[i] - start;
    const double along = dot(to, way) / norm2(way), off = norm2(to) - along * along * norm2(way);
    const double at = along - std::sqrt(std::max(0.0, 1 - off) / norm2(way));
    return off > 1 || at < 0 ? kNone : at;
  };
  std::size_t n_hits = 0;
  for (const Box& b : random_boxes(100, 6)) {
    const Point start = b.lo, way = b.hi - Point{50, 50.1};
    double expected = kNone, found = kNone;
    for (std::size_t i = 0; i < centers.size(); ++i) expected = std::min(expected, hit(i, start, way));
    std::size_t n_asked = 0;
    tree.ray(start, way, [&](std::uint32_t i) {
      ++n_asked;
      found = std::min(found, hit(i, start, way));
      return hit(i, start, way);
    });
    EXPECT_EQ(found, expected);
    EXPECT_LT(n_asked, 40u);  // not all of them
    n_hits += expected < kNone;
  }
  EXPECT_GT(n_hits, 50u);
}

}  // namespace
}  // namespace quadline
