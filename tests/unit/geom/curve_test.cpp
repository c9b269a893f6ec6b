#include "geom/curve.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace quadline {
namespace {

constexpr double kPi = std::numbers::pi;

/// Quarter of the unit circle, from east to north.
CurvePiece quarter() { return arc_through({1, 0}, {std::sqrt(0.5), std::sqrt(0.5)}, {0, 1}); }

TEST(ArcThrough, TurnsTheWayOfItsMiddlePoint) {
  const CurvePiece left = arc_through({1, 0}, {0, 1}, {-1, 0});
  EXPECT_NEAR(left.sweep, kPi, 1e-15);
  EXPECT_NEAR(left.radius, 1, 1e-15);
  EXPECT_NEAR(norm(left.center), 0, 1e-15);
  const CurvePiece right = arc_through({1, 0}, {0, -1}, {-1, 0});
  EXPECT_NEAR(right.sweep, -kPi, 1e-15);
}

TEST(ArcThrough, TakesTheLongWayRoundWhereTheMiddlePointDoes) {
  const CurvePiece arc = arc_through({1, 0}, {-1, 0}, {0, 1});
  EXPECT_NEAR(arc.sweep, -1.5 * kPi, 1e-14);
  EXPECT_NEAR(length(arc), 1.5 * kPi, 1e-14);
}

TEST(ArcThrough, IsStraightThroughCollinearPoints) {
  const CurvePiece piece = arc_through({0, 0}, {1, 1}, {3, 3});
  EXPECT_FALSE(piece.is_arc());
  EXPECT_DOUBLE_EQ(length(piece), std::sqrt(18.0));
}

TEST(ArcThrough, KeepsItsDigitsFarFromTheOrigin) {
  const Point far{1e7, -2e7};
  const CurvePiece arc = arc_through(far + Point{4, 0}, far + Point{0, 4}, far + Point{-4, 0});
  EXPECT_NEAR(arc.radius, 4, 1e-8);
  EXPECT_NEAR(distance(arc.center, far), 0, 1e-8);
}

TEST(PointAt, IsExactAtTheEndsAndOnTheCircleBetween) {
  const CurvePiece arc = quarter();
  EXPECT_EQ(point_at(arc, 0), arc.a);
  EXPECT_EQ(point_at(arc, length(arc)), arc.b);
  for (int i = 1; i < 10; ++i) {
    EXPECT_NEAR(distance(point_at(arc, 0.1 * i * length(arc)), arc.center), arc.radius, 1e-15);
  }
  const Point third = point_at(arc, kPi / 6);
  EXPECT_NEAR(third.x, std::cos(kPi / 6), 1e-15);
  EXPECT_NEAR(third.y, std::sin(kPi / 6), 1e-15);
}

TEST(PointAt, GoesOverEvenlyBetweenEndsOffTheCircle) {
  CurvePiece arc = quarter();
  arc.b = {0, 1.01};
  EXPECT_NEAR(distance(point_at(arc, 0.5 * length(arc)), arc.center), 1.005, 1e-15);
  EXPECT_EQ(point_at(arc, length(arc)), arc.b);
}

TEST(TangentAt, PointsForwards) {
  const CurvePiece arc = quarter();
  EXPECT_NEAR(distance(tangent_at(arc, 0), {0, 1}), 0, 1e-15);
  EXPECT_NEAR(distance(tangent_at(arc, length(arc)), {-1, 0}), 0, 1e-15);
  const CurvePiece back = reversed(arc);
  EXPECT_NEAR(distance(tangent_at(back, 0), {1, 0}), 0, 1e-15);
  EXPECT_EQ(tangent_at({.a = {0, 0}, .b = {0, 5}}, 2), (Point{0, 1}));
}

TEST(Project, FindsTheNearestPoint) {
  const CurvePiece arc = quarter();
  EXPECT_NEAR(project(arc, {3, 3}), kPi / 4, 1e-15);
  EXPECT_EQ(project(arc, {2, -1}), 0);
  EXPECT_EQ(project(arc, {-1, 2}), length(arc));
  EXPECT_EQ(project({.a = {0, 0}, .b = {10, 0}}, {3, 7}), 3);
  EXPECT_EQ(project({.a = {0, 0}, .b = {10, 0}}, {-3, 7}), 0);
}

TEST(Project, TurnsBackPointAtOnALongArc) {
  const CurvePiece arc = arc_through({1, 0}, {-1, 0}, {0, -1});
  for (int i = 1; i < 20; ++i) {
    const double s = 0.05 * i * length(arc);
    EXPECT_NEAR(project(arc, point_at(arc, s)), s, 1e-14);
  }
}

TEST(BoxOfPiece, HoldsTheBulgeOfAnArc) {
  const Box b = box(arc_through({1, 0}, {0, 1}, {-1, 0}));
  EXPECT_NEAR(b.hi.y, 1, 1e-15);
  EXPECT_NEAR(b.lo.y, 0, 1e-15);
  EXPECT_NEAR(b.lo.x, -1, 1e-15);
  const Box flat = box(quarter());
  EXPECT_NEAR(flat.lo.x, 0, 1e-15);
  EXPECT_NEAR(flat.hi.x, 1, 1e-15);
}

TEST(SubPiece, LiesOnTheWholeAndSharesGivenEnds) {
  const CurvePiece arc = arc_through({1, 0}, {-1, 0}, {0, -1});
  const double s0 = 0.2 * length(arc), s1 = 0.9 * length(arc);
  const CurvePiece part = sub_piece(arc, s0, s1, point_at(arc, s0), point_at(arc, s1));
  EXPECT_NEAR(length(part), s1 - s0, 1e-14);
  EXPECT_NEAR(distance(point_at(part, 0.5 * length(part)), point_at(arc, 0.5 * (s0 + s1))), 0, 1e-14);
  EXPECT_EQ(part.a, point_at(arc, s0));
}

TEST(SubPiece, IsStraightWhereItsEndsTurnItRound) {
  const CurvePiece arc = quarter();
  const Point p = point_at(arc, 0.5), q = point_at(arc, 0.5 + 1e-9);
  EXPECT_FALSE(sub_piece(arc, 0.5, 0.5 + 1e-9, q, p).is_arc());
}

TEST(Reversed, IsTheSameCurveFromTheOtherEnd) {
  const CurvePiece arc = quarter();
  const CurvePiece back = reversed(arc);
  EXPECT_EQ(back.sweep, -arc.sweep);
  EXPECT_NEAR(distance(point_at(back, 0.3), point_at(arc, length(arc) - 0.3)), 0, 1e-15);
}

TEST(Curve, ScalesExactlyByPowersOfTwo) {
  const CurvePiece arc = arc_through({0.3, 0.1}, {0.9, 0.7}, {1.7, 0.2});
  const double f = 0x1p-40;
  const CurvePiece small = arc_through({f * 0.3, f * 0.1}, {f * 0.9, f * 0.7}, {f * 1.7, f * 0.2});
  EXPECT_EQ(small.radius, f * arc.radius);
  EXPECT_EQ(small.sweep, arc.sweep);
  EXPECT_EQ(point_at(small, f * 0.4), f * point_at(arc, 0.4));
}

}  // namespace
}  // namespace quadline
