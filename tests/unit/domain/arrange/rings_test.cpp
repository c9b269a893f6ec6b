// Rings that circles ask for are cells of their own, as far as there is room for them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <string>

#include "domain/arrange/arrange.hpp"
#include "quadline/errors.hpp"

namespace quadline {
namespace {

/// A plate of 20 by 12 about (10, 6).
Model plate_with(const std::vector<Circle>& holes) {
  Model model;
  model.size = 1;
  model.outer.push_back({.items = {{{0, 0}}, {{20, 0}}, {{20, 12}}, {{0, 12}}}});
  for (const Circle& hole : holes)
    model.holes.push_back({.circle = hole, .where = "/holes/" + std::to_string(model.holes.size())});
  return model;
}

Circle ringed(Point center, double radius, std::uint32_t rings, double width) {
  return {.center = center, .radius = radius, .rings = rings, .ring_width = width};
}

Domain arranged(const Model& model, const Options& options = {}) {
  Context context;
  return arrange(model, options, context);
}

/// Outer radii of the rings, and how many they are.
std::multiset<std::pair<double, std::uint32_t>> rings_of(const Domain& domain) {
  std::multiset<std::pair<double, std::uint32_t>> found;
  for (const Domain::Cell& cell : domain.cells)
    if (cell.rings > 0) found.insert({domain.curves[cell.walks[0][0].curve].piece.radius, cell.rings});
  return found;
}

void expect_told(const Domain& domain, const std::string& text, const std::string& place, Point at) {
  ASSERT_EQ(domain.findings.size(), 1u);
  EXPECT_NE(domain.findings[0].text.find(text), std::string::npos) << domain.findings[0].text;
  EXPECT_EQ(domain.findings[0].place, place);
  EXPECT_LT(distance(domain.findings[0].at, at), 1e-9);
  EXPECT_TRUE(domain.findings[0].is_loss);
}

TEST(Rings, AreACellBetweenTheHoleAndACircleThatIsOnNoPath) {
  const Domain domain = arranged(plate_with({ringed({10, 6}, 2, 2, 0.75)}));
  EXPECT_TRUE(domain.findings.empty());
  ASSERT_EQ(domain.cells.count(), 2u);
  EXPECT_EQ(rings_of(domain), (std::multiset<std::pair<double, std::uint32_t>>{{3.5, 2}}));
  EXPECT_EQ(domain.paths.size(), 2u);
  for (const Domain::Path& path : domain.paths)
    for (const DirectedCurve& d : path.curves) EXPECT_FALSE(domain.curves[d.curve].is_auxiliary);
  EXPECT_EQ(std::count_if(domain.curves.begin(), domain.curves.end(), [](const auto& c) { return c.is_auxiliary; }), 2);
}

TEST(Rings, BothCirclesGetTheEdgesThatAreGiven) {
  Model model = plate_with({ringed({10, 6}, 2, 2, 0.75)});
  model.holes[0].circle->edges = 22;
  const Domain domain = arranged(model);
  for (const Domain::Curve& curve : domain.curves) EXPECT_EQ(curve.edges, curve.piece.is_arc() ? 11u : 0u);
}

TEST(Rings, EdgesAreSharedAmongArcsByTheirTurns) {
  Model model = plate_with({ringed({10, 6}, 2, 1, 1)});
  model.holes[0].circle->edges = 24;
  for (const double angle : {0.5, 0.5 + std::acos(0.0)})
    model.points.push_back({.at = Point{10, 6} + 2.0 * Point{std::cos(angle), std::sin(angle)}});
  const Domain domain = arranged(model);
  std::multiset<std::pair<double, std::uint32_t>> arcs;
  for (const Domain::Curve& curve : domain.curves)
    if (curve.piece.is_arc()) arcs.insert({curve.piece.radius, curve.edges});
  EXPECT_EQ(arcs, (std::multiset<std::pair<double, std::uint32_t>>{{2, 6}, {2, 18}, {3, 6}, {3, 18}}));
}

TEST(Rings, OnesBesideEachOtherAreCellsEach) {
  const Domain domain = arranged(plate_with({ringed({5, 6}, 1, 3, 0.5), ringed({13, 6}, 2, 1, 1)}));
  EXPECT_TRUE(domain.findings.empty());
  EXPECT_EQ(rings_of(domain), (std::multiset<std::pair<double, std::uint32_t>>{{2.5, 3}, {3, 1}}));
}

TEST(Rings, AThirdOfTheirWidthStaysFree) {
  EXPECT_EQ(rings_of(arranged(plate_with({ringed({5, 6}, 2, 2, 1.28)}))).count({2 + 2 * 1.28, 2}), 1u);
  const Domain domain = arranged(plate_with({ringed({5, 6}, 2, 2, 1.29)}));
  EXPECT_EQ(rings_of(domain).count({2 + 1.29, 1}), 1u);
  expect_told(domain, "'hole-1' gets 1 of 2 rings: 'outer-1' is in the way", "/holes/0", {0, 6});
}

TEST(Rings, WhatIsInTheWayIsTold) {
  Model by_point = plate_with({ringed({10, 6}, 2, 1, 1)});
  by_point.points.push_back({.at = {10, 8.5}});
  expect_told(arranged(by_point), "'hole-1' gets no rings: a point is in the way", "/holes/0", {10, 8.5});
  Model by_line = plate_with({ringed({10, 6}, 2, 1, 1)});
  by_line.lines.push_back({.name = "stiffener", .path = {.items = {{{0, 6}}, {{8, 6}}}}});
  expect_told(arranged(by_line), "'hole-1' gets no rings: 'stiffener' is in the way", "/holes/0", {8, 6});
  const Domain domain = arranged(plate_with({ringed({6, 6}, 2, 2, 1), ringed({12.5, 6}, 2, 2, 1)}));
  ASSERT_EQ(domain.findings.size(), 2u);
  EXPECT_NE(domain.findings[0].text.find("the rings of 'hole-2' are in the way"), std::string::npos);
  EXPECT_EQ(rings_of(domain), (std::multiset<std::pair<double, std::uint32_t>>{{3, 1}, {3, 1}}));
}

TEST(Rings, BelongToTheRegionRoundThem) {
  for (const Point at : {Point{1, 1}, Point{10, 8.5}}) {
    Model model = plate_with({ringed({10, 6}, 2, 1, 1)});
    model.regions.push_back({.name = "panel", .at = at, .size = 0.5});
    const Domain domain = arranged(model);
    EXPECT_TRUE(domain.findings.empty());
    for (const Domain::Cell& cell : domain.cells) {
      EXPECT_EQ(domain.regions[cell.region], "panel");
      EXPECT_EQ(cell.size, 0.5);
    }
  }
}

TEST(Rings, WithoutAWidthAreAsWideAsAnEdge) {
  Model model = plate_with({{.center = {10, 6}, .radius = 2, .edges = 16, .rings = 1}});
  EXPECT_NEAR(rings_of(arranged(model)).begin()->first, 2 + std::acos(-1.0) / 4, 1e-12);
}

TEST(Rings, NonsenseIsRefusedWithItsPlace) {
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
  const Point at{10, 6};
  const Circle wrong[] = {ringed(at, 2, 1, 0),        ringed(at, 2, 1, -1), ringed(at, 2, 1, nan),
                          ringed(at, 2, 1, infinity), ringed(at, 2, 0, 1),  ringed(at, 2, 101, 1),
                          {at, 2, 0u, {}, {}},        {at, 2, 2u, {}, {}},  {at, 2, 23u, {}, {}},
                          {at, 2, 1'000'002u, {}, {}}};
  for (const Circle& circle : wrong) {
    try {
      arranged(plate_with({circle}));
      ADD_FAILURE();
    } catch (const InputError& error) {
      EXPECT_EQ(error.where().place, "/holes/0");
      EXPECT_EQ(error.where().point, at);
    }
  }
  Model round;
  round.size = 1;
  round.outer.push_back({.circle = ringed({0, 0}, 9, 1, 1)});
  EXPECT_THROW(arranged(round), InputError);
}

TEST(Rings, MoreQuadsThanAllowedAreRefused) {
  Circle circle = ringed({10, 6}, 2, 100, 0.01);
  circle.edges = 1'000'000;
  EXPECT_THROW(arranged(plate_with({circle})), InputError);
}

}  // namespace
}  // namespace quadline
