#include "stages/verify/fit_to_model.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "domain/arrange/arrange.hpp"
#include "stages/verify/verify.hpp"

namespace quadline {
namespace {

/// A square of edge 2 with a line across its middle, from right to left, and a point in it.
Domain square_with_line() {
  Model model;
  model.size = 1;
  model.outer = {{.items = {{{0, 0}, {}}, {{2, 0}, {}}, {{2, 2}, {}}, {{0, 2}, {}}}, .circle = {}, .where = "/outer"}};
  model.lines = {{.name = "girder",
                  .path = {.items = {{{2, 1}, {}}, {{0, 1}, {}}}, .circle = {}, .where = "/lines/0/path"},
                  .size = {}}};
  model.points = {{.name = "load", .at = {1, 1}, .size = {}, .where = "/points/0"}};
  Context context;
  return arrange(model, {}, context);
}

/// Two by two quads, row by row from the lower left, without names, as from a file with rounded numbers.
Mesh four_quads() {
  Mesh mesh;
  for (int y = 0; y < 3; ++y)
    for (int x = 0; x < 3; ++x) mesh.points.push_back({x + 1e-12, y - 1e-12});
  mesh.quads = {{0, 1, 4, 3}, {1, 2, 5, 4}, {3, 4, 7, 6}, {4, 5, 8, 7}};
  mesh.quad_region = {0, 0, 0, 0};
  mesh.regions = {"domain"};
  return mesh;
}

TEST(FitToModel, FindsCurvesAndPointsByTheirPlace) {
  const Domain domain = square_with_line();
  const Mesh fitted = fit_to_model(four_quads(), domain);
  ASSERT_EQ(fitted.curves.size(), 2u);
  EXPECT_EQ(fitted.curves[0].name, "outer-1");
  EXPECT_EQ(fitted.curves[0].kind, CurveKind::Outer);
  EXPECT_EQ(fitted.curves[0].edges.size(), 8u);
  EXPECT_EQ(fitted.curves[1].name, "girder");
  using Edges = std::vector<std::array<NodeIndex, 2>>;
  EXPECT_EQ(fitted.curves[1].edges, (Edges{{5, 4}, {4, 3}}));
  ASSERT_EQ(fitted.node_sets.size(), 1u);
  EXPECT_EQ(fitted.node_sets[0].name, "load");
  EXPECT_EQ(fitted.node_sets[0].nodes, std::vector<NodeIndex>{4});
  EXPECT_EQ(fitted.points[0], (Point{0, 0}));  // moved onto the corner
  Context context;
  EXPECT_FALSE(verify(fitted, domain, context).has_value());
}

TEST(FitToModel, LeavesOutWhatTheMeshDoesNotHave) {
  const Domain domain = square_with_line();
  Mesh mesh = four_quads();
  mesh.points[4].y = 1.2;
  mesh.curves = {{"girder", CurveKind::Line, {{5, 4}, {4, 3}}}};  // what the mesh says does not count
  const Mesh fitted = fit_to_model(mesh, domain);
  EXPECT_TRUE(fitted.curves[1].edges.empty());
  EXPECT_TRUE(fitted.node_sets.empty());
  Context context;
  const std::optional<Failure> failure = verify(fitted, domain, context);
  ASSERT_TRUE(failure);
  EXPECT_EQ(failure->reason, "a vertex of the domain is no node");
}

TEST(FitToModel, LeavesOutEdgesThatTheMeshDoesNotHave) {
  Mesh mesh = four_quads();
  mesh.quads = {mesh.quads[1], mesh.quads[3]};  // nodes 3 and 4 lie on the line, but nothing joins them
  using Edges = std::vector<std::array<NodeIndex, 2>>;
  EXPECT_EQ(fit_to_model(mesh, square_with_line()).curves[1].edges, (Edges{{5, 4}}));
}

TEST(FitToModel, TurnsTheEdgesOfCurvesThatAPathRunsBack) {
  Domain domain = square_with_line();
  std::vector<DirectedCurve>& curves = domain.paths[1].curves;
  std::reverse(curves.begin(), curves.end());
  for (DirectedCurve& d : curves) d.reversed = !d.reversed;
  using Edges = std::vector<std::array<NodeIndex, 2>>;
  EXPECT_EQ(fit_to_model(four_quads(), domain).curves[1].edges, (Edges{{3, 4}, {4, 5}}));
}

// The half disc above a diameter, in two quads: half of its curve runs backwards in the mesh's order of nodes.
TEST(FitToModel, FollowsArcsAndDrawsNothingNearby) {
  Model model;
  model.size = 1;
  model.outer = {{.items = {{{1, 0}, {}}, {{-1, 0}, Point{0, 1}}}, .circle = {}, .where = "/outer"}};
  Context context;
  const Domain domain = arrange(model, {}, context);
  const double h = std::sqrt(0.5);
  Mesh mesh;
  mesh.points = {{-1, 0}, {0, 0}, {1, 0}, {-h, h}, {0, 1}, {h, h}, {0, 1 - 1e-3}};
  mesh.quads = {{0, 1, 4, 3}, {1, 2, 5, 4}};
  mesh.quad_region = {0, 0};
  mesh.regions = {"domain"};
  const Mesh fitted = fit_to_model(mesh, domain);
  ASSERT_EQ(fitted.curves.size(), 1u);
  using Edges = std::vector<std::array<NodeIndex, 2>>;
  Edges edges = fitted.curves[0].edges;
  std::sort(edges.begin(), edges.end());
  EXPECT_EQ(edges, (Edges{{0, 1}, {1, 2}, {2, 5}, {3, 0}, {4, 3}, {5, 4}}));
}

// A line from side to side parts the square into two cells, here of two regions.
TEST(FitToModel, LetsRegionsOnBothSidesOfALineBeCompared) {
  Domain domain = square_with_line();
  ASSERT_EQ(domain.cells.count(), 2u);
  domain.regions = {"lower", "upper"};
  const CellId above = domain.curves[domain.paths[1].curves[0].curve].right;  // it runs from right to left
  domain.cells[above].region = 1;
  Mesh mesh = four_quads();
  mesh.regions = domain.regions;
  mesh.quad_region = {0, 0, 1, 1};
  Context context;
  EXPECT_FALSE(verify(fit_to_model(mesh, domain), domain, context).has_value());
  mesh.quad_region = {0, 1, 1, 1};
  const std::optional<Failure> failure = verify(fit_to_model(mesh, domain), domain, context);
  ASSERT_TRUE(failure);
  EXPECT_EQ(failure->reason, "the quads of region 'lower' do not add up to its area");
}

// The ring between circles of radius 1 and 2 with five nodes on each: no two of them opposite to each other.
TEST(FitToModel, CirclesMayHaveTheirNodesAnywhere) {
  Model model;
  model.size = 1;
  model.outer = {{.circle = Circle{{0, 0}, 2}}};
  model.holes = {{.circle = Circle{{0, 0}, 1}}};
  Context context;
  const Domain arranged = arrange(model, {}, context);
  Mesh mesh;
  mesh.regions = {"domain"};
  constexpr NodeIndex n = 5;
  for (NodeIndex k = 0; k < n; ++k)
    for (const double r : {1.0, 2.0}) {
      const double angle = 0.3 + 2 * std::acos(-1.0) * k / n;
      mesh.points.push_back({r * std::cos(angle), r * std::sin(angle)});
    }
  for (NodeIndex k = 0; k < n; ++k) {
    const NodeIndex next = (k + 1) % n;
    mesh.quads.push_back({2 * k, 2 * k + 1, 2 * next + 1, 2 * next});
    mesh.quad_region.push_back(0);
  }
  EXPECT_TRUE(verify(fit_to_model(mesh, arranged), arranged, context).has_value());
  const Domain turned = with_circles_turned_to(mesh, arranged);
  const Mesh fitted = fit_to_model(mesh, turned);
  for (const EdgeSet& circle : fitted.curves) EXPECT_EQ(circle.edges.size(), n);
  EXPECT_FALSE(verify(fitted, turned, context).has_value());
  mesh.quads.pop_back();  // what is missing is still seen
  mesh.quad_region.pop_back();
  EXPECT_TRUE(verify(fit_to_model(mesh, turned), turned, context).has_value());
}

TEST(FitToModel, ACircleWithoutNodesStaysAsItIs) {
  Model model;
  model.size = 1;
  model.outer = {{.circle = Circle{{0, 0}, 5}}};
  Context context;
  const Domain arranged = arrange(model, {}, context);
  const Domain turned = with_circles_turned_to(four_quads(), arranged);
  for (std::size_t i = 0; i < arranged.curves.count(); ++i)
    EXPECT_EQ(turned.curves[CurveId(i)].piece.a, arranged.curves[CurveId(i)].piece.a);
}

}  // namespace
}  // namespace quadline
