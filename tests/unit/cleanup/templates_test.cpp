#include "stages/cleanup/templates.hpp"

#include <gtest/gtest.h>

#include <map>
#include <set>

namespace quadline::cleanup {
namespace {

const TemplateTable& table() {
  static const TemplateTable t;
  return t;
}

std::vector<TemplateTable::Match> all(int n_rim, std::size_t most = 100000) {
  std::vector<TemplateTable::RimCosts> costs(static_cast<std::size_t>(n_rim), TemplateTable::RimCosts{});
  std::vector<TemplateTable::Match> found;
  table().find(costs, 1000, most, found);
  return found;
}

// Every rim edge once, every inner edge once each way, nothing twice: a disk, by Euler's formula.
void expect_fills_the_disk(const Template& t) {
  std::map<std::pair<int, int>, int> halves;
  std::set<int> nodes;
  for (int i = 0; i < t.n_quads; ++i) {
    for (int k = 0; k < 4; ++k) {
      const int a = t.quads[i][k], b = t.quads[i][(k + 1) % 4];
      EXPECT_EQ(++halves[std::pair(a, b)], 1);
      nodes.insert(a);
    }
  }
  EXPECT_EQ(static_cast<int>(nodes.size()), t.n_rim + t.n_inner);
  EXPECT_EQ(t.n_quads, t.n_inner + t.n_rim / 2 - 1);
  for (const auto& [half, n] : halves) {
    const bool on_rim = half.first < t.n_rim && half.second == (half.first + 1) % t.n_rim;
    EXPECT_EQ(halves.count({half.second, half.first}), on_rim ? 0u : 1u);
  }
  for (int i = 0; i < t.n_rim; ++i) EXPECT_EQ(halves.count({i, (i + 1) % t.n_rim}), 1u);
}

TEST(Templates, FillTheirDisks) {
  for (const int n_rim : {4, 6, 8, 10})
    for (const auto& match : all(n_rim)) expect_fills_the_disk(*match.way);
}

TEST(Templates, OfAHexagonAreThreePairsAndMore) {
  const auto found = all(6);
  int by_inner[5] = {};
  for (const auto& match : found) ++by_inner[match.way->n_inner];
  EXPECT_EQ(by_inner[0], 3);  // the three diagonals
  EXPECT_EQ(by_inner[1], 2);  // three quads round a node
  EXPECT_EQ(by_inner[2], 3);  // four quads in the place of two
}

TEST(Templates, OfAnOctagonWithoutInnerNodesAreTwelve) {
  int n = 0;
  for (const auto& match : all(8)) n += match.way->n_inner == 0;
  EXPECT_EQ(n, 12);
}

TEST(Templates, OfOneQuadAreItselfAndTheRing) {
  const auto found = all(4);
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(found[0].way->n_quads, 1);
  EXPECT_EQ(found[1].way->n_quads, 5);
}

TEST(Templates, AreFoundByWhatTheyDoToTheRim) {
  // The star of a regular node is the cheapest filling where every second rim node wants two quads.
  std::vector<TemplateTable::RimCosts> costs;
  for (int i = 0; i < 8; ++i) {
    TemplateTable::RimCosts c{};
    for (int q = 1; q <= TemplateTable::kMaxRimQuads; ++q) c[q] = (q - (i % 2 + 1)) * (q - (i % 2 + 1));
    costs.push_back(c);
  }
  std::vector<TemplateTable::Match> found;
  table().find(costs, 10, 3, found);
  ASSERT_FALSE(found.empty());
  EXPECT_EQ(found[0].cost, 0);
  EXPECT_EQ(found[0].way->n_inner, 1);
  EXPECT_EQ(found[0].way->n_quads, 4);
  for (std::size_t i = 1; i < found.size(); ++i) EXPECT_GE(found[i].cost, found[i - 1].cost);
  table().find(costs, 0, 3, found);
  EXPECT_TRUE(found.empty());
}

TEST(Templates, EndAtTheGreatestRim) {
  std::vector<TemplateTable::RimCosts> costs(12);
  std::vector<TemplateTable::Match> found;
  table().find(costs, 10, 3, found);
  EXPECT_TRUE(found.empty());
}

}  // namespace
}  // namespace quadline::cleanup
