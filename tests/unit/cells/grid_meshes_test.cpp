// Whole meshes with grids: as symmetric as their models, with equal chords, and only where grids are asked for.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <utility>
#include <vector>

#include "geom/angles.hpp"
#include "quadline/generate.hpp"
#include "tests/unit/cells/grid_cells.hpp"

namespace quadline {
namespace {

using Motion = std::function<Point(Point)>;

MeshResult made(const Model& model, const Options& options = {}) {
  Context context;
  MeshResult result = generate(model, options, context);
  EXPECT_FALSE(result.failure);
  return result;
}

// Nodes that a motion takes to a node.
std::size_t symmetric_nodes(const Mesh& mesh, const Motion& motion) {
  return static_cast<std::size_t>(std::count_if(mesh.points.begin(), mesh.points.end(), [&](Point p) {
    return std::any_of(mesh.points.begin(), mesh.points.end(), [&](Point q) { return distance(q, motion(p)) < 1e-6; });
  }));
}

// Longest over shortest edge of each hole.
double most_uneven(const Mesh& mesh) {
  double most = 1;
  for (const EdgeSet& curve : mesh.curves) {
    if (curve.kind != CurveKind::Hole) continue;
    std::vector<double> lengths;
    for (const auto& [a, b] : curve.edges) lengths.push_back(distance(mesh.points[a], mesh.points[b]));
    const auto [least, greatest] = std::minmax_element(lengths.begin(), lengths.end());
    most = std::max(most, *greatest / *least);
  }
  return most;
}

std::vector<Motion> motions_of_a_square(Point m) {
  std::vector<Motion> motions;
  for (int quarter = 0; quarter < 4; ++quarter)
    for (const bool is_mirrored : {false, true})
      motions.push_back([m, quarter, is_mirrored](Point p) {
        Point v = p - m;
        if (is_mirrored) v.x = -v.x;
        for (int n = 0; n < quarter; ++n) v = left_normal(v);
        return m + v;
      });
  return motions;
}

void expect_symmetric(const MeshResult& result, const std::vector<Motion>& motions) {
  for (const Motion& motion : motions) EXPECT_EQ(symmetric_nodes(result.mesh, motion), result.mesh.points.size());
  EXPECT_LT(most_uneven(result.mesh), 1 + 1e-6);
}

void expect_all_grids(const MeshResult& result) {
  EXPECT_EQ(result.report.cells.fronts.n_cells, 0u);
  EXPECT_EQ(result.report.cells.halved.n_cells, 0u);
  EXPECT_GT(result.report.cells.grids.n_quads, 0u);
}

TEST(GridMeshes, ASquareWithAHole) {
  for (const double radius : {0.4, 1.3, 2.2, 3.1}) {
    const MeshResult result = made(shapes::square_plate({{{6, 6}, radius}}));
    expect_all_grids(result);
    expect_symmetric(result, motions_of_a_square({6, 6}));
  }
}

TEST(GridMeshes, FourHolesAlike) {
  const MeshResult result = made(shapes::square_plate({{{3, 3}, 1}, {{9, 3}, 1}, {{3, 9}, 1}, {{9, 9}, 1}}));
  expect_all_grids(result);
  expect_symmetric(result, motions_of_a_square({6, 6}));
  std::vector<std::size_t> edges;
  for (const EdgeSet& curve : result.mesh.curves)
    if (curve.kind == CurveKind::Hole) edges.push_back(curve.edges.size());
  EXPECT_EQ(edges, std::vector<std::size_t>(4, edges[0]));
}

TEST(GridMeshes, ARing) {
  const MeshResult result = made(shapes::flange_model(0));
  expect_all_grids(result);
  expect_symmetric(result, motions_of_a_square({0, 0}));
  EXPECT_EQ(result.report.quality.n_irregular, 0u);
}

TEST(GridMeshes, AFlangeOfEightBolts) {
  const MeshResult result = made(shapes::flange_model(8));
  expect_all_grids(result);
  expect_symmetric(result, motions_of_a_square({0, 0}));
  EXPECT_EQ(result.report.quality.n_irregular, 32u);  // four at each bolt
}

TEST(GridMeshes, QMorphKnowsNothingOfThem) {
  const Model model = shapes::square_plate({{{6, 6}, 1.3}});
  const MeshResult grid = made(model), front = made(model, {.method = Method::QMorph});
  EXPECT_EQ(front.report.cells.grids.n_cells, 0u);
  EXPECT_GE(front.report.cells.fronts.n_cells, 1u);
  EXPECT_EQ(front.report.cells.fronts.n_quads + front.report.cells.copies.n_quads, front.mesh.quads.size());
  EXPECT_GT(front.report.qmorph.n_triangles, 100u);
  EXPECT_EQ(grid.report.qmorph, MorphCounts());
  // The ends of the arcs stay where the model has them: at angle 0.
  const auto has_node = [](const MeshResult& result, Point p) {
    return std::any_of(result.mesh.points.begin(), result.mesh.points.end(),
                       [&](Point q) { return distance(p, q) < 1e-9; });
  };
  EXPECT_TRUE(has_node(front, {7.3, 6}));
}

// Cells that no grid suits are meshed the same way, whether grids are allowed or not.
TEST(GridMeshes, WhereNoCellSuitsTheMethodsAgree) {
  Model model;
  model.size = 1;
  model.outer.push_back({.items = {{{0, 0}}, {{12, 0}}, {{7, 9}}, {{1, 7}}}});
  model.points.push_back({.name = "lug", .at = {5, 4}});
  const MeshResult layout = made(model), front = made(model, {.method = Method::QMorph});
  EXPECT_EQ(layout.report.cells.grids.n_cells, 0u);
  EXPECT_EQ(layout.mesh.points, front.mesh.points);
  EXPECT_EQ(layout.mesh.quads, front.mesh.quads);
}

TEST(CellOrigins, HaveEveryCellAndQuadOnce) {
  Model model = shapes::square_plate({{{2.8, 5.7}, 1.1}, {{9.2, 6.4}, 1.1}});
  model.lines.push_back({.name = "middle", .path = {.items = {{{6, 0}}, {{6, 12}}}}});
  model.lines.push_back({.name = "stay", .path = {.items = {{{0, 10.5}}, {{1.3, 12}}}}});
  for (const Method method : {Method::Layout, Method::QMorph, Method::Merge}) {
    const MeshResult result = made(model, {.method = method});
    const CellOrigins& cells = result.report.cells;
    std::size_t n_cells = 0, n_quads = 0;
    for (const CellOrigins::Share& share : {cells.grids, cells.fronts, cells.halved, cells.copies}) {
      n_cells += share.n_cells;
      n_quads += share.n_quads;
    }
    EXPECT_EQ(n_cells, result.report.n_cells);
    EXPECT_EQ(n_quads, result.mesh.quads.size());
    EXPECT_EQ(cells.halved.n_cells > 0, method == Method::Merge);
    EXPECT_EQ(cells.fronts.n_cells > 0, method != Method::Merge);
  }
}

TEST(CellOrigins, TellCopies) {
  Model model = shapes::square_plate({{{3, 6}, 1.1}, {{9, 6}, 1.1}});
  model.lines.push_back({.name = "middle", .path = {.items = {{{6, 0}}, {{6, 12}}}}});
  const CellOrigins cells = made(model).report.cells;
  EXPECT_EQ(cells.grids.n_cells, 1u);
  EXPECT_EQ(cells.copies.n_cells, 1u);
  EXPECT_EQ(cells.copies.n_quads, cells.grids.n_quads);
}

}  // namespace
}  // namespace quadline
