#include "geom/element.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace quadline {
namespace {

constexpr double kDegree = std::numbers::pi / 180;
constexpr QuadPoints kSquare{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};

QuadPoints parallelogram(double a, double b, double angle_deg) {
  const Point u{a, 0}, v{b * std::cos(angle_deg * kDegree), b * std::sin(angle_deg * kDegree)};
  return {Point{0, 0}, u, u + v, v};
}

QuadPoints rotated_corners(QuadPoints q) {
  std::rotate(q.begin(), q.begin() + 1, q.end());
  return q;
}

TEST(TriangleDistortion, IsOneForTheEquilateralTriangleAndSigned) {
  const Point a{0, 0}, b{2, 0}, c{1, std::numbers::sqrt3};
  EXPECT_NEAR(triangle_distortion(a, b, c), 1, 1e-15);
  EXPECT_NEAR(triangle_distortion(b, a, c), -1, 1e-15);
  EXPECT_NEAR(triangle_distortion({0, 0}, {1, 0}, {0, 1}), std::numbers::sqrt3 / 2, 1e-15);
  EXPECT_EQ(triangle_distortion({0, 0}, {1, 0}, {3, 0}), 0);
  EXPECT_EQ(triangle_distortion({1, 1}, {1, 1}, {1, 1}), 0);
}

TEST(QuadDistortion, IsOneForEveryRectangle) {
  EXPECT_NEAR(quad_distortion(kSquare), 1, 1e-15);
  EXPECT_NEAR(quad_distortion(parallelogram(7, 0.3, 90)), 1, 1e-12);
}

TEST(QuadDistortion, FollowsTheClosedFormOfParallelograms) {
  for (const double angle : {85.0, 80.0, 75.0, 70.0, 60.0, 110.0}) {
    for (const double b : {1.0, 2.5}) {
      const double c = std::abs(std::cos(angle * kDegree)), sum = 1 + b * b;
      const double expected = std::pow((sum - b * c) / (sum + b * c), 2);
      EXPECT_NEAR(quad_distortion(parallelogram(1, b, angle)), expected, 1e-12) << angle << " " << b;
    }
  }
  EXPECT_NEAR(quad_distortion(parallelogram(1, 1, 60)), 0.36, 1e-12);
}

TEST(QuadDistortion, OfSquareTrapezoids) {
  const auto trapezoid = [](double top) {
    return QuadPoints{{{0, 0}, {1, 0}, {0.5 + 0.5 * top, 1}, {0.5 - 0.5 * top, 1}}};
  };
  EXPECT_NEAR(quad_distortion(trapezoid(0.9)), 0.895, 1e-3);
  EXPECT_NEAR(quad_distortion(trapezoid(0.8)), 0.780, 1e-3);
  EXPECT_NEAR(quad_distortion(trapezoid(0.7)), 0.657, 1e-3);
}

TEST(QuadDistortion, DoesNotDependOnTheFirstCornerOrTheHand) {
  QuadPoints q{{{0, 0}, {1.3, 0.1}, {1.1, 0.9}, {-0.2, 1.2}}};
  const double beta = quad_distortion(q);
  EXPECT_GT(beta, 0);
  for (int i = 0; i < 3; ++i) {
    q = rotated_corners(q);
    EXPECT_NEAR(quad_distortion(q), beta, 1e-15);
  }
  QuadPoints mirrored{Point{-q[3].x, q[3].y}, {-q[2].x, q[2].y}, {-q[1].x, q[1].y}, {-q[0].x, q[0].y}};
  EXPECT_NEAR(quad_distortion(mirrored), beta, 1e-15);
}

TEST(QuadDistortion, IsZeroWhereATriangleIsNotPositive) {
  EXPECT_EQ(quad_distortion({{{0, 0}, {1, 0}, {0.2, 0.2}, {0, 1}}}), 0);  // reflex
  EXPECT_EQ(quad_distortion({{{0, 0}, {1, 0}, {2, 0}, {1, 1}}}), 0);      // flat corner
  EXPECT_EQ(quad_distortion({{{0, 0}, {0, 1}, {1, 1}, {1, 0}}}), 0);      // clockwise
  EXPECT_EQ(quad_distortion({{{0, 0}, {1, 1}, {1, 0}, {0, 1}}}), 0);      // crosses itself
}

TEST(ScaledJacobian, IsTheLeastSineWithItsSign) {
  EXPECT_NEAR(scaled_jacobian(kSquare), 1, 1e-15);
  EXPECT_NEAR(scaled_jacobian(parallelogram(1, 3, 30)), 0.5, 1e-12);
  EXPECT_NEAR(scaled_jacobian({{{0, 0}, {0, 1}, {1, 1}, {1, 0}}}), -1, 1e-15);
  EXPECT_EQ(scaled_jacobian({{{0, 0}, {1, 0}, {2, 0}, {1, 1}}}), 0);
  EXPECT_LT(scaled_jacobian({{{0, 0}, {1, 0}, {0.2, 0.2}, {0, 1}}}), 0);
  EXPECT_EQ(scaled_jacobian({{{0, 0}, {0, 0}, {1, 1}, {0, 1}}}), 0);  // two corners in one place
}

TEST(CornerAngle, TurnsFromNextToPrevious) {
  EXPECT_NEAR(corner_angle({0, 1}, {0, 0}, {1, 0}), 90 * kDegree, 1e-15);
  EXPECT_NEAR(corner_angle({1, 0}, {0, 0}, {0, 1}), 270 * kDegree, 1e-15);
  EXPECT_NEAR(corner_angle({-1, 0}, {0, 0}, {1, 0}), 180 * kDegree, 1e-15);
  EXPECT_NEAR(corner_angle({-1, -1}, {0, 0}, {1, 0}), 225 * kDegree, 1e-12);
  EXPECT_EQ(corner_angle({1, 0}, {0, 0}, {1, 0}), 2 * std::numbers::pi);  // there and back
}

TEST(InverseMeanRatio, IsOneForTheSquareAndInfiniteWhereNotConvex) {
  EXPECT_NEAR(inverse_mean_ratio(kSquare), 1, 1e-15);
  EXPECT_NEAR(inverse_mean_ratio(parallelogram(1, 1, 30)), 2, 1e-12);
  EXPECT_NEAR(inverse_mean_ratio(parallelogram(1, 4, 90)), 17.0 / 8, 1e-12);
  EXPECT_EQ(inverse_mean_ratio({{{0, 0}, {1, 0}, {0.2, 0.2}, {0, 1}}}), std::numeric_limits<double>::infinity());
}

}  // namespace
}  // namespace quadline
