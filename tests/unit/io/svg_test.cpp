#include "io/svg/svg.hpp"

#include <gtest/gtest.h>

namespace quadline {
namespace {

Mesh one_quad(Point corner) {
  Mesh mesh;
  mesh.points = {{0, 0}, {1, 0}, corner, {0, 1}};
  mesh.quads = {{0, 1, 2, 3}};
  mesh.quad_region = {0};
  mesh.regions = {"domain"};
  return mesh;
}

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t n = 0;
  for (std::size_t at = text.find(part); at != text.npos; at = text.find(part, at + 1)) ++n;
  return n;
}

TEST(Svg, ASquareIsOnePathOfTheBestColour) {
  const std::string svg = to_svg(one_quad({1, 1}));
  EXPECT_NE(svg.find("<path class=\"quads\" fill=\"#66bd63\" d=\"M0 10000l10000 0 0-10000-10000 0z\"/>"),
            std::string::npos)
      << svg;
  EXPECT_NE(svg.find("1 quads, 4 nodes; scaled Jacobian least 1, mean 1; beta mean 1<"), std::string::npos);
}

TEST(Svg, AnInvertedQuadIsBlackAndNamed) {
  const std::string svg = to_svg(one_quad({0.1, 0.1}));
  EXPECT_NE(svg.find("class=\"quads\" fill=\"#000000\""), std::string::npos);
  EXPECT_NE(svg.find("; 1 inverted<"), std::string::npos);
}

TEST(Svg, TrianglesCurvesAndPointsAreDrawn) {
  Mesh mesh = one_quad({1, 1});
  mesh.quads.clear();
  mesh.quad_region.clear();
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  mesh.triangle_region = {0, 0};
  mesh.curves = {{"outer-1", CurveKind::Outer, {{0, 1}, {1, 2}, {2, 3}, {3, 0}}},
                 {"line", CurveKind::Line, {{0, 2}}},
                 {"nowhere", CurveKind::Line, {}}};
  mesh.node_sets = {{"P", {1}}};
  const std::string svg = to_svg(mesh);
  EXPECT_EQ(count(svg, "class=\"triangles\""), 1u);
  EXPECT_EQ(count(svg, "class=\"boundary\""), 1u);
  EXPECT_EQ(count(svg, "class=\"lines\""), 1u);
  EXPECT_EQ(count(svg, "class=\"point\""), 1u);
  EXPECT_NE(svg.find("d=\"M0 10000l10000-10000\""), std::string::npos);
  EXPECT_NE(svg.find("2 triangles"), std::string::npos);
}

TEST(Svg, EveryQuadIsDrawnAndTheFileIsLight) {
  Mesh mesh;
  constexpr NodeIndex kSide = 100;
  for (NodeIndex j = 0; j <= kSide; ++j)
    for (NodeIndex i = 0; i <= kSide; ++i) mesh.points.push_back({1e7 + 0.3 * i, -1e7 + 0.3 * j});
  for (NodeIndex j = 0; j < kSide; ++j) {
    for (NodeIndex i = 0; i < kSide; ++i) {
      const NodeIndex node = j * (kSide + 1) + i;
      mesh.quads.push_back({node, node + 1, node + kSide + 2, node + kSide + 1});
    }
  }
  const std::string svg = to_svg(mesh);
  EXPECT_EQ(count(svg, "zM") + count(svg, "z\"/>"), kSide * kSide);
  EXPECT_LT(svg.size(), 40 * mesh.quads.size());
}

TEST(Svg, AnEmptyMeshIsAPictureToo) {
  const std::string svg = to_svg({});
  EXPECT_EQ(svg.find("nan"), std::string::npos);
  EXPECT_EQ(svg.find("inf"), std::string::npos);
  EXPECT_NE(svg.find("0 quads"), std::string::npos);
}

}  // namespace
}  // namespace quadline
