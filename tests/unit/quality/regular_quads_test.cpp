#include "quality/regular_quads.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace quadline {
namespace {

constexpr double kDegree = std::numbers::pi / 180;

TEST(QuadsOff, IsTheDifferenceToTheNearestRightAngles) {
  EXPECT_EQ(quads_off(90 * kDegree, 1), 0);
  EXPECT_EQ(quads_off(90 * kDegree, 2), 1);
  EXPECT_EQ(quads_off(180 * kDegree, 1), -1);
  EXPECT_EQ(quads_off(270 * kDegree, 3), 0);
  EXPECT_EQ(quads_off(360 * kDegree, 2), -2);
  EXPECT_EQ(quads_off(360 * kDegree, 7), 3);
}

TEST(QuadsOff, ASharpCornerHasOne) {
  EXPECT_EQ(quads_off(5 * kDegree, 1), 0);
  EXPECT_EQ(quads_off(5 * kDegree, 2), 1);
}

TEST(QuadsOff, EitherNumberIsRightWithinTwoDegreesOfATie) {
  for (const double angle : {133.5, 135.0, 136.5}) {
    EXPECT_EQ(quads_off(angle * kDegree, 1), 0) << angle;
    EXPECT_EQ(quads_off(angle * kDegree, 2), 0) << angle;
  }
  EXPECT_EQ(quads_off(132.5 * kDegree, 2), 1);
  EXPECT_EQ(quads_off(137.5 * kDegree, 1), -1);
}

}  // namespace
}  // namespace quadline
