#include "domain/corners.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "domain/arrange/arrange.hpp"

namespace quadline {
namespace {

std::vector<CellCorner> corners(const Model& model) {
  Context context;
  return corners_of(arrange(model, {.size = 1}, context));
}

double sine(double degrees) { return std::sin(degrees * std::numbers::pi / 180); }

TEST(Corners, RightAnglesAndLinesThatEndAskForNothing) {
  Model model;
  model.outer = {{.items = {{{0, 0}}, {{6, 0}}, {{6, 6}}, {{3, 6}}, {{3, 3}}, {{0, 3}}}}};
  model.lines = {{.name = "a", .path = {.items = {{{0, 1}}, {{2, 1}}}}}};
  EXPECT_TRUE(corners(model).empty());
  EXPECT_EQ(jacobian_bound(corners(model)), 1);
}

TEST(Corners, ATriangleOf30And60And90) {
  Model model;
  model.outer = {{.items = {{{0, 0}}, {{4 * std::sqrt(3.0), 0}}, {{0, 4}}}}};
  const auto found = corners(model);
  ASSERT_EQ(found.size(), 2u);
  for (const CellCorner& corner : found) {
    const double angle = corner.at == Point{0, 4} ? 60 : 30;
    EXPECT_NEAR(corner.angle_deg, angle, 1e-9);
    EXPECT_EQ(corner.quads, 1u);
    EXPECT_NEAR(corner.sj_bound, sine(angle), 1e-12);
  }
  EXPECT_NEAR(jacobian_bound(found), 0.5, 1e-12);
}

TEST(Corners, SeveralQuadsShareAWideOneAndALineCutsIt) {
  Model model;  // a rhombus of 140 degrees at the origin
  const double x = std::cos(70 * std::numbers::pi / 180), y = sine(70);
  model.outer = {{.items = {{{0, 0}}, {{8 * x, -8 * y}}, {{16 * x, 0}}, {{8 * x, 8 * y}}}}};
  const auto at_origin = [](const std::vector<CellCorner>& all) {
    std::vector<CellCorner> out;
    for (const CellCorner& c : all)
      if (c.at == Point{0, 0}) out.push_back(c);
    return out;
  };
  const auto whole = at_origin(corners(model));
  ASSERT_EQ(whole.size(), 1u);
  EXPECT_EQ(whole[0].quads, 2u);
  EXPECT_NEAR(whole[0].best_angle_deg, 70, 1e-9);
  const double turn = 40 * std::numbers::pi / 180;  // the line leaves 30 degrees below the upper side
  model.lines = {{.name = "a", .path = {.items = {{{0, 0}}, {{std::cos(turn), std::sin(turn)}}}}}};
  const auto cut = at_origin(corners(model));
  ASSERT_EQ(cut.size(), 2u);  // 30 and 110
  EXPECT_NEAR(std::min(cut[0].angle_deg, cut[1].angle_deg), 30, 1e-9);
  EXPECT_NEAR(std::max(cut[0].angle_deg, cut[1].angle_deg), 110, 1e-9);
}

TEST(Corners, TangentArcsMeetInACuspOnOneSideOnly) {
  Model model;  // half a disc whose flat side bulges in as a smaller arc, tangent to the first at (2, 0)
  model.outer = {{.items = {{{-2, 0}}, {{2, 0}, Point{0, 2}}, {{0, 0}, Point{1, 1}}, {{-2, 0}}}}};
  double least = 360;
  for (const CellCorner& c : corners(model))
    if (c.at == Point{2, 0}) least = c.angle_deg;
  EXPECT_NEAR(least, 0, 1e-6);
}

TEST(WorstQuads, AreJudgedByWhatTheirCornerAllows) {
  Mesh mesh;  // a rhombus of 30 degrees in a corner of 30, and one of 40 in the open
  const double c = std::cos(std::numbers::pi / 6), s = 0.5, d = std::cos(std::numbers::pi / 4.5), t = sine(40);
  mesh.points = {{0, 0}, {1, 0}, {1 + c, s}, {c, s}, {5, 0}, {6, 0}, {6 + d, t}, {5 + d, t}};
  mesh.quads = {{0, 1, 2, 3}, {4, 5, 6, 7}};
  const auto alone = worst_quads(mesh);
  ASSERT_EQ(alone.size(), 2u);
  EXPECT_EQ(alone[0].quad, 0u);
  EXPECT_NEAR(alone[0].value, 0.5, 1e-12);
  std::vector<CellCorner> model{{{0, 0}, {1, 0}, 30, 1, 30, 0.5}, {{1 + c, s}, {-1, 0}, 30, 1, 30, 0.5}};
  for (const Point p : {Point{1, 0}, Point{c, s}}) model.push_back({p, {0, -1}, 360, 1, 150, 0.5});
  const auto judged = worst_quads(mesh, model);
  EXPECT_EQ(judged[0].quad, 1u);
  EXPECT_NEAR(judged[0].value, t, 1e-12);
  EXPECT_NEAR(judged[1].value, 1, 1e-12);
  EXPECT_NEAR(judged[1].scaled_jacobian, 0.5, 1e-12);
}

TEST(WorstQuads, OfManyTheFiveWorstByIndexWhereEqual) {
  Mesh mesh;
  for (int i = 0; i < 8; ++i) {
    const NodeIndex n = static_cast<NodeIndex>(mesh.points.size());
    const double x = 3 * i, lean = i < 2 ? 0.1 : 0.5;
    mesh.points.insert(mesh.points.end(), {{x, 0}, {x + 1, 0}, {x + 1 + lean, 1}, {x + lean, 1}});
    mesh.quads.push_back({n, n + 1, n + 2, n + 3});
  }
  const auto worst = worst_quads(mesh);
  ASSERT_EQ(worst.size(), 5u);
  for (std::size_t i = 0; i < 5; ++i) EXPECT_EQ(worst[i].quad, i + 2);
}

}  // namespace
}  // namespace quadline
