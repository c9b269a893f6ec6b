#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "domain/arrange/arrange.hpp"
#include "quadline/errors.hpp"

namespace quadline {
namespace {

constexpr double kSize = 0.5;
constexpr double kDiagonal = 10;

/// A plate of 8 by 6 with a hole and one line.
Model plate_with(Point from, Point to) {
  Model model;
  model.size = kSize;
  model.outer.push_back({{{{0, 0}, {}}, {{8, 0}, {}}, {{8, 6}, {}}, {{0, 6}, {}}}, {}, ""});
  model.holes.push_back({{}, Circle{{6, 3}, 1}, ""});
  model.lines.push_back({"stiffener", {{{from, {}}, {to, {}}}, {}, "/lines/0/path"}, {}});
  return model;
}

Domain arranged(const Model& model, const Options& options = {}) {
  Context context;
  return arrange(model, options, context);
}

const Finding* finding(const Domain& domain, const std::string& text) {
  const auto found = std::find_if(domain.findings.begin(), domain.findings.end(),
                                  [&](const Finding& f) { return f.text.find(text) != std::string::npos; });
  return found == domain.findings.end() ? nullptr : &*found;
}

TEST(NearMiss, EndsWithinTheToleranceAreJoinedAndTold) {
  const double gap = 0.4e-7 * kDiagonal;
  for (const Point end : {Point{3, 6 - gap}, Point{3, 6 + gap}, Point{5 - gap, 3}, Point{8 - gap, 6}}) {
    const Domain domain = arranged(plate_with({2, 2}, end));
    ASSERT_NE(finding(domain, "apart"), nullptr) << end.x << ' ' << end.y;
    EXPECT_LT(distance(finding(domain, "apart")->at, end), 2 * gap);
    EXPECT_EQ(domain.cells.count(), 1u);
    EXPECT_EQ(finding(domain, "outside"), nullptr);
  }
}

TEST(NearMiss, RoundingIsNotTold) {
  const double rounding = 1e-9 * kDiagonal;
  EXPECT_TRUE(arranged(plate_with({0, 2}, {5 - rounding, 3})).findings.empty());
  EXPECT_TRUE(arranged(plate_with({2, 2}, {3, 6 - rounding})).findings.empty());
}

TEST(NearMiss, EndsBeyondTheToleranceAreKeptAndTold) {
  for (const double gap : {1e-4 * kSize, 1e-3 * kSize, 0.01 * kSize, 0.09 * kSize}) {
    const Domain domain = arranged(plate_with({2, 2}, {3, 6 - gap}));
    const Finding* warning = finding(domain, "'stiffener' ends ");
    ASSERT_NE(warning, nullptr) << gap;
    EXPECT_NE(warning->text.find("from 'outer-1'"), std::string::npos) << warning->text;
    EXPECT_FALSE(warning->is_loss);
    EXPECT_EQ(warning->at, (Point{3, 6 - gap}));
    EXPECT_EQ(domain.vertices.count(), 4u + 2u + 2u);  // the corners, the circle's two, the line's ends
  }
  EXPECT_TRUE(arranged(plate_with({2, 2}, {3, 6 - 0.11 * kSize})).findings.empty());
}

TEST(NearMiss, PointsNearACurveAreTold) {
  Model model = plate_with({1, 1}, {4, 1});
  model.points.push_back({"gauge", {2, 1.01}, {}, "/points/0"});
  const Domain domain = arranged(model);
  ASSERT_NE(finding(domain, "a point lies 0.01 from 'stiffener'"), nullptr);
}

std::size_t n_beside(const Domain& domain) {
  return static_cast<std::size_t>(std::count_if(domain.findings.begin(), domain.findings.end(), [](const Finding& f) {
    return f.text.find("comes within") != std::string::npos;
  }));
}

TEST(Beside, LinesFromEdgeToEdgeAreToldOnce) {
  Model model = plate_with({0, 5}, {8, 5});
  for (const double x : {1.0, 3.0, 5.0})  // cut the lines into pieces
    model.lines.push_back({"", {{{{x, 4.5}, {}}, {{x, 5.5}, {}}}, {}, ""}, {}});
  model.lines.push_back({"flange", {{{{0, 5.001}, {}}, {{8, 5.001}, {}}}, {}, "/lines/4/path"}, {}});
  const Domain domain = arranged(model);
  const Finding* told = finding(domain, "'stiffener' comes within 0.001 of 'flange'");
  ASSERT_NE(told, nullptr);
  EXPECT_NEAR(told->at.y, 5.0005, 1e-9);
  EXPECT_EQ(n_beside(domain), 1u);
}

TEST(Beside, AHoleNearALineOrAHoleIsToldAtTheLeastGap) {
  Model model = plate_with({0, 1.98}, {8, 1.98});
  model.holes.push_back({{}, Circle{{3.99, 3}, 1}, ""});
  const Domain domain = arranged(model);
  const Finding* line = finding(domain, "'hole-1' comes within 0.02 of 'stiffener'");
  ASSERT_NE(line, nullptr);
  EXPECT_LT(distance(line->at, {6, 1.99}), 1e-9);
  const Finding* hole = finding(domain, "'hole-1' comes within 0.01 of 'hole-2'");
  ASSERT_NE(hole, nullptr);
  EXPECT_LT(distance(hole->at, {4.995, 3}), 1e-9);
  EXPECT_EQ(n_beside(domain), 3u);  // and 'hole-2' with the line
}

TEST(Beside, ALoopNearItselfIsTold) {
  Model model;
  model.size = kSize;
  model.outer.push_back({{{{0, 0}, {}}, {{8, 0}, {}}, {{8, 0.04}, {}}, {{0, 0.04}, {}}}, {}, "strip"});
  EXPECT_NE(finding(arranged(model), "comes within 0.04 of itself"), nullptr);
}

TEST(Beside, WedgesAndWideGapsAreNotTold) {
  EXPECT_EQ(n_beside(arranged(plate_with({0, 0}, {8, 0.1}))), 0u);        // leaves a corner at 0.7 degrees
  EXPECT_EQ(n_beside(arranged(plate_with({0, 0.051}, {8, 0.051}))), 0u);  // a tenth of the size, and more
  EXPECT_EQ(n_beside(arranged(plate_with({0, 0.049}, {8, 0.049}))), 1u);
}

TEST(Beside, AFineSizeTakesTheGap) {
  Model model = plate_with({0, 0.04}, {8, 0.04});
  EXPECT_EQ(n_beside(arranged(model)), 1u);
  model.lines[0].size = 0.1;
  EXPECT_EQ(n_beside(arranged(model)), 0u);
}

TEST(NearMiss, TheToleranceAskedForJoins) {
  const Model model = plate_with({2, 2}, {3, 6 - 0.04});
  Options options;
  EXPECT_NE(finding(arranged(model, options), "'stiffener' ends 0.04"), nullptr);
  options.tolerance = 0.1;
  const Domain domain = arranged(model, options);
  EXPECT_EQ(domain.tolerance, 0.1);
  EXPECT_NE(finding(domain, "a point and a curve are joined, 0.04 apart"), nullptr);
  EXPECT_EQ(finding(domain, "ends"), nullptr);
}

TEST(NearMiss, TheToleranceFollowsTheLeastSize) {
  Model model = plate_with({2, 2}, {3, 3});
  EXPECT_DOUBLE_EQ(arranged(model).tolerance, 8e-7 * kDiagonal);
  model.lines[0].size = 1e-5 * kDiagonal;
  EXPECT_DOUBLE_EQ(arranged(model).tolerance, 1e-8 * kDiagonal);
}

TEST(NearMiss, TolerancesThatCannotBeAreRefused) {
  const Model model = plate_with({2, 2}, {3, 3});
  for (const double bad : {0.0, -1.0, std::nan(""), HUGE_VAL, 0.26 * kSize}) {
    Options options;
    options.tolerance = bad;
    try {
      arranged(model, options);
      ADD_FAILURE() << bad << " is taken";
    } catch (const InputError& error) {
      const char* why = bad == 0.26 * kSize ? "more than a quarter of the least size" : "not a positive number";
      EXPECT_NE(std::string(error.what()).find(why), std::string::npos) << error.what();
    }
  }
}

}  // namespace
}  // namespace quadline
