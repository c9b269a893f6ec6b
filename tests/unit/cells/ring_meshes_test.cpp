// Whole meshes whose models ask for rings and for edges on circles: these are held exactly, or it is told.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "quadline/generate.hpp"
#include "quadline/inspect.hpp"
#include "tests/unit/cells/grid_cells.hpp"

namespace quadline {
namespace {

constexpr double kNear = 1e-9;

MeshResult made(const Model& model, Method method = Method::Layout) {
  Options options;
  options.method = method;
  Context context;
  MeshResult result = generate(model, options, context);
  EXPECT_FALSE(result.failure);
  return result;
}

/// The directions of the nodes on a circle, in parts of a turn from 0 to 1, sorted.
std::vector<double> rays(const Mesh& mesh, Point center, double radius) {
  std::vector<double> found;
  for (const Point p : mesh.points) {
    if (std::abs(distance(p, center) - radius) > kNear) continue;
    const double turn = std::atan2(p.y - center.y, p.x - center.x) / (2 * std::numbers::pi) + kNear;
    found.push_back(turn < 0 ? turn + 1 : turn);
  }
  std::sort(found.begin(), found.end());
  return found;
}

void expect_held(const Mesh& mesh, const Circle& circle, std::size_t edges) {
  const std::vector<double> on_circle = rays(mesh, circle.center, circle.radius);
  EXPECT_EQ(on_circle.size(), edges);
  for (std::uint32_t ring = 1; ring <= *circle.rings; ++ring) {
    const std::vector<double> on_ring = rays(mesh, circle.center, circle.radius + ring * *circle.ring_width);
    ASSERT_EQ(on_ring.size(), on_circle.size());
    for (std::size_t n = 0; n < on_ring.size(); ++n) EXPECT_NEAR(on_ring[n], on_circle[n], kNear);
  }
}

Circle ringed(Point center, double radius, std::uint32_t edges, std::uint32_t rings, double width) {
  return {center, radius, edges, rings, width};
}

TEST(RingMeshes, HoldWhatIsAskedByEveryMethod) {
  const Circle left = ringed({3, 6}, 0.8, 16, 2, 0.5), right = ringed({9, 6}, 1, 24, 1, 0.9);
  for (const Method method : {Method::Layout, Method::QMorph, Method::Merge, Method::Split}) {
    const MeshResult result = made(shapes::square_plate({left, right}), method);
    EXPECT_TRUE(result.report.findings.empty());
    expect_held(result.mesh, left, 16);
    expect_held(result.mesh, right, 24);
  }
}

TEST(RingMeshes, HoldNumbersThatNoGridHas) {
  const Circle circle = ringed({6, 6}, 1.5, 22, 3, 0.4);
  for (const Method method : {Method::Layout, Method::QMorph}) {
    const MeshResult result = made(shapes::square_plate({circle}), method);
    EXPECT_TRUE(result.report.findings.empty());
    expect_held(result.mesh, circle, 22);
  }
}

TEST(RingMeshes, HoldEdgesWithoutRings) {
  for (const std::uint32_t edges : {6u, 12u, 22u, 40u, 96u}) {
    const Circle circle{.center = {6, 6}, .radius = 1.5, .edges = edges};
    const MeshResult result = made(shapes::square_plate({circle}));
    EXPECT_TRUE(result.report.findings.empty());
    EXPECT_EQ(rays(result.mesh, circle.center, circle.radius).size(), edges);
  }
}

TEST(RingMeshes, AreAsSymmetricAsTheirModel) {
  for (const std::uint32_t edges : {16u, 20u}) {
    std::vector<Circle> holes;
    for (const double x : {3.0, 9.0})
      for (const double y : {3.0, 9.0}) holes.push_back(ringed({x, y}, 0.7, edges, 2, 0.3));
    const Mesh mesh = made(shapes::square_plate(holes)).mesh;
    const auto is_node = [&](Point p) {
      return std::any_of(mesh.points.begin(), mesh.points.end(), [&](Point q) { return distance(p, q) < 1e-6; });
    };
    for (const Point p : mesh.points)
      EXPECT_TRUE(is_node({12 - p.x, p.y}) && is_node({p.x, 12 - p.y}) && is_node({p.y, p.x}));
  }
}

TEST(RingMeshes, HaveTheirRaysAtPointsOnTheCircle) {
  const Circle circle = ringed({6, 6}, 1.5, 20, 2, 0.5);
  Model model = shapes::square_plate({circle});
  for (const double turn : {0.6, 2.0})
    model.points.push_back({.at = circle.center + circle.radius * Point{std::cos(turn), std::sin(turn)}});
  expect_held(made(model).mesh, circle, 20);
}

TEST(RingMeshes, KeepTheirWidthUnderCriteria) {
  const Circle circle = ringed({6, 6}, 1.5, 24, 2, 0.5);
  Options options;
  options.criteria = Criteria{.max_aspect = 1.2};
  Context context;
  expect_held(generate(shapes::square_plate({circle}), options, context).mesh, circle, 24);
}

TEST(RingMeshes, NameNothingThatTheModelDoesNot) {
  const MeshResult plain = made(shapes::square_plate({{{6, 6}, 1.5}})),
                   ringed_result = made(shapes::square_plate({ringed({6, 6}, 1.5, 24, 2, 0.5)}));
  EXPECT_EQ(ringed_result.mesh.curves.size(), plain.mesh.curves.size());
  EXPECT_EQ(ringed_result.mesh.regions, plain.mesh.regions);
  EXPECT_EQ(ringed_result.report.n_cells, plain.report.n_cells);
  EXPECT_EQ(ringed_result.report.n_curves, plain.report.n_curves);
  EXPECT_EQ(ringed_result.report.n_vertices, plain.report.n_vertices);
}

// Rings are a wish, as sizes are: a mesh without them fits the model.
TEST(RingMeshes, AreNotAskedOfMeshesThatAreChecked) {
  Context context;
  const MeshResult plain = made(shapes::square_plate({{{6, 6}, 1}}));
  const Model model = shapes::square_plate({ringed({6, 6}, 1, 24, 2, 0.5)});
  EXPECT_FALSE(verify(plain.mesh, model, {}, context).broken);
  EXPECT_FALSE(verify(made(model).mesh, model, {}, context).broken);
}

TEST(RingMeshes, TellWhatTheyDoNotHold) {
  const MeshResult result = made(shapes::square_plate({ringed({6, 6}, 1.5, 22, 2, 0.5)}), Method::Merge);
  ASSERT_EQ(result.report.findings.size(), 2u);
  EXPECT_NE(result.report.findings[0].text.find("'hole-1' gets no rings"), std::string::npos);
  EXPECT_NE(result.report.findings[1].text.find("'hole-1' has 24 edges in place of 22"), std::string::npos);
  for (const Finding& finding : result.report.findings) EXPECT_NEAR(distance(finding.at, {6, 6}), 1.5, kNear);
}

}  // namespace
}  // namespace quadline
