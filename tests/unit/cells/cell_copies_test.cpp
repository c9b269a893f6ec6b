// Cells that are alike are meshed once; a symmetric model gets a symmetric mesh.
#include "cells/cell_copies.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "cells/cell_meshes.hpp"
#include "domain/arrange/arrange.hpp"
#include "quadline/generate.hpp"
#include "quadline/inspect.hpp"
#include "search/place_index.hpp"

namespace quadline {
namespace {

// A row of bays of 8 x 6, each with a hole left of its middle; where asked, right of it.
Model bays(const std::vector<bool>& is_right) {
  Model model;
  model.size = 1;
  const double width = 8 * static_cast<double>(is_right.size());
  model.outer.push_back({.items = {{{0, 0}}, {{width, 0}}, {{width, 6}}, {{0, 6}}}});
  for (std::size_t i = 0; i < is_right.size(); ++i) {
    const double x = 8 * static_cast<double>(i);
    if (i > 0) model.lines.push_back({.name = {}, .path = {.items = {{{x, 0}}, {{x, 6}}}}});
    model.holes.push_back({.circle = Circle{{x + (is_right[i] ? 5 : 3), 3.25}, 1}});
  }
  return model;
}

// Share of the nodes whose image by the motion is a node.
double share_of_images(const Mesh& mesh, const Isometry& move) {
  const PlaceIndex index(mesh.points, 1e-6);
  std::size_t n = 0;
  for (const Point p : mesh.points) n += index.find(move(p)) != PlaceIndex::kNone;
  return static_cast<double>(n) / static_cast<double>(mesh.points.size());
}

// What troubles the grid of a cell troubles those of its copies: none is tried in an attempt of its own.
TEST(CopiesOfTrouble, AllLikeBaysLoseTheirGridsAtOnce) {
  Context context;
  const Options options;
  const FallbackPlan plan(arrange(bays({false, false, false, true}), {}, context), options, context);
  const SizeField size = make_size_field(plan.domain(), options, context).scaled(0.45);
  const CurveNodes nodes(plan.domain(), size, {}, plan.symmetries(), {}, context);  // what grids wish is not heard
  CellCache cache(plan.domain().cells.count());
  StageClock clock;
  const CellMeshes cells(plan, nodes, size, cache, clock, context);
  const std::vector<Trouble> troubles = cells.troubles();
  ASSERT_EQ(troubles.size(), 4u);
  for (std::size_t i = 0; i < troubles.size(); ++i) {
    EXPECT_EQ(troubles[i].cell, CellId(i));
    EXPECT_TRUE(troubles[i].is_grid);
  }
}

class Copies : public testing::Test {
 protected:
  // The copies among the cells of a model, and how far the nodes of each lie from the moved ones of its original.
  void find(const Model& model) {
    Context context;
    const Domain domain = arrange(model, {}, context);
    const SizeField size = make_size_field(domain, {}, context);
    const std::vector<Symmetry> symmetries = find_symmetries(domain);
    const CurveNodes nodes(domain, size, {}, symmetries, {}, context);
    copies_ = find_copies(domain, symmetries, nodes, size, [](CellId, CellId) { return true; });
    for (const CellCopy& copy : copies_) {
      const WorkMesh original = nodes.of(copy.original), wanted = nodes.of(copy.copy);
      const WorkMesh made = copied(original, copy, nodes);
      ASSERT_EQ(made.topo().node_count(), wanted.topo().node_count());
      ASSERT_EQ(made.segments().size(), wanted.segments().size());
      for (const NodeId v : original.topo().nodes()) {
        EXPECT_LT(distance(made.point(v), copy.move(original.point(v))), 1e-9);
        EXPECT_EQ(made.tag(v).kind, original.tag(v).kind);
      }
    }
  }
  std::vector<CellCopy> copies_;
};

TEST_F(Copies, AreMoved) {
  find(bays({false, false, false}));
  ASSERT_EQ(copies_.size(), 2u);
  for (const CellCopy& copy : copies_) EXPECT_FALSE(copy.move.is_mirrored);
}

TEST_F(Copies, AreMirrored) {
  find(bays({false, false, true}));
  ASSERT_EQ(copies_.size(), 2u);
  EXPECT_TRUE(copies_[0].move.is_mirrored != copies_[1].move.is_mirrored);
}

TEST_F(Copies, AreOnlyOfCellsThatAreAlike) {
  Model model = bays({false, false});
  model.holes[1].circle->radius = 1.1;
  find(model);
  EXPECT_TRUE(copies_.empty());
  model = bays({false, false});
  model.points.push_back({.name = "lug", .at = {14, 2}});
  find(model);
  EXPECT_TRUE(copies_.empty());
  model.points.push_back({.name = "lug", .at = {6, 2}});
  find(model);
  EXPECT_EQ(copies_.size(), 1u);
}

TEST_F(Copies, AMirroredMeshTurnsItsQuadsRound) {
  Context context;
  const Domain domain = arrange(bays({false, true}), {}, context);
  const SizeField size = make_size_field(domain, {}, context);
  const std::vector<Symmetry> symmetries = find_symmetries(domain);
  const CurveNodes nodes(domain, size, {}, symmetries, {}, context);
  const std::vector<CellCopy> copies =
      find_copies(domain, symmetries, nodes, size, [](CellId, CellId) { return true; });
  ASSERT_EQ(copies.size(), 1u);
  ASSERT_TRUE(copies[0].move.is_mirrored);
  const NodeTag corner = nodes.of(copies[0].original).tag(NodeId(std::size_t{0}));
  WorkMesh triangle;
  triangle.build({{1, 1}, {2, 1}, {1, 2}}, {corner, {}, {}}, std::vector{Polygon(NodeId(0), NodeId(1), NodeId(2))});
  triangle.set_cell(FaceId(std::size_t{0}), copies[0].original);
  const WorkMesh made = copied(triangle, copies[0], nodes);
  const Polygon p = made.topo().polygon(FaceId(std::size_t{0}));
  EXPECT_EQ(p.nodes[0], NodeId(std::size_t{2}));
  EXPECT_EQ(made.cell(FaceId(std::size_t{0})), copies[0].copy);
  EXPECT_LT(distance(made.point(NodeId(std::size_t{1})), copies[0].move({2, 1})), 1e-12);
}

TEST(SymmetricMesh, OfASymmetricPlateWithHolesLinesAndPoints) {
  Model model;
  model.size = 1;
  model.outer.push_back({.items = {{{-15, -9}}, {{15, -9}}, {{15, 9}}, {{-15, 9}}}});
  model.holes.push_back({.circle = Circle{{0, 0}, 2.5}});
  for (const double x : {-8.0, 8.0}) {
    model.holes.push_back({.circle = Circle{{x, 1.5}, 1.5}});
    model.lines.push_back({.name = {}, .path = {.items = {{{1.5 * x, -6}}, {{0.5 * x, -5}}}}});
    model.points.push_back({.name = {}, .at = {0.5 * x, 6}});
  }
  Context context;
  const MeshResult result = generate(model, {}, context);
  ASSERT_FALSE(result.failure) << result.failure->reason;
  EXPECT_EQ(share_of_images(result.mesh, {.is_mirrored = true}), 1);
  EXPECT_EQ(result.report.n_cells, 1u);  // cuts are not told
  EXPECT_EQ(result.report.n_curves, describe(model, {}, context).n_curves);
  EXPECT_TRUE(result.report.findings.empty());
  EXPECT_GT(result.report.quality.scaled_jacobian.min, 0.5);
}

}  // namespace
}  // namespace quadline
