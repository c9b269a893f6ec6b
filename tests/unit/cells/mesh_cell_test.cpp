// One cell from the nodes on its curves to clean quads, by every recipe.
#include "cells/mesh_cell.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "cells/cell_cost.hpp"
#include "cells/thin_quads.hpp"
#include "domain/arrange/arrange.hpp"
#include "tests/unit/cells/two_cells.hpp"

namespace quadline {
namespace {

class MeshCell : public testing::Test {
 protected:
  CellInput input() const { return {domain_, CellId(std::size_t{0}), nodes_, sizes_, templates_}; }
  CellResult mesh(const Recipe& recipe) { return mesh_cell(input(), recipe, context_); }
  static std::vector<std::string> stages(const CellResult& result) {
    std::vector<std::string> names;
    for (const StageTime& time : result.times) names.push_back(time.stage);
    return names;
  }
  SpacedSizes spaced() const {
    SpacedSizes sizes(size_);
    for (const double spacing : {kHalvedSpacing, kCloser, kWider}) sizes.add(spacing);
    return sizes;
  }

  Context context_;
  const Domain domain_ = arrange(shapes::two_cells(), {}, context_);
  const SizeField size_ = make_size_field(domain_, {}, context_);
  const CurveNodes nodes_{domain_, size_, {}, {}, {}, context_};
  const SpacedSizes sizes_ = spaced();
  const cleanup::TemplateTable templates_;
};

void expect_sound(const CellResult& result) {
  ASSERT_FALSE(result.trouble) << result.trouble->reason;
  EXPECT_EQ(defect(result.mesh), "");
  EXPECT_GT(result.mesh.topo().face_count(), 20u);
  EXPECT_TRUE(unsound_faces(result.mesh).empty());
}

TEST_F(MeshCell, RunsTheStagesInTheirOrder) {
  const CellResult result = mesh({});
  expect_sound(result);
  EXPECT_EQ(stages(result), (std::vector<std::string>{"triangulate", "field points", "qmorph", "clean-up"}));
  EXPECT_GT(result.raw.topo().face_count(), 20u);
  EXPECT_GT(result.counts.n_triangles, 40u);
}

TEST_F(MeshCell, RetriesWithOtherTrianglesWhereAsked) {
  CellInput right = input();  // with a line, at whose ends nodes are irregular
  right.cell = CellId(std::size_t{1});
  const CellResult once = mesh_cell(right, {}, context_), retried = mesh_cell(right, {.may_retry = true}, context_);
  expect_sound(retried);
  EXPECT_EQ(stages(retried).back(), "retries");
  EXPECT_EQ(fingerprint(retried.raw), fingerprint(once.raw));  // that of the first try
  EXPECT_LT(cell_cost(retried.mesh), cell_cost(once.mesh));
}

TEST_F(MeshCell, OtherTrianglesMakeOtherQuads) {
  EXPECT_NE(mesh({}).start, mesh({.triangles = Triangles::Delaunay}).start);
}

TEST_F(MeshCell, LinesMayHaveFrontsOnOneSideFirst) {
  CellInput right = input();
  right.cell = CellId(std::size_t{1});
  EXPECT_NE(mesh_cell(right, {}, context_).start, mesh_cell(right, {.lines = LineFronts::OneSided}, context_).start);
}

TEST_F(MeshCell, AGridComesBeforeTheOtherStages) {
  // The left cell without its hole is a rectangle of 4 x 4 with size 0.5.
  Model plain = shapes::two_cells();
  plain.holes.clear();
  const Domain domain = arrange(plain, {}, context_);
  const SizeField size = make_size_field(domain, {}, context_);
  const CurveNodes nodes(domain, size, {}, {}, {}, context_);
  const SpacedSizes sizes(size);
  const CellId left(domain.cells[CellId(std::size_t{0})].walks.size() == 1 ? std::size_t{0} : std::size_t{1});
  const CellInput input{domain, left, nodes, sizes, templates_};
  const CurvePiece& first = domain.curves[domain.cells[left].walks[0][0].curve].piece;
  ASSERT_EQ(first.a.y, first.b.y);
  const CellResult grid = mesh_cell(input, {.may_grid = true}, context_);
  expect_sound(grid);
  EXPECT_TRUE(grid.is_grid);
  EXPECT_EQ(stages(grid), std::vector<std::string>{"grid"});
  EXPECT_EQ(fingerprint(grid.mesh), fingerprint(grid.raw));
  EXPECT_EQ(grid.counts, MorphCounts());
  EXPECT_FALSE(mesh_cell(input, {}, context_).is_grid);
}

TEST_F(MeshCell, QMorphFollowsAGridThatDoesNotFit) {
  const CellResult tried = mesh({.may_grid = true}), front = mesh({});  // no plan for the hole
  expect_sound(tried);
  EXPECT_FALSE(tried.is_grid);
  EXPECT_EQ(stages(tried), (std::vector<std::string>{"grid", "triangulate", "field points", "qmorph", "clean-up"}));
  EXPECT_EQ(fingerprint(tried.mesh), fingerprint(front.mesh));
}

TEST_F(MeshCell, APlannedGridThatDoesNotFitIsTrouble) {
  GridPlan plan;
  plan.holes = {{.walk = 1, .columns = 40, .rows = 40, .rings = 1, .at = {2, 2}, .place = {4, 4}}};
  const CellResult result = mesh({.may_grid = true, .grid = plan});
  ASSERT_TRUE(result.trouble);
  EXPECT_TRUE(result.trouble->is_grid);
  EXPECT_EQ(result.mesh.topo().face_count(), 0u);
  EXPECT_EQ(stages(result), std::vector<std::string>{"grid"});
}

class MeshHalvedCell : public MeshCell {
 protected:
  static CellSet both() {
    CellSet cells;
    for (const std::size_t i : {0, 1}) cells.insert(CellId(i));
    return cells;
  }
  CellResult mesh(const Recipe& recipe) {
    CellInput halved = input();
    const CurveNodes nodes(domain_, size_, {}, {}, both(), context_);
    return mesh_cell({domain_, halved.cell, nodes, sizes_, templates_, cache_}, recipe, context_);
  }
  const CellCache* cache_ = nullptr;
};

TEST_F(MeshHalvedCell, PairsOrNot) {
  const CellResult merged = mesh({.method = Method::Merge}), split = mesh({.method = Method::Split});
  expect_sound(merged);
  expect_sound(split);
  EXPECT_EQ(stages(merged), (std::vector<std::string>{"triangulate", "field points", "pair", "halve", "clean-up"}));
  EXPECT_EQ(stages(split), (std::vector<std::string>{"triangulate", "field points", "halve", "clean-up"}));
}

// A reach over everything: no quad is cleaned up.
TEST_F(MeshHalvedCell, KeepsWhatLiesNearPlaces) {
  const Recipe recipe{.method = Method::Split, .kept_places = {{1, 1}}, .kept_reach = 1e9};
  const CellResult kept = mesh(recipe);
  EXPECT_EQ(fingerprint(kept.mesh), fingerprint(kept.raw));
  EXPECT_NE(fingerprint(mesh({.method = Method::Split}).mesh), fingerprint(kept.raw));
}

TEST_F(MeshHalvedCell, TakesFromTheCacheWhatBeganTheSame) {
  const CellResult made = mesh({.method = Method::Merge});
  CellCache cache(2);
  const WorkMesh known = made.raw;  // not what clean-up makes of it
  cache.keep(input().cell, {made.start, known, {}});
  cache_ = &cache;
  const CellResult taken = mesh({.method = Method::Merge});
  EXPECT_TRUE(taken.is_cached);
  EXPECT_EQ(fingerprint(taken.mesh), fingerprint(known));
  EXPECT_FALSE(mesh({.method = Method::Split}).is_cached);
  EXPECT_FALSE(mesh({.method = Method::Merge, .kept_places = {{1, 1}}, .kept_reach = 1}).is_cached);
}

TEST_F(MeshCell, KeepsSnapshotsWhereTheyAreWanted) {
  EXPECT_TRUE(mesh({}).snapshots.empty());
  CellInput seen = input();
  seen.wants_snapshots = true;
  const CellResult result = mesh_cell(seen, {}, context_);
  ASSERT_FALSE(result.snapshots.empty());
  EXPECT_EQ(result.snapshots.front().name, "triangulation");
  for (const CellSnapshot& snapshot : result.snapshots)
    EXPECT_NE(std::find(kCellSnapshots.begin(), kCellSnapshots.end(), snapshot.name), kCellSnapshots.end());
  EXPECT_EQ(fingerprint(result.snapshots.back().mesh), result.start);
}

TEST_F(MeshCell, AnErrorOfAStageIsTroubleOfTheCell) {
  Context stops;
  bool is_told = false;
  stops.on_progress = [&](std::string_view stage, double) {
    if (stage == "qmorph" && !is_told) {
      is_told = true;
      throw InternalError("made to fail", {.file = {}, .place = {}, .point = Point{1, 2}});
    }
  };
  const CellResult result = mesh_cell(input(), {}, stops);
  ASSERT_TRUE(result.trouble);
  EXPECT_EQ(result.trouble->at, (Point{1, 2}));
  EXPECT_NE(result.trouble->reason.find("made to fail"), std::string::npos);
  EXPECT_EQ(result.mesh.topo().face_count(), 0u);
  is_told = false;
  EXPECT_FALSE(mesh_cell(input(), {.may_retry = true}, stops).trouble);  // other triangles save it
}

TEST_F(MeshCell, ProgressGoesForward) {
  std::vector<double> told;
  context_.on_progress = [&](std::string_view, double done) { told.push_back(done); };
  mesh({});
  EXPECT_TRUE(std::is_sorted(told.begin(), told.end()));
  EXPECT_GT(told.back(), 0.3);
  EXPECT_LE(told.back(), 1);
}

TEST_F(MeshCell, Stops) {
  context_.is_cancelled = [] { return true; };
  EXPECT_THROW(mesh({}), Cancelled);
}

}  // namespace
}  // namespace quadline
