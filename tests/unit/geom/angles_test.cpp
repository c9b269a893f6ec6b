#include "geom/angles.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace quadline {

namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kDegree = kPi / 180;

Angle of_degrees(double d) { return {3 * std::cos(d * kDegree), 3 * std::sin(d * kDegree)}; }

}  // namespace

TEST(Angle, IsByDefaultTheFullTurn) { EXPECT_EQ(radians(Angle{}), 2 * kPi); }

TEST(Angle, IsOrderedFromZeroToTheFullTurn) {
  const Angle rows[] = {of_degrees(0.001), of_degrees(45),      degrees(90),     of_degrees(91),
                        of_degrees(179),   degrees(180),        of_degrees(181), degrees(270),
                        of_degrees(300),   of_degrees(359.999), degrees(360)};
  for (const Angle& a : rows)
    for (const Angle& b : rows) {
      EXPECT_EQ(a < b, &a != &b && radians(a) < radians(b)) << radians(a) << ' ' << radians(b);
      EXPECT_EQ(a <= b, radians(a) <= radians(b));
      EXPECT_EQ(a > b, b < a);
      EXPECT_EQ(a >= b, b <= a);
    }
}

TEST(Angle, OfNoLengthIsTheFullTurn) {
  EXPECT_EQ(radians({0, 0}), 2 * kPi);
  EXPECT_GT((Angle{0, 0}), degrees(165));
}

TEST(Angle, OfDegreesIsExactAtQuarterTurnsAndToTheLastBitsElsewhere) {
  EXPECT_EQ(radians(degrees(90)), kPi / 2);
  EXPECT_EQ(radians(degrees(180)), kPi);
  EXPECT_EQ(radians(degrees(360)), 2 * kPi);
  constexpr Angle rows[] = {degrees(1),   degrees(30),  degrees(45),  degrees(60),  degrees(117), degrees(125),
                            degrees(165), degrees(218), degrees(226), degrees(310), degrees(330), degrees(359)};
  const int n[] = {1, 30, 45, 60, 117, 125, 165, 218, 226, 310, 330, 359};
  for (int i = 0; i < 12; ++i) {
    EXPECT_NEAR(rows[i].cosine, std::cos(n[i] * kDegree), 1e-15) << n[i];
    EXPECT_NEAR(rows[i].sine, std::sin(n[i] * kDegree), 1e-15) << n[i];
  }
}

TEST(AngleAt, TurnsFromNextToPrevious) {
  EXPECT_EQ(radians(angle_at({0, 1}, {0, 0}, {1, 0})), kPi / 2);
  EXPECT_EQ(radians(angle_at({1, 0}, {0, 0}, {0, 1})), 1.5 * kPi);
  EXPECT_EQ(radians(angle_at({-1, 0}, {0, 0}, {1, 0})), kPi);
  EXPECT_EQ(radians(angle_at({1, 0}, {0, 0}, {1, 0})), 2 * kPi);  // there and back
}

TEST(Turned, TurnsCounterClockwise) {
  const Point p = turned({2, 0}, kPi / 6);
  EXPECT_NEAR(p.x, std::sqrt(3.0), 1e-15);
  EXPECT_NEAR(p.y, 1, 1e-15);
  EXPECT_EQ(turned({2, 3}, 0), (Point{2, 3}));
}

TEST(QuadsForAngle, SwitchesAt125And218And310Degrees) {
  const struct {
    double degrees;
    int quads;
  } rows[] = {{1, 1},   {90, 1},  {124, 1}, {124.999999, 1}, {125.000001, 2}, {126, 2},        {180, 2},
              {217, 2}, {219, 3}, {270, 3}, {309, 3},        {309.999999, 3}, {310.000001, 4}, {311, 4}};
  for (const auto& row : rows) EXPECT_EQ(quads_for_angle(of_degrees(row.degrees)), row.quads) << row.degrees;
  EXPECT_EQ(quads_for_angle(degrees(125)), 2);
  EXPECT_EQ(quads_for_angle(degrees(360)), 4);
}

TEST(QuadsForAngle, SwitchesWhereItIsTold) {
  constexpr QuadSwitches kSwitches{degrees(100), degrees(190), degrees(280)};
  for (const int n : {99, 101, 189, 191, 279, 281})
    EXPECT_EQ(quads_for_angle(of_degrees(n), kSwitches), 1 + (n > 100) + (n > 190) + (n > 280)) << n;
}

}  // namespace quadline
