// The whole stage on small plates.
#include "stages/qmorph/qmorph.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "shapes.hpp"

namespace quadline {
namespace {

class QMorph : public testing::TestWithParam<LineFronts> {
 protected:
  SizeField size_ = shapes::unit_size();
  Context context_;
};

TEST_P(QMorph, FindsTheGrid) {
  WorkMesh mesh = shapes::triangulated_grid(6, 4);
  merge_to_quads(mesh, size_, {.lines = GetParam()}, {}, context_);
  EXPECT_EQ(defect(mesh), "");
  EXPECT_EQ(mesh.topo().face_count(), 24u);
  EXPECT_EQ(mesh.topo().node_count(), 35u);
  EXPECT_EQ(shapes::n_triangles(mesh), 0u);
}

TEST_P(QMorph, FindsTheGridRoundAnOpenLine) {
  WorkMesh mesh = shapes::triangulated_grid(6, 4, {{15, 16}, {16, 17}, {17, 18}});
  merge_to_quads(mesh, size_, {.lines = GetParam()}, {}, context_);
  EXPECT_EQ(defect(mesh), "");
  EXPECT_EQ(mesh.topo().face_count(), 24u);
  EXPECT_EQ(shapes::n_constraints(mesh), 20u + 3);
  std::size_t end = 0;  // nodes are numbered anew
  while (mesh.point(NodeId(end)) != Point{4, 2}) ++end;
  EXPECT_EQ(mesh.topo().edge_valence(NodeId(end)), 4);  // the end of the line is regular
}

TEST_P(QMorph, LineThatTouchesTheBoundary) {
  WorkMesh mesh = shapes::triangulated_grid(6, 4, {{3, 10}, {10, 17}});
  merge_to_quads(mesh, size_, {.lines = GetParam()}, {}, context_);
  EXPECT_EQ(defect(mesh), "");
  EXPECT_EQ(mesh.topo().face_count(), 24u);
}

TEST_P(QMorph, CrossingLines) {
  WorkMesh mesh = shapes::triangulated_grid(6, 4, {{15, 16}, {16, 17}, {17, 18}, {9, 16}, {16, 23}});
  merge_to_quads(mesh, size_, {.lines = GetParam()}, {}, context_);
  EXPECT_EQ(defect(mesh), "");
  EXPECT_EQ(mesh.topo().face_count(), 24u);
  EXPECT_EQ(shapes::n_constraints(mesh), 20u + 5);
}

INSTANTIATE_TEST_SUITE_P(Both, QMorph, testing::Values(LineFronts::OneSided, LineFronts::TwoSided));

TEST(QMorphOneSided, FirstLayerStandsOnTheLeftOfTheLineOnly) {
  WorkMesh mesh = shapes::triangulated_grid(12, 12, {{81, 82}, {82, 83}, {83, 84}, {84, 85}});
  const SizeField size = shapes::unit_size();
  Context context;
  bool seen = false;
  merge_to_quads(
      mesh, size, {.lines = LineFronts::OneSided},
      [&](std::string_view name, const WorkMesh& now) {
        if (name != "first-layer") return;
        seen = true;
        const HalfId h = now.topo().find(NodeId(82), NodeId(83));
        EXPECT_FALSE(now.is_triangle(h));
      },
      context);
  EXPECT_TRUE(seen);
}

TEST(QMorph, FrontThatSpinsIsStopped) {
  WorkMesh mesh = shapes::triangulated_grid(6, 4);
  const SizeField size = shapes::unit_size();
  Context context;
  EXPECT_THROW(merge_to_quads(mesh, size, {.steps_per_triangle = 0}, {}, context), InternalError);
}

TEST(QMorph, StopsWhenAsked) {
  WorkMesh mesh = shapes::triangulated_grid(6, 4);
  const SizeField size = shapes::unit_size();
  Context context;
  context.is_cancelled = [] { return true; };
  EXPECT_THROW(merge_to_quads(mesh, size, {}, {}, context), Cancelled);
}

}  // namespace
}  // namespace quadline
