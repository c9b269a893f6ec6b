#include "stages/grid/grid_stops.hpp"

#include <gtest/gtest.h>

#include <initializer_list>

namespace quadline {
namespace {

constexpr double kTogether = 0.3;

GridStop side(double at) { return {.at = at, .k = 0, .low = 0, .high = 10}; }
GridStop hole(double at, int k, double low = 4, double high = 6) {
  return {.at = at, .k = k, .low = low, .high = high};
}

std::vector<double> placed(std::vector<GridStop> stops, double density = 1) {
  place_stops(stops, density, kTogether);
  std::vector<double> indices;
  for (const GridStop& stop : stops) indices.push_back(stop.index);
  return indices;
}
using Indices = std::vector<double>;

TEST(PlaceStops, GivesAGapTheSquaresOfItsDensity) {
  EXPECT_EQ(placed({side(2), side(12)}), (Indices{0, 10}));
  EXPECT_EQ(placed({side(2), side(12)}, 1.5), (Indices{0, 15}));
  EXPECT_EQ(placed({side(0), side(0.4)}), (Indices{0, 1}));  // one at least
}

TEST(PlaceStops, SortsThem) { EXPECT_EQ(placed({side(10), side(0), side(4)}), (Indices{0, 4, 10})); }

TEST(PlaceStops, EqualGapsGetTheSame) {
  EXPECT_EQ(placed({side(0), side(3.4), side(6.8), side(10.2), side(13.6)}), (Indices{0, 3, 6, 9, 12}));
  const double off = 1e-12;  // rounding makes no difference
  EXPECT_EQ(placed({side(0), side(3.5 - off), side(7 + off), side(10.5 - off)}), (Indices{0, 4, 8, 12}));
}

TEST(PlaceStops, TiesGoUp) {
  EXPECT_EQ(placed({side(0), side(5.5), side(11)}), (Indices{0, 6, 12}));
  EXPECT_EQ(placed({side(0), side(5.5 - 1e-12)}), (Indices{0, 6}));
  EXPECT_EQ(placed({side(0), side(5.4)}), (Indices{0, 5}));
}

TEST(PlaceStops, AnOddPatchHasItsMiddleInASquare) {
  EXPECT_EQ(placed({side(0), hole(5, 4), side(10)}), (Indices{0, 5, 10}));
  EXPECT_EQ(placed({side(0), hole(5, 3), side(10)}), (Indices{0, 5.5, 11}));
  EXPECT_EQ(placed({side(0), hole(4.6, 3), side(9.2)}), (Indices{0, 4.5, 9}));
  EXPECT_EQ(placed({side(0), hole(5, 5), hole(11, 5), side(16)}), (Indices{0, 5.5, 11.5, 17}));  // half to half
  EXPECT_EQ(placed({side(0), hole(5, 4), hole(11, 5), side(16)}), (Indices{0, 5, 11.5, 16}));
}

TEST(PlaceStops, LeavesRoomForPatchesThatFaceEachOther) {
  EXPECT_EQ(placed({side(0), hole(5, 4), hole(7, 4), side(12)}), (Indices{0, 5, 9, 14}));
  EXPECT_EQ(placed({side(0), hole(5, 4, 1, 3), hole(7, 4, 5, 7), side(12)}), (Indices{0, 5, 7, 12}));  // side by side
  EXPECT_EQ(placed({side(0), hole(5, 3), hole(7, 4), side(12)}), (Indices{0, 5.5, 9, 14}));
}

TEST(PlaceStops, LeavesRoomBesideASide) {
  EXPECT_EQ(placed({side(0), hole(1.2, 6), side(12)})[1], 3);
  GridStop short_side = side(0);
  short_side.high = 3;  // not opposite to the hole
  EXPECT_EQ(placed({short_side, hole(1.2, 6), side(12)})[1], 1);
}

TEST(PlaceStops, TheNextGapsGiveBackWhatRoundingTook) {
  EXPECT_EQ(placed({side(0), side(3.4)}), (Indices{0, 3}));
  // Two gaps of 5.4 go down to 5; then 3.4 goes up to 4.
  EXPECT_EQ(placed({side(0), side(5.4), side(10.8), side(14.2)}), (Indices{0, 5, 10, 14}));
  // Two of 5.6 go up to 6; then 3.6 goes down to 3.
  EXPECT_EQ(placed({side(0), side(5.6), side(11.2), side(14.8)}), (Indices{0, 6, 12, 15}));
}

TEST(PlaceStops, WhatIsCorrectedStaysWithinASquare) {
  // Five gaps of 9.4 lose two squares; the gap of 3 does not take them all.
  EXPECT_EQ(placed({side(0), side(9.4), side(18.8), side(28.2), side(37.6), side(47), side(50)}),
            (Indices{0, 9, 18, 27, 36, 45, 48}));
}

TEST(PlaceStops, StopsThatAreNearGetOnePlace) {
  EXPECT_EQ(placed({side(0), side(4.9), side(5.1), side(10)}), (Indices{0, 5, 5, 10}));
  EXPECT_EQ(placed({side(0), side(4.8), side(5.2), side(10)}), (Indices{0, 5, 6, 11}));
  EXPECT_EQ(placed({side(0), hole(4.9, 2, 1, 3), hole(5.1, 3, 5, 7), side(10)}), (Indices{0, 5.5, 5.5, 11}));
}

TEST(IndexAt, IsLinearBetweenStopsAndConstantBeyond) {
  std::vector<GridStop> stops{side(0), side(4), side(10)};
  place_stops(stops, 2, kTogether);
  EXPECT_DOUBLE_EQ(index_at(stops, 1), 2);
  EXPECT_DOUBLE_EQ(index_at(stops, 4), 8);
  EXPECT_DOUBLE_EQ(index_at(stops, 7), 14);
  EXPECT_DOUBLE_EQ(index_at(stops, -3), 0);
  EXPECT_DOUBLE_EQ(index_at(stops, 30), 20);
}

}  // namespace
}  // namespace quadline
