#include "domain/size/size_field.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "domain/size/size_sources.hpp"
#include "tests/unit/domain/size/size_shapes.hpp"

namespace quadline {
namespace {

SizeField field_of(const Domain& domain, const Options& options = {}) {
  Context context;
  return make_size_field(domain, options, context);
}

/// Largest slope between neighbours of a fine grid over the box. Bilinear interpolation may pass the limit in a leaf
/// that holds a source, where it is 1.41 times as steep along the diagonal.
double steepest(const SizeField& field, const Box& box, int n = 400) {
  double most = 0;
  const double dx = (box.hi.x - box.lo.x) / n, dy = (box.hi.y - box.lo.y) / n;
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      const Point p{box.lo.x + i * dx, box.lo.y + j * dy};
      const double h = field.at(p), hx = field.at({p.x + dx, p.y}), hy = field.at({p.x, p.y + dy});
      most = std::max(most, std::hypot((hx - h) / dx, (hy - h) / dy));
    }
  return most;
}

TEST(SizeField, IsExactlyTheSizeAndOneLeafWhereOneSizeHolds) {
  const SizeField field = field_of(shapes::rectangle(10, 7, 0.3));
  EXPECT_EQ(field.leaf_count(), 1u);
  for (Point p : {Point{0, 0}, Point{10, 7}, Point{3.3, 1.7}, Point{-5, 20}}) EXPECT_EQ(field.at(p), 0.3);
}

TEST(SizeField, LineSizeHoldsAlongTheLineAndGrowsWithTheGrowth) {
  const Domain domain = shapes::Builder({{0, 0}, {40, 0}, {40, 40}, {0, 40}, {10, 20}, {30, 20}},
                                        {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {4, 5, std::nullopt, 0.25}}, 2)
                            .build();
  Options options;
  options.growth = 1.2;
  const SizeField field = field_of(domain, options);
  for (int i = 0; i <= 50; ++i) EXPECT_NEAR(field.at({10 + 0.4 * i, 20}), 0.25, 0.05 * 0.25);
  EXPECT_EQ(field.at({20, 38}), 2);
  const double slope = std::log(1.2);
  for (double d : {1.0, 2.0, 5.0}) {
    EXPECT_NEAR(field.at({20, 20 + d}), std::min(2.0, 0.25 + slope * d), 0.05) << d;
  }
  EXPECT_LE(steepest(field, domain.box), 1.45 * slope);
}

TEST(SizeField, PointSizeHoldsAcrossTenThousandfoldJump) {
  Domain domain = shapes::rectangle(1000, 1000, 100);
  domain.points.push_back({"load", domain.vertices.push_back({{613.7, 421.9}}), 0.01});
  const SizeField field = field_of(domain);
  EXPECT_NEAR(field.at({613.7, 421.9}), 0.01, 0.0005);
  EXPECT_LT(field.leaf_count(), 2000u);
  for (double d : {0.1, 1.0, 10.0, 100.0}) {
    const double expected = 0.01 + std::log(1.3) * d;
    EXPECT_NEAR(field.at({613.7 + d, 421.9}), expected, 0.2 * expected) << d;
    EXPECT_NEAR(field.at({613.7 - 0.6 * d, 421.9 - 0.8 * d}), expected, 0.2 * expected) << d;
  }
}

TEST(SizeField, RegionSizesHoldInsideTheirCellFinerAndCoarser) {
  // Three cells side by side: fine, plain, coarse.
  Domain domain = shapes::Builder({{0, 0}, {20, 0}, {40, 0}, {80, 0}, {80, 20}, {40, 20}, {20, 20}, {0, 20}},
                                  {{0, 1}, {1, 2}, {2, 3}, {3, 4}, {4, 5}, {5, 6}, {6, 7}, {7, 0}, {1, 6}, {2, 5}}, 2)
                      .build();
  for (auto& cell : domain.cells) {
    double x = 0;
    for (const DirectedCurve& d : cell.walks[0]) x = std::max(x, domain.curves[d.curve].piece.a.x);
    cell.size = x == 20 ? 0.5 : x == 40 ? 2 : 6;
  }
  const SizeField field = field_of(domain);
  for (Point p : {Point{0, 0}, Point{10, 10}, Point{20, 10}, Point{19.9, 0.1}}) EXPECT_DOUBLE_EQ(field.at(p), 0.5);
  EXPECT_DOUBLE_EQ(field.at({35, 10}), 2);
  EXPECT_DOUBLE_EQ(field.at({40, 10}), 2);
  EXPECT_DOUBLE_EQ(field.at({75, 10}), 6);
  EXPECT_NEAR(field.at({50, 10}), 2 + std::log(1.3) * 10, 0.5);
}

TEST(SizeField, CirclesGetFewerEdgesAsTheyGetSmallAgainstTheSize) {
  EXPECT_EQ(circle_edges(3, 1, 16), 16);
  EXPECT_EQ(circle_edges(2, 1, 16), 16);
  EXPECT_EQ(circle_edges(1.5, 1, 16), 12);
  EXPECT_EQ(circle_edges(0.7, 1, 16), 8);
  EXPECT_EQ(circle_edges(0.001, 1, 16), 8);
  EXPECT_EQ(circle_edges(1, 1, 5), 5);
  EXPECT_EQ(circle_edges(0.001, 1, 5), 5);
  EXPECT_EQ(circle_edges(2, 1, 64), 64);
  EXPECT_EQ(circle_edges(1.5, 1, 32), 24);
  EXPECT_EQ(circle_edges(0.001, 1, 64), 32);
}

TEST(SizeField, HoleDrawsTheSizeDownToItsEdges) {
  const Domain domain = shapes::square_with_hole(100, 3.5, 5);
  const SizeField field = field_of(domain);
  const double chord = 7 * std::sin(std::numbers::pi / 8);
  for (int i = 0; i < 16; ++i) {
    const Point p{50 + 3.5 * std::cos(0.4 * i), 50 + 3.5 * std::sin(0.4 * i)};
    EXPECT_GT(field.at(p), 1.3 * chord);
    EXPECT_LT(field.at(p), 1.5 * chord);
  }
  EXPECT_EQ(field.least_edges(CurveId(0)), 1u);
  EXPECT_EQ(field.least_edges(CurveId(4)), 4u);
  EXPECT_EQ(field.at({1, 1}), 5);
  EXPECT_EQ(field_of(shapes::square_with_hole(100, 20, 5)).leaf_count(), 1u);  // 25 edges by the size alone
}

TEST(SizeField, TinyHoleIsNotLost) {
  const double radius = 0.02;
  const Domain domain = shapes::square_with_hole(10, radius, 1);
  const SizeField field = field_of(domain);
  EXPECT_LT(field.at({5 + radius, 5}), 1.5 * radius);
  EXPECT_NEAR(field.at({0.5, 0.5}), 1, 0.01);
  EXPECT_EQ(field.least_edges(CurveId(4)), 4u);
  EXPECT_LE(steepest(field, domain.box), 1.45 * std::log(1.3));
}

TEST(SizeField, GapBetweenLinesDrawsTheSizeDownToALimit) {
  const auto lines_apart = [](double gap) {
    return shapes::Builder({{0, 0}, {30, 0}, {30, 20}, {0, 20}, {8, 10}, {22, 10}, {8, 10 + gap}, {22, 10 + gap}},
                           {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {4, 5}, {6, 7}}, 1)
        .build();
  };
  EXPECT_EQ(field_of(lines_apart(0.5)).leaf_count(), 1u);
  EXPECT_NEAR(field_of(lines_apart(0.47)).at({15, 10}), 0.94, 0.03);
  for (const double y : {10.0, 10.3}) EXPECT_NEAR(field_of(lines_apart(0.3)).at({15, y}), 0.6, 0.03) << y;
  for (const double y : {10.0, 10.05}) EXPECT_NEAR(field_of(lines_apart(0.05)).at({15, y}), 0.4, 0.01) << y;
  EXPECT_EQ(field_of(lines_apart(0.05)).at({15, 19}), 1);
}

TEST(SizeField, GapOutsideTheDomainAndSharpCornersAreNoGaps) {
  // Two teeth 0.3 apart; the gap is outside.
  const Domain teeth = shapes::Builder({{0, 0}, {10, 0}, {10, 8}, {5.15, 8}, {5.15, 4}, {4.85, 4}, {4.85, 8}, {0, 8}},
                                       {{0, 1}, {1, 2}, {2, 3}, {3, 4}, {4, 5}, {5, 6}, {6, 7}, {7, 0}}, 1)
                           .build();
  EXPECT_EQ(field_of(teeth).at({4.85, 7}), 1);
  const Domain wedge = shapes::Builder({{0, 0}, {20, 0}, {20, 2}}, {{0, 1}, {1, 2}, {2, 0}}, 1).build();
  EXPECT_EQ(field_of(wedge).leaf_count(), 1u);
}

// Of two lines that run side by side only one looks as far as the other: a finer one needs not to. From either side.
TEST(Gaps, BothSidesAskForTheirSize) {
  const Domain domain = shapes::Builder({{0, 0}, {30, 0}, {30, 20}, {0, 20}, {8, 10}, {22, 10}, {8, 10.3}, {22, 10.3}},
                                        {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {4, 5}, {6, 7}}, 1)
                            .build();
  for (const std::size_t blind : {4u, 5u}) {
    IdVector<CurveId, double> sizes(domain.curves.count(), 1);
    sizes[CurveId(blind)] = 0.1;
    std::vector<SizeSource> sources;
    append_gaps(domain, sizes, sources);
    for (const double y : {10.0, 10.3}) {
      double covered = 0;  // by segments of the side that looks
      int n_points = 0;    // on the other, without the ends of the lines, which look for themselves
      for (const SizeSource& s : sources) {
        EXPECT_NEAR(s.size, 0.6, 1e-9);
        if (s.a.y != y) continue;
        covered += s.b.x - s.a.x;
        n_points += s.a == s.b && s.a.x > 8 && s.a.x < 22;
      }
      const bool looks = (y == 10) != (blind == 4);
      EXPECT_NEAR(covered, looks ? 14 : 0, 1e-9) << y;
      EXPECT_EQ(n_points, looks ? 0 : 28) << y;
    }
  }
}

// Both sides of a sharp corner in three pieces: the second and the third share no vertex with those across.
TEST(Gaps, AWedgeOfManyPiecesIsNone) {
  const double t = 0.26;
  const Domain wedge =
      shapes::Builder({{0, 0}, {0.9, 0}, {1.6, 0}, {20, 0}, {20, 20 * t}, {1.6, 1.6 * t}, {0.9, 0.9 * t}},
                      {{0, 1}, {1, 2}, {2, 3}, {3, 4}, {4, 5}, {5, 6}, {6, 0}}, 1)
          .build();
  EXPECT_EQ(field_of(wedge).leaf_count(), 1u);
}

TEST(SizeField, ShortCurvesDrawTheSizeDownAndNicksDoNot) {
  const auto chamfer = [](double cut) {
    return shapes::Builder({{0, 0}, {10, 0}, {10, 5}, {10 - cut, 5 + cut}, {0, 5 + cut}},
                           {{0, 1}, {1, 2}, {2, 3}, {3, 4}, {4, 0}}, 1)
        .build();
  };
  EXPECT_EQ(field_of(chamfer(0.4)).leaf_count(), 1u);
  const SizeField field = field_of(chamfer(0.25));
  EXPECT_NEAR(field.at({9.875, 5.125}), 2 * std::sqrt(2) * 0.25, 0.03);
  EXPECT_EQ(field.at({1, 1}), 1);
  EXPECT_NEAR(field_of(chamfer(0.001)).at({9.9995, 5.0005}), 0.3, 0.02);
}

TEST(SizeField, ChainOfShortCurvesIsResolved) {
  // A hole as a polygon of twenty edges of 0.05.
  std::vector<Point> points{{0, 0}, {10, 0}, {10, 10}, {0, 10}};
  std::vector<shapes::Link> links{{0, 1}, {1, 2}, {2, 3}, {3, 0}};
  const double radius = 0.025 / std::sin(std::numbers::pi / 20);
  for (std::size_t i = 0; i < 20; ++i) {
    const double angle = 0.1 * std::numbers::pi * static_cast<double>(i);
    points.push_back({5 + radius * std::cos(angle), 5 + radius * std::sin(angle)});
    links.push_back({4 + i, 4 + (i + 1) % 20});
  }
  const SizeField field = field_of(shapes::Builder(points, links, 1).build({{5, 5}}));
  EXPECT_NEAR(field.at({5 + radius, 5}), 0.1, 0.01);
}

TEST(SizeField, PointsCloseTogetherDrawTheSizeDown) {
  Domain domain = shapes::rectangle(10, 10, 1);
  for (Point p : {Point{4, 5}, Point{4.3, 5}, Point{9.75, 2}})
    domain.cells[CellId(0)].lone_points.push_back(domain.vertices.push_back({p}));
  const SizeField field = field_of(domain);
  EXPECT_NEAR(field.at({4, 5}), 0.6, 0.05);
  EXPECT_NEAR(field.at({4.3, 5}), 0.6, 0.05);
  EXPECT_NEAR(field.at({10, 2}), 0.5, 0.03);
  EXPECT_EQ(field.at({1, 9}), 1);
}

TEST(SizeField, LineEndBeforeAnEdgeDrawsTheSizeDownOnBoth) {
  const SizeField field = field_of(shapes::Builder({{0, 0}, {10, 0}, {10, 10}, {0, 10}, {5, 0.3}, {5, 6}},
                                                   {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {4, 5}}, 1)
                                       .build());
  EXPECT_NEAR(field.at({5, 0.3}), 0.6, 0.04);
  EXPECT_NEAR(field.at({5, 0}), 0.6, 0.04);
  EXPECT_EQ(field.at({5, 5}), 1);
}

TEST(SizeField, ScalingByAPowerOfTwoScalesEveryBit) {
  Domain domain = shapes::square_with_hole(10, 0.13, 1);
  domain.curves[CurveId(1)].size = 0.37;
  const SizeField field = field_of(domain);
  std::mt19937 random(1);
  std::uniform_real_distribution<double> coordinate(0, 10);
  for (int k : {-30, -3, 1, 20}) {
    const double factor = std::ldexp(1.0, k);
    const SizeField other = field_of(shapes::scaled(domain, factor));
    EXPECT_EQ(other.leaf_count(), field.leaf_count());
    for (int i = 0; i < 200; ++i) {
      const Point p{coordinate(random), coordinate(random)};
      ASSERT_EQ(other.at(factor * p), factor * field.at(p));
    }
  }
}

}  // namespace
}  // namespace quadline
