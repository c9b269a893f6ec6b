// Rings that circles of the model ask for: circles round them, where there is room.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "domain/arrange/arrange.hpp"
#include "quadline/errors.hpp"

namespace quadline {
namespace {

Path ringed(Point center, double radius, std::uint32_t rings, double width) {
  return {.circle = Circle{.center = center, .radius = radius, .rings = rings, .ring_width = width},
          .where = "/holes/0"};
}

// A plate of 20 x 12, size 1.
Model plate(std::vector<Path> holes) {
  Model model;
  model.size = 1;
  model.outer.push_back({.items = {{{0, 0}}, {{20, 0}}, {{20, 12}}, {{0, 12}}}});
  model.holes = std::move(holes);
  return model;
}

Domain arranged(const Model& model) {
  Context context;
  return arrange(model, {}, context);
}

double radius_of(const Domain& domain, const std::vector<DirectedCurve>& circle) {
  return domain.curves[circle[0].curve].piece.radius;
}

std::size_t ring_count(const Domain& domain) {
  std::size_t n = 0;
  for (const Domain::Cell& cell : domain.cells) n += cell.is_ring;
  return n;
}

std::string error_of(const Model& model) {
  try {
    arranged(model);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(Rings, AreCirclesAndCellsOfNoPath) {
  const Domain domain = arranged(plate({ringed({10, 6}, 2, 2, 0.5)}));
  ASSERT_EQ(domain.washers.size(), 1u);
  const Domain::Washer& washer = domain.washers[0];
  ASSERT_EQ(washer.circles.size(), 3u);
  EXPECT_EQ(radius_of(domain, washer.circles[0]), 2);
  EXPECT_EQ(radius_of(domain, washer.circles[1]), 2.5);
  EXPECT_EQ(radius_of(domain, washer.circles[2]), 3);
  EXPECT_EQ(domain.cells.count(), 3u);
  EXPECT_EQ(ring_count(domain), 2u);
  EXPECT_EQ(domain.paths.size(), 2u);
  EXPECT_TRUE(domain.findings.empty());
  for (std::size_t k = 0; k < 3; ++k)
    for (const DirectedCurve& d : washer.circles[k]) EXPECT_EQ(domain.curves[d.curve].is_auxiliary, k > 0);
}

TEST(Rings, HaveTheRegionAndTheSizeAroundThem) {
  Model model = plate({ringed({5, 6}, 1, 1, 0.5)});
  model.lines.push_back({.name = "cut", .path = {.items = {{{10, 0}}, {{10, 12}}}}});
  model.regions.push_back({.name = "left", .at = {5, 7.2}, .size = 0.7});  // in the ring
  const Domain domain = arranged(model);
  std::size_t n = 0;
  for (const Domain::Cell& cell : domain.cells) {
    if (domain.regions[cell.region] != "left") continue;
    ++n;
    EXPECT_EQ(cell.size, 0.7);
  }
  EXPECT_EQ(n, 2u);  // the plate and the ring
}

TEST(Rings, ThoseThatHaveNoRoomAreLeftOutAndTold) {
  const Domain domain = arranged(plate({ringed({3, 6}, 2, 3, 0.4)}));  // 1 to the left edge: 2 x 0.4 and a third
  ASSERT_EQ(domain.washers.size(), 1u);
  EXPECT_EQ(domain.washers[0].circles.size(), 3u);
  ASSERT_EQ(domain.findings.size(), 1u);
  EXPECT_NE(domain.findings[0].text.find("gets 2 of 3 rings: 'outer-1' is in the way"), std::string::npos);
  EXPECT_EQ(domain.findings[0].place, "/holes/0");
  EXPECT_NEAR(domain.findings[0].at.x, 0, 1e-9);
}

TEST(Rings, NeighboursShareTheGap) {
  const Domain domain = arranged(plate({ringed({7, 6}, 2, 3, 0.4), ringed({13, 6}, 2, 3, 0.4)}));  // a gap of 2
  ASSERT_EQ(domain.washers.size(), 2u);
  for (const Domain::Washer& washer : domain.washers) EXPECT_EQ(washer.circles.size(), 3u);
  EXPECT_EQ(domain.findings.size(), 2u);
}

TEST(Rings, WhatEndsOnTheCircleIsInTheWay) {
  Model model = plate({ringed({10, 6}, 2, 2, 0.5)});
  model.lines.push_back({.name = "weld", .path = {.items = {{{12, 6}}, {{20, 6}}}}});
  const Domain domain = arranged(model);
  EXPECT_EQ(ring_count(domain), 0u);
  ASSERT_EQ(domain.findings.size(), 1u);
  EXPECT_NE(domain.findings[0].text.find("gets no rings: 'weld' is in the way"), std::string::npos);
}

TEST(Rings, LieRoundLinesToo) {
  Model model = plate({});
  model.lines.push_back({.name = "pad", .path = ringed({10, 6}, 2, 2, 0.5)});
  const Domain domain = arranged(model);
  EXPECT_EQ(ring_count(domain), 2u);
  EXPECT_EQ(domain.cells.count(), 4u);  // the disk as well
}

TEST(Rings, WidthAndNumberHaveDefaults) {
  Model model = plate({{.circle = Circle{.center = {10, 6}, .radius = 2, .edges = 24, .rings = 1}}});
  const double edge = 2 * std::acos(-1.0) * 2 / 24;
  EXPECT_NEAR(radius_of(arranged(model), arranged(model).washers[0].circles[1]), 2 + edge, 1e-12);
  model.holes[0].circle = Circle{.center = {10, 6}, .radius = 2, .ring_width = 0.5};
  EXPECT_EQ(arranged(model).washers[0].circles.size(), 2u);
}

TEST(Rings, EdgesAloneMakeNoRing) {
  const Domain domain = arranged(plate({{.circle = Circle{.center = {10, 6}, .radius = 2, .edges = 24}}}));
  ASSERT_EQ(domain.washers.size(), 1u);
  EXPECT_EQ(domain.washers[0].edges, 24u);
  EXPECT_EQ(domain.washers[0].circles.size(), 1u);
  EXPECT_EQ(ring_count(domain), 0u);
}

TEST(Rings, BadNumbersAreRefused) {
  const auto with = [](std::optional<std::uint32_t> edges, std::optional<std::uint32_t> rings,
                       std::optional<double> width) {
    return error_of(plate({{.circle = Circle{{10, 6}, 2, edges, rings, width}}}));
  };
  EXPECT_EQ(with(24, 2, 0.5), "");
  for (const std::uint32_t edges : {0u, 2u, 23u, 1'000'002u}) EXPECT_NE(with(edges, 1, 0.5), "") << edges;
  for (const std::uint32_t rings : {0u, 101u}) EXPECT_NE(with(24, rings, 0.5), "") << rings;
  for (const double width : {0.0, -1.0, std::nan(""), std::numeric_limits<double>::infinity(), 1e300})
    EXPECT_NE(with(24, 1, width), "") << width;
  Model outer = plate({});
  outer.outer[0] = ringed({0, 0}, 5, 1, 0.5);
  EXPECT_NE(error_of(outer), "");
}

TEST(Rings, ThinnerThanTheToleranceAreNone) {
  const Domain domain = arranged(plate({ringed({10, 6}, 2, 2, 1e-12)}));
  EXPECT_EQ(ring_count(domain), 0u);
  ASSERT_EQ(domain.findings.size(), 1u);
  EXPECT_NE(domain.findings[0].text.find("hardly wider than the tolerance"), std::string::npos);
}

}  // namespace
}  // namespace quadline
