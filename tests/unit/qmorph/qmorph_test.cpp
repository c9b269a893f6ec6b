// The whole stage on small plates.
#include "stages/qmorph/qmorph.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "quadline/generate.hpp"
#include "quadline/io/read_model.hpp"
#include "shapes.hpp"

namespace quadline {
namespace {

// Completion pairs the triangles of any grid by itself, and so do meshes that look good say little: the counts tell who
// made the quads.
void expect_made_by_the_front(const MorphCounts& counts, const WorkMesh& mesh) {
  std::size_t n_formed = 0;
  for (const auto& row : counts.quads)
    for (const std::size_t n : row) n_formed += n;
  EXPECT_EQ(counts.completion_triangles, 0u);
  EXPECT_EQ(counts.completion_quads, 0u);
  EXPECT_GT(n_formed, mesh.topo().face_count() / 2);
  EXPECT_EQ(n_formed + counts.closures_of_4 + 2 * counts.closures_of_6_by_2 + 3 * counts.closures_of_6_by_3 +
                counts.transition_splits,
            mesh.topo().face_count());
  EXPECT_EQ(counts.side_neighbour + counts.side_chosen + counts.side_swapped + counts.side_split_parity +
                counts.side_split_length + counts.side_split_direction,
            2 * n_formed);
  EXPECT_EQ(counts.top_found + counts.top_swapped, n_formed);
}

class QMorph : public testing::TestWithParam<LineFronts> {
 protected:
  MorphCounts merge(WorkMesh& mesh) {
    const MorphCounts counts = merge_to_quads(mesh, size_, {.lines = GetParam()}, {}, context_);
    EXPECT_EQ(defect(mesh), "");
    EXPECT_EQ(shapes::n_triangles(mesh), 0u);
    return counts;
  }
  SizeField size_ = shapes::unit_size();
  Context context_;
};

TEST_P(QMorph, FindsTheGrid) {
  WorkMesh mesh = shapes::shuffled_grid(6, 4);
  const MorphCounts counts = merge(mesh);
  expect_made_by_the_front(counts, mesh);
  EXPECT_EQ(mesh.topo().face_count(), 24u);
  EXPECT_EQ(mesh.topo().node_count(), 35u);
  EXPECT_EQ(counts.n_triangles, 48u);
}

TEST_P(QMorph, FindsTheGridRoundAnOpenLine) {
  WorkMesh mesh = shapes::shuffled_grid(6, 4, {{15, 16}, {16, 17}, {17, 18}});
  const MorphCounts counts = merge(mesh);
  expect_made_by_the_front(counts, mesh);
  EXPECT_EQ(mesh.topo().face_count(), 24u);
  EXPECT_EQ(shapes::n_constraints(mesh), 20u + 3);
  std::size_t end = 0;  // nodes are numbered anew
  while (mesh.point(NodeId(end)) != Point{4, 2}) ++end;
  EXPECT_EQ(mesh.topo().edge_valence(NodeId(end)), 4);  // the end of the line is regular
  std::size_t n_line_end = 0;
  for (int state = 0; state < 3; ++state) n_line_end += counts.quads[2][state] + counts.quads[state][2];
  EXPECT_GE(n_line_end, 1u);
}

TEST_P(QMorph, LineThatTouchesTheBoundary) {
  WorkMesh mesh = shapes::shuffled_grid(6, 4, {{3, 10}, {10, 17}});
  expect_made_by_the_front(merge(mesh), mesh);
  EXPECT_EQ(mesh.topo().face_count(), 24u);
  EXPECT_EQ(shapes::n_constraints(mesh), 20u + 2);
}

TEST_P(QMorph, CrossingLines) {
  WorkMesh mesh = shapes::shuffled_grid(6, 4, {{15, 16}, {16, 17}, {17, 18}, {9, 16}, {16, 23}});
  expect_made_by_the_front(merge(mesh), mesh);
  EXPECT_EQ(mesh.topo().face_count(), 24u);
  EXPECT_EQ(shapes::n_constraints(mesh), 20u + 5);
}

// Without a grid to find the front meets all its cases, and still leaves nothing to completion.
TEST_P(QMorph, PlatesOfTrianglesInNoOrder) {
  MorphCounts sum;
  for (std::uint32_t seed = 0; seed < 20; ++seed) {
    WorkMesh mesh = shapes::jittered_grid(12, 10, 0.35, seed, {{55, 56}, {56, 57}, {57, 58}});
    ASSERT_EQ(defect(mesh), "");
    const MorphCounts counts = merge(mesh);
    EXPECT_EQ(shapes::n_constraints(mesh), 44u + 3);
    expect_made_by_the_front(counts, mesh);
    sum += counts;
  }
  for (const auto& [tail, head] : {std::array{0, 0}, {0, 1}, {1, 0}, {1, 1}}) EXPECT_GT(sum.quads[tail][head], 50u);
  EXPECT_GT(sum.side_swapped, 20u);
  EXPECT_GT(sum.side_split_parity, 50u);
  EXPECT_GT(sum.side_split_length, 5u);
  EXPECT_GT(sum.side_split_direction, 5u);
  EXPECT_GT(sum.top_swapped, 50u);
  EXPECT_GT(sum.seams, 50u);
  EXPECT_GT(sum.transition_seams, 0u);
  EXPECT_GT(sum.transition_splits, 0u);
  EXPECT_GT(sum.closures_of_4, 0u);
  EXPECT_GT(sum.closures_of_6_by_2, 0u);
  EXPECT_GT(sum.closures_of_6_by_3, 0u);
}

INSTANTIATE_TEST_SUITE_P(Both, QMorph, testing::Values(LineFronts::OneSided, LineFronts::TwoSided));

// Triangles on either side of the line, from node 81 to 85, when the first layer of quads stands.
std::array<int, 2> triangles_beside_line(LineFronts lines) {
  WorkMesh mesh = shapes::shuffled_grid(12, 12, {{81, 82}, {82, 83}, {83, 84}, {84, 85}});
  const SizeField size = shapes::unit_size();
  Context context;
  std::array<int, 2> n{-1, -1};  // left, right
  merge_to_quads(
      mesh, size, {.lines = lines},
      [&](std::string_view name, const WorkMesh& now) {
        if (name != "first-layer") return;
        n = {0, 0};
        for (std::size_t v = 81; v < 85; ++v) {
          const HalfId h = now.topo().find(NodeId(v), NodeId(v + 1));
          n[0] += now.is_triangle(h);
          n[1] += now.is_triangle(twin(h));
        }
      },
      context);
  return n;
}

TEST(QMorphOneSided, FirstLayerStandsOnTheLeftOfTheLineOnly) {
  EXPECT_EQ(triangles_beside_line(LineFronts::OneSided), (std::array<int, 2>{0, 4}));
  EXPECT_EQ(triangles_beside_line(LineFronts::TwoSided), (std::array<int, 2>{0, 0}));
}

TEST(QMorph, FirstLayerAndHalfWayAreShown) {
  WorkMesh mesh = shapes::shuffled_grid(12, 12);
  const SizeField size = shapes::unit_size();
  Context context;
  std::vector<std::string> seen;
  merge_to_quads(
      mesh, size, {},
      [&](std::string_view name, const WorkMesh& now) {
        seen.emplace_back(name);
        const std::size_t n_quads = now.topo().face_count() - shapes::n_triangles(now);
        if (name == "half-way") {
          EXPECT_NEAR(static_cast<double>(n_quads), 72, 3);
          return;
        }
        EXPECT_EQ(n_quads, 44u);  // the outermost ring of the twelve by twelve
        for (std::size_t i = 0; i < now.topo().edge_capacity(); ++i) {
          const EdgeId e(i);
          if (!now.topo().is_live(e) || !now.is_constraint(e)) continue;
          EXPECT_FALSE(now.is_triangle(half_of(e, 0)) || now.is_triangle(half_of(e, 1)));
        }
      },
      context);
  EXPECT_EQ(seen, (std::vector<std::string>{"first-layer", "half-way"}));
}

// Many fronts meet between the holes: no triangle is left, and six without a second try of refused edges.
TEST(QMorph, SecondTryOfRefusedEdgesLeavesLessToCompletion) {
  Options options;
  options.size = 23;
  options.method = Method::QMorph;
  options.triangles = Triangles::Front;
  Context context;
  const MeshResult result = generate(read_model("models/structures/perforated-8x8.json"), options, context);
  EXPECT_GT(result.report.qmorph.refused_side, 100u);
  EXPECT_EQ(result.report.qmorph.completion_triangles, 0u);
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
