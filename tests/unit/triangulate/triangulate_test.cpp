#include "stages/triangulate/triangulate.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "quadline/errors.hpp"
#include "tests/unit/triangulate/segments.hpp"

namespace quadline {
namespace {

using test::areas;
using test::Random;
using test::rectangle;
using test::Sketch;

void expect_sound(const WorkMesh& mesh) {
  EXPECT_EQ(defect(mesh), "");
  EXPECT_EQ(test::segments_missing(mesh), 0);
  EXPECT_EQ(test::edges_not_delaunay(mesh), 0);
}

std::vector<Point> circle(Point center, double radius, int n) {
  std::vector<Point> points;
  for (int i = 0; i < n; ++i) {
    const double a = 2 * std::numbers::pi * i / n;
    points.push_back({center.x + radius * std::cos(a), center.y + radius * std::sin(a)});
  }
  return points;
}

TEST(Triangulate, ASquareIsTwoTrianglesInABox) {
  Sketch s;
  s.loop(rectangle(0, 0, 1, 1), 0, -1);
  s.triangulate();
  expect_sound(s.mesh);
  EXPECT_EQ(s.mesh.topo().node_count(), 8u);
  EXPECT_DOUBLE_EQ(areas(s.mesh)[0], 1);
  s.mesh.drop_outside();
  s.mesh.compact();
  EXPECT_EQ(s.mesh.topo().node_count(), 4u);
  EXPECT_EQ(s.mesh.topo().face_count(), 2u);
  expect_sound(s.mesh);
}

TEST(Triangulate, CellsAreOnTheSidesThatTheCurvesSay) {
  Sketch s;
  auto clockwise = rectangle(0, 0, 10, 10);
  std::reverse(clockwise.begin(), clockwise.end());
  s.loop(clockwise, -1, 0);
  s.loop(rectangle(2, 2, 8, 8), -1, 0);         // a hole
  s.loop(rectangle(4, 4, 6, 6), 1, -1);         // an island in it
  s.loop(circle({1, 1}, 0.5, 8), 2, 0);         // a closed line
  s.line({{5, 5}, {5.2, 5.4}, {5.5, 5.5}}, 1);  // an open line in the island
  s.triangulate();
  expect_sound(s.mesh);
  const double disc = 0.5 * 8 * 0.25 * std::sin(std::numbers::pi / 4);
  auto area = areas(s.mesh);
  EXPECT_NEAR(area[0], 100 - 36 - disc, 1e-12);
  EXPECT_NEAR(area[1], 4, 1e-12);
  EXPECT_NEAR(area[2], disc, 1e-12);
  EXPECT_EQ(area.size(), 4u);
}

TEST(Triangulate, ALineCutsItsCellInTwo) {
  Sketch s;
  const NodeId a = s.node({0, 0}), b = s.node({4, 0}), c = s.node({4, 3}), d = s.node({0, 3});
  s.chain({a, b, c}, 0, -1);
  s.chain({a, d, c}, -1, 1);
  s.chain({a, c}, 1, 0);
  s.triangulate();
  expect_sound(s.mesh);
  EXPECT_DOUBLE_EQ(areas(s.mesh)[0], 6);
  EXPECT_DOUBLE_EQ(areas(s.mesh)[1], 6);
}

TEST(Triangulate, ASegmentGoesThroughANodeThatLiesOnIt) {
  Sketch s;
  s.loop(rectangle(0, 0, 8, 8), 0, -1);
  s.node({3, 3});
  s.node({5, 5});
  s.node({5, 4});
  const NodeId a = s.node({1, 1}), b = s.node({7, 7});
  const CurveId c = s.chain({a, b}, 0, 0);
  s.triangulate();
  expect_sound(s.mesh);
  EXPECT_EQ(
      std::count_if(s.mesh.segments().begin(), s.mesh.segments().end(), [&](const Segment& x) { return x.curve == c; }),
      3);
}

TEST(Triangulate, ANodeWithinRoundingOfASegmentStaysBesideIt) {
  Sketch s;
  s.loop(rectangle(0, 0, 3, 3), 0, -1);
  s.node({1.5, std::nextafter(1.5, 2)});
  s.node({1, std::nextafter(1.0, 0)});
  s.line({{0.5, 0.5}, {2.5, 2.5}}, 0);
  s.triangulate();
  expect_sound(s.mesh);
  EXPECT_EQ(s.mesh.segments().size(), 5u);
}

TEST(Triangulate, ALongSegmentCrossesAFanOfSlivers) {
  Sketch s;
  s.loop(rectangle(-1, -20, 101, 20), 0, -1);
  for (int i = 1; i < 100; ++i) s.node({static_cast<double>(i), i % 2 ? 1e-3 * i : -1e-3 * i});
  s.line({{0, 0}, {100, 1e-9}}, 0);
  s.triangulate();
  expect_sound(s.mesh);
  EXPECT_NEAR(areas(s.mesh)[0], 102 * 40, 1e-9);
}

TEST(Triangulate, CrossingSegmentsAreRefusedWithTheirPlace) {
  Sketch s;
  s.loop(rectangle(0, 0, 4, 4), 0, -1);
  s.line({{1, 1}, {3, 3}}, 0);
  s.line({{1, 3}, {3, 1.5}}, 0);
  try {
    s.triangulate();
    FAIL() << "no error";
  } catch (const InternalError& e) {
    ASSERT_TRUE(e.where().point.has_value());
    EXPECT_TRUE(*e.where().point == (Point{1, 1}) || *e.where().point == (Point{3, 3}));
  }
}

TEST(Triangulate, TwoNodesAtOnePlaceAreRefusedWithTheirPlace) {
  Sketch s;
  s.loop(rectangle(0, 0, 4, 4), 0, -1);
  s.node({2, 3});
  s.node({2, 3});
  try {
    s.triangulate();
    FAIL() << "no error";
  } catch (const InternalError& e) {
    ASSERT_TRUE(e.where().point.has_value());
    EXPECT_EQ(*e.where().point, (Point{2, 3}));
  }
}

/// A disk with a hole, a slanted line, and nodes in the field.
Sketch disk(double scale, bool in_other_order = false) {
  Sketch s;
  auto add_field = [&] {
    Random r(5);
    for (int i = 0; i < 200; ++i) s.node(scale * Point{1.5 * r.unit() - 1.6, 3 * r.unit() - 1.5});
  };
  const auto scaled = [&](std::vector<Point> points) {
    for (Point& p : points) p = scale * p;
    return points;
  };
  if (in_other_order) add_field();
  s.loop(scaled(circle({0, 0}, 3, 64)), 0, -1);
  s.loop(scaled(circle({0.5, 0.25}, 0.4, 16)), -1, 0);
  s.line(scaled({{-1.8, 1.9}, {-0.1, 2.3}, {2.0, 1.1}}), 0);
  if (!in_other_order) add_field();
  return s;
}

std::vector<std::array<double, 6>> corner_points(const WorkMesh& mesh, double scale) {
  std::vector<std::array<double, 6>> all;
  for (const auto& t : test::triangles(mesh)) {
    std::array<Point, 3> p;
    for (std::size_t i = 0; i < 3; ++i) p[i] = scale * mesh.point(NodeId(t[i]));
    std::sort(p.begin(), p.end(), [](Point a, Point b) { return a.x != b.x ? a.x < b.x : a.y < b.y; });
    all.push_back({p[0].x, p[0].y, p[1].x, p[1].y, p[2].x, p[2].y});
  }
  std::sort(all.begin(), all.end());
  return all;
}

TEST(Triangulate, ScalesWithPowersOfTwoBitForBit) {
  Sketch s = disk(1), big = disk(0x1p30), small = disk(0x1p-30);
  for (Sketch* each : {&s, &big, &small}) {
    each->triangulate();
    expect_sound(each->mesh);
  }
  EXPECT_EQ(test::triangles(s.mesh), test::triangles(big.mesh));
  EXPECT_EQ(test::triangles(s.mesh), test::triangles(small.mesh));
  EXPECT_EQ(corner_points(s.mesh, 1), corner_points(big.mesh, 0x1p-30));
}

TEST(Triangulate, ManyNodesOnOneCircle) {
  Sketch s;
  s.loop(circle({0, 0}, 1, 5000), 0, -1);
  s.triangulate();
  expect_sound(s.mesh);
}

TEST(Triangulate, AGridIsAllTies) {
  Sketch s;
  constexpr int kSide = 30;
  for (int j = 0; j <= kSide; ++j)
    for (int i = 0; i <= kSide; ++i) s.node({0.1 * i, 0.1 * j});
  const auto id = [](int i, int j) { return NodeId(static_cast<std::size_t>(j * (kSide + 1) + i)); };
  s.chain({id(0, 0), id(kSide, 0), id(kSide, kSide), id(0, kSide), id(0, 0)}, 0, -1);
  s.chain({id(3, 2), id(27, 25)}, 0, 0);
  s.triangulate();
  expect_sound(s.mesh);
  EXPECT_GT(s.mesh.segments().size(), 100u);  // the rim goes through its nodes
  EXPECT_NEAR(areas(s.mesh)[0], 9, 1e-12);
}

}  // namespace
}  // namespace quadline
