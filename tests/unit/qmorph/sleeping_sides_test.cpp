#include "stages/qmorph/sleeping_sides.hpp"

#include <gtest/gtest.h>

#include "quadline/generate.hpp"
#include "quadline/io/read_model.hpp"
#include "shapes.hpp"

namespace quadline {
namespace {

class SleepingSidesTest : public testing::Test {
 protected:
  HalfId half(std::size_t a, std::size_t b) const { return mesh_.topo().find(NodeId(a), NodeId(b)); }
  // The square above the edge from node v to v + 1 becomes a quad.
  void mesh_left_of(std::size_t v) {
    const HalfId h = half(v, v + 1), diagonal = half(v, v + 8);
    const std::vector<FaceId> two{mesh_.topo().face(h), mesh_.topo().face(diagonal)};
    std::vector<FaceId> made;
    mesh_.replace_cavity(two, std::vector<Polygon>{{NodeId(v), NodeId(v + 1), NodeId(v + 8), NodeId(v + 7)}}, made);
  }
  WorkMesh mesh_ = shapes::triangulated_grid(6, 4, {{15, 16}, {16, 17}});
};

TEST_F(SleepingSidesTest, AreTheRightSidesOfLines) {
  const SleepingSides sides(mesh_);
  EXPECT_TRUE(sides.contains(half(16, 15)));
  EXPECT_TRUE(sides.contains(half(17, 16)));
  EXPECT_FALSE(sides.contains(half(15, 16)));
  EXPECT_FALSE(sides.contains(half(14, 15)));  // no line
  EXPECT_FALSE(sides.contains(half(0, 1)));    // a boundary has one side
  EXPECT_FALSE(sides.contains(half(1, 0)));
}

TEST_F(SleepingSidesTest, WakeWholeWhenTheFirstSideIsMeshed) {
  SleepingSides sides(mesh_);
  EXPECT_TRUE(sides.wake_if_due(half(16, 15)).empty());
  mesh_left_of(15);
  EXPECT_TRUE(sides.wake_if_due(half(16, 15)).empty());  // its own opposite stands, the line's other edge has none
  EXPECT_TRUE(sides.contains(half(16, 15)));
  mesh_left_of(16);
  EXPECT_EQ(sides.wake_if_due(half(17, 16)), (std::vector<HalfId>{half(16, 15), half(17, 16)}));
  EXPECT_FALSE(sides.contains(half(16, 15)));
  EXPECT_TRUE(sides.wake_all().empty());
}

TEST_F(SleepingSidesTest, WakeWhenNothingElseIsLeft) {
  SleepingSides sides(mesh_);
  EXPECT_EQ(sides.wake_all(), (std::vector<HalfId>{half(16, 15), half(17, 16)}));
  EXPECT_FALSE(sides.contains(half(16, 15)));
}

// Quads that have an edge of the line on their left or right, when the first layer stands on the model of Fig. 16(a).
std::array<std::size_t, 3> beside_line_of_fig16(LineFronts lines) {
  const Model model = read_model("models/paper/fig16.json");
  Options options;
  options.lines = lines;
  options.triangles = Triangles::Delaunay;
  std::array<std::size_t, 3> n{};  // edges of the line, quads left of it, quads right of it
  Context context;
  context.on_snapshot = [&](std::string_view name, const Mesh& mesh) {
    if (name != "first-layer") return;
    for (const EdgeSet& curve : mesh.curves) {
      if (curve.kind != CurveKind::Line) continue;
      n[0] += curve.edges.size();
      for (const auto& [a, b] : curve.edges)
        for (const auto& quad : mesh.quads)
          for (std::size_t i = 0; i < 4; ++i) {
            n[1] += quad[i] == a && quad[(i + 1) % 4] == b;
            n[2] += quad[i] == b && quad[(i + 1) % 4] == a;
          }
    }
  };
  EXPECT_FALSE(generate(model, options, context).failure);
  return n;
}

TEST(OneSidedFronts, FirstLayerOfFig16HasQuadsOnOneSideOfTheLineAndTrianglesOnTheOther) {
  const auto [n_edges, n_left, n_right] = beside_line_of_fig16(LineFronts::OneSided);
  EXPECT_GT(n_edges, 10u);
  EXPECT_EQ(n_left, n_edges);
  EXPECT_EQ(n_right, 0u);
}

TEST(OneSidedFronts, FirstLayerOfFig16HasQuadsOnBothSidesWhereFrontsAreTwoSided) {
  const auto [n_edges, n_left, n_right] = beside_line_of_fig16(LineFronts::TwoSided);
  EXPECT_EQ(n_left, n_edges);
  EXPECT_EQ(n_right, n_edges);
}

}  // namespace
}  // namespace quadline
