#include "base/csr.hpp"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

namespace quadline {
namespace {

using Items = std::vector<std::pair<std::size_t, int>>;

auto each_of(const Items& items) {
  return [&items](const auto& visit) {
    for (const auto& [row, item] : items) visit(row, item);
  };
}

std::vector<int> row_of(const Rows<int>& rows, std::size_t row) { return {rows[row].begin(), rows[row].end()}; }

TEST(Rows, HoldTheItemsInTheOrderOfTheirVisits) {
  const Items items{{2, 5}, {0, 7}, {2, 3}, {0, 9}, {2, 4}};
  const Rows<int> rows(4, each_of(items));
  EXPECT_EQ(rows.count(), 4u);
  EXPECT_EQ(row_of(rows, 0), (std::vector<int>{7, 9}));
  EXPECT_TRUE(rows[1].empty());
  EXPECT_EQ(row_of(rows, 2), (std::vector<int>{5, 3, 4}));
  EXPECT_TRUE(rows[3].empty());
  EXPECT_EQ((std::vector<int>{rows.items().begin(), rows.items().end()}), (std::vector<int>{7, 9, 5, 3, 4}));
}

TEST(Rows, AreMadeAnewByFill) {
  const Items first{{0, 1}, {1, 2}, {2, 3}}, second{{1, 8}};
  Rows<int> rows(3, each_of(first));
  rows.fill(2, each_of(second));
  EXPECT_EQ(rows.count(), 2u);
  EXPECT_TRUE(rows[0].empty());
  EXPECT_EQ(row_of(rows, 1), (std::vector<int>{8}));
}

TEST(Rows, MayBeNone) {
  EXPECT_EQ(Rows<int>().count(), 0u);
  EXPECT_EQ(Rows<int>(0, each_of({})).count(), 0u);
}

}  // namespace
}  // namespace quadline
