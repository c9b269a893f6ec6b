#include "geom/predicates.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/unit/geom/point_inputs.hpp"

namespace quadline {
namespace {

TEST(Predicates, AgreeWithThemselvesWhenPointsChangePlaces) {
  test::Random r(11);
  for (const test::PointInput& input : test::point_inputs()) {
    for (int i = 0; i < 2000; ++i) {
      const Point a = input.point(r), b = input.point(r), c = input.point(r), d = input.point(r);
      EXPECT_EQ(orientation(a, b, c), orientation(b, c, a)) << input.name;
      EXPECT_EQ(orientation(a, b, c), -orientation(b, a, c)) << input.name;
      EXPECT_EQ(in_circle(a, b, c, d), in_circle(b, c, a, d)) << input.name;
      EXPECT_EQ(in_circle(a, b, c, d), -in_circle(b, a, c, d)) << input.name;
      EXPECT_EQ(in_circle(a, b, c, d), -in_circle(a, b, d, c)) << input.name;
    }
  }
}

TEST(Predicates, SeeTheLastBit) {
  const Point a{0, 0}, b{3, 1};
  EXPECT_EQ(orientation(a, b, {6, 2}), 0);
  EXPECT_EQ(orientation(a, b, {6, std::nextafter(2.0, 3)}), 1);
  EXPECT_EQ(orientation(a, b, {6, std::nextafter(2.0, 1)}), -1);
  EXPECT_EQ(in_circle({1, 0}, {0, 1}, {-1, 0}, {0, -1}), 0);
  EXPECT_EQ(in_circle({1, 0}, {0, 1}, {-1, 0}, {0, std::nextafter(-1.0, 0)}), 1);
  EXPECT_EQ(in_circle({1, 0}, {0, 1}, {-1, 0}, {0, std::nextafter(-1.0, -2)}), -1);
}

}  // namespace
}  // namespace quadline
