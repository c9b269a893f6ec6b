// The chain of attempts, with cells that are made to look troubled.
#include "cells/fallback_plan.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "cells/attempt.hpp"
#include "cells/cell_meshes.hpp"
#include "domain/arrange/arrange.hpp"
#include "quadline/io/read_model.hpp"
#include "tests/unit/cells/two_cells.hpp"

namespace quadline {
namespace {

class Fallback : public testing::Test {
 protected:
  Context context_;
  Domain domain_ = arrange(shapes::two_cells(), {}, context_);
  const Options options_;
  FallbackPlan plan_{domain_, options_, context_};
  CellCache cache_{domain_.cells.count()};
  StageClock clock_;

  CellId left() const { return troubles_at(domain_, Point{0.5, 0.5}, "")[0].cell; }
  void take_left_to(std::size_t rung) {
    for (std::size_t i = 0; i < rung; ++i) ASSERT_TRUE(plan_.advance({{left(), "it looks bad", {2, 3}}}));
  }
  Attempt attempt() { return attempt_mesh(plan_, options_, cache_, clock_, context_); }
  static std::size_t n_right(const Mesh& mesh) {
    std::size_t n = 0;
    for (const auto& q : mesh.quads) n += mesh.points[q[0]].x + mesh.points[q[2]].x > 8;
    return n;
  }
};

TEST_F(Fallback, PlacesAreFoundInTheirCells) {
  EXPECT_EQ(troubles_at(domain_, Point{0.5, 0.5}, "why").size(), 1u);
  EXPECT_EQ(troubles_at(domain_, Point{4, 1}, "why").size(), 2u);    // on the line between them
  EXPECT_EQ(troubles_at(domain_, Point{100, 1}, "why").size(), 2u);  // nowhere: all
  EXPECT_EQ(troubles_at(domain_, std::nullopt, "why").size(), 2u);
}

TEST_F(Fallback, EveryRungGivesAValidMeshAndNamesTheCell) {
  EXPECT_TRUE(attempt().result.report.findings.empty());
  for (std::size_t rung = 1; rung < std::size(kRungs); ++rung) {
    take_left_to(1);
    const Attempt got = attempt();
    ASSERT_FALSE(got.result.failure) << kRungs[rung].what << ": " << got.result.failure->reason;
    const std::vector<Finding>& findings = got.result.report.findings;
    ASSERT_EQ(findings.size(), 1u);
    EXPECT_EQ(findings[0].text, "a cell of region 'domain' is meshed " + std::string(kRungs[rung].what) +
                                    ", because as asked it looks bad");
    EXPECT_EQ(troubles_at(domain_, findings[0].at, "")[0].cell, left());
  }
  EXPECT_FALSE(plan_.advance({{left(), "it looks bad", {2, 3}}}));
}

TEST_F(Fallback, OnlyTheTroubledCellGetsSmallerSizes) {
  const std::size_t n_all = attempt().result.mesh.quads.size(), n_beside = n_right(attempt().result.mesh);
  take_left_to(3);
  const Mesh mesh = attempt().result.mesh;
  EXPECT_GT(mesh.quads.size() - n_right(mesh), 2 * (n_all - n_beside));
  EXPECT_LT(n_right(mesh), 2 * n_beside);
}

TEST_F(Fallback, HalvingKeepsTheSizes) {
  const auto n_all = static_cast<double>(attempt().result.mesh.quads.size());
  take_left_to(kFirstHalving);
  const auto n_halved = static_cast<double>(attempt().result.mesh.quads.size());
  EXPECT_NEAR(n_halved / n_all, 1, 0.25);
}

TEST_F(Fallback, EachCellClimbsItsOwnLadderUntilOneBesideItIsHalved) {
  const CellId right = troubles_at(domain_, Point{7, 3}, "")[0].cell;
  take_left_to(kFirstHalving - 1);
  plan_.advance({{left(), "it looks bad", {2, 3}}, {right, "it too", {7, 3}}});
  EXPECT_TRUE(plan_.rung(left()).is_halved);
  EXPECT_TRUE(plan_.is_changed(right));
  EXPECT_FALSE(plan_.rung(right).is_halved);
  plan_.advance({{right, "it too", {7, 3}}});
  EXPECT_TRUE(plan_.rung(right).is_halved);
}

TEST_F(Fallback, OnlyTheTroubledCellIsHalved) {
  const std::size_t n_before = n_right(attempt().result.mesh);
  take_left_to(kFirstHalving);
  std::size_t n_triangles = 0;
  context_.on_snapshot = [&](std::string_view name, const Mesh& mesh) {
    if (name != "before-halving") return;
    n_triangles = mesh.triangles.size();
    for (const auto& t : mesh.triangles)
      for (const NodeIndex v : t) EXPECT_LE(mesh.points[v].x, 4);
  };
  const Attempt got = attempt();
  ASSERT_FALSE(got.result.failure);
  EXPECT_GT(n_triangles, 0u);
  EXPECT_NEAR(static_cast<double>(n_right(got.result.mesh)) / static_cast<double>(n_before), 1, 0.2);
}

// On the rungs that leave the sizes as they are.
TEST_F(Fallback, CellsFromTheCacheAreThoseThatWouldBeMade) {
  attempt();  // keeps nothing
  for (const std::size_t climbs : {1u, 3u}) {
    take_left_to(climbs);
    const Mesh filled = attempt().result.mesh, taken = attempt().result.mesh;
    cache_ = CellCache(domain_.cells.count());
    const Mesh made = attempt().result.mesh;
    for (const Mesh& mesh : {filled, taken}) {
      EXPECT_EQ(mesh.quads, made.quads);
      EXPECT_EQ(mesh.points, made.points);
    }
  }
}

// What is cleaned up in the second attempt with the same plan is taken from the first.
TEST_F(Fallback, TheCacheSavesCleanUp) {
  const auto cleans_up = [&] {
    clock_ = {};
    attempt();
    return std::any_of(clock_.times().begin(), clock_.times().end(),
                       [](const StageTime& time) { return time.stage == "clean-up"; });
  };
  take_left_to(1);
  EXPECT_TRUE(cleans_up());
  EXPECT_FALSE(cleans_up());
  cache_ = CellCache(domain_.cells.count());
  EXPECT_TRUE(cleans_up());
}

// Corners of the quads in the left cell.
std::set<std::vector<std::pair<double, double>>> quads_of(const WorkMesh& mesh, CellId c) {
  std::set<std::vector<std::pair<double, double>>> quads;
  for (std::size_t i = 0; i < mesh.topo().face_capacity(); ++i) {
    if (!mesh.topo().is_live(FaceId(i)) || mesh.cell(FaceId(i)) != c) continue;
    std::vector<std::pair<double, double>> corners;
    for (const Point p : mesh.quad_points(FaceId(i))) corners.push_back({p.x, p.y});
    std::sort(corners.begin(), corners.end());
    quads.insert(corners);
  }
  return quads;
}

// A smoothed mesh that is made to look spoiled at one place: what is round it is kept, the third time all.
TEST_F(Fallback, WhatIsRoundASpoiledPlaceIsKept) {
  take_left_to(kFirstHalving);
  const Domain& domain = plan_.domain();
  const SizeField size = make_size_field(domain, options_, context_);
  const CurveNodes nodes(domain, size, {}, {}, plan_.halved_cells(), context_);
  CellMeshes cells(plan_, nodes, size, cache_, clock_, context_);
  const auto raw = quads_of(cells.take_raw(), left());
  std::vector<std::size_t> n_kept;
  for (int round = 0; round < 4; ++round) {
    WorkMesh mesh = cells.take_joined();
    mesh.thaw();
    const auto quads = quads_of(mesh, left());
    n_kept.push_back(static_cast<std::size_t>(
        std::count_if(raw.begin(), raw.end(), [&](const auto& quad) { return quads.contains(quad); })));
    EXPECT_FALSE(cells.mesh_spoiled_again(mesh));  // nothing is
    NodeId nearest;
    for (std::size_t i = 0; i < mesh.topo().node_capacity(); ++i) {
      const auto away = [&](NodeId v) { return distance(mesh.point(v), {0.6, 0.6}); };
      if (const NodeId v(i); mesh.tag(v).kind == NodeKind::Free && (!nearest.valid() || away(v) < away(nearest)))
        nearest = v;
    }
    mesh.move(nearest, {3, 3});
    EXPECT_EQ(cells.mesh_spoiled_again(mesh), round < 3) << round;
  }
  EXPECT_LT(n_kept[0], n_kept[1]);  // clean-up changes most of the cell
  EXPECT_EQ(n_kept[3], raw.size());
}

TEST(FallbackPlan, RecipesFollowTheOptionsAndTheRung) {
  Context context;
  const Domain domain = arrange(shapes::two_cells(), {}, context);
  const CellId first(std::size_t{0});
  const auto climb = [&](FallbackPlan& plan) { return plan.advance({{first, "it looks bad", {}}}); };
  for (const Triangles triangles : {Triangles::Delaunay, Triangles::Front, Triangles::Both}) {
    const Options options{.lines = LineFronts::OneSided, .triangles = triangles};
    FallbackPlan plan(domain, options, context);
    const bool is_delaunay = triangles == Triangles::Delaunay;
    const Triangles asked = is_delaunay ? Triangles::Delaunay : Triangles::Front;
    const Triangles other = is_delaunay ? Triangles::Front : Triangles::Delaunay;
    for (std::size_t rung = 0; rung < std::size(kRungs); ++rung) {
      const Recipe recipe = plan.recipe(first);
      EXPECT_EQ(recipe.triangles, kRungs[rung].other_triangles ? other : asked) << rung;
      EXPECT_EQ(recipe.lines, LineFronts::OneSided);
      EXPECT_EQ(recipe.method, rung < kFirstHalving ? Method::QMorph : Method::Merge) << rung;
      EXPECT_EQ(recipe.keeps_thin_quads, rung >= kFirstHalving) << rung;
      EXPECT_EQ(recipe.may_retry, rung == 0 && triangles == Triangles::Both) << rung;
      EXPECT_EQ(climb(plan), rung + 1 < std::size(kRungs));
    }
    EXPECT_EQ(plan.recipe(CellId(std::size_t{1})).triangles, asked);  // the other cell is meshed as asked
  }
  const Options options{.method = Method::Split};
  FallbackPlan plan(domain, options, context);
  EXPECT_EQ(plan.recipe(first).lines, LineFronts::TwoSided);
  EXPECT_FALSE(plan.recipe(first).keeps_thin_quads);
  for (std::size_t rung = 0; rung < kFirstHalving; ++rung) climb(plan);
  EXPECT_EQ(plan.recipe(first).method, Method::Split);
  EXPECT_TRUE(plan.recipe(first).keeps_thin_quads);
}

TEST(FallbackPlan, SizesOfCurvesAndPointsFollowThoseOfTheirCell) {
  Model model = shapes::two_cells();
  model.lines[0].size = 0.4;  // between the two cells
  model.lines[1].size = 0.3;  // in the right one
  model.points.push_back({.name = "left", .at = {3.3, 3.3}, .size = 0.1});
  model.points.push_back({.name = "right", .at = {7.3, 3.3}, .size = 0.1});
  model.points.push_back({.name = "end", .at = {4, 0}, .size = 0.2});
  Context context;
  const Domain asked = arrange(model, {}, context);
  const CellId left = troubles_at(asked, Point{0.5, 0.5}, "")[0].cell;
  const Options options;
  FallbackPlan plan(asked, options, context);
  for (const double factor : {1.0, 0.7, 0.5, 1.0, 0.5, 0.25}) {  // never factors of factors
    ASSERT_TRUE(plan.advance({{left, "it looks bad", {}}}));
    const Domain& domain = plan.domain();
    for (std::size_t i = 0; i < asked.cells.count(); ++i) {
      const CellId c(i);
      EXPECT_DOUBLE_EQ(domain.cells[c].size, asked.cells[c].size * (c == left ? factor : 1));
    }
    for (std::size_t i = 0; i < asked.curves.count(); ++i) {
      const Domain::Curve& curve = asked.curves[CurveId(i)];
      const bool is_beside = curve.left == left || curve.right == left;
      EXPECT_DOUBLE_EQ(domain.curves[CurveId(i)].size, curve.size * (is_beside ? factor : 1));
    }
    EXPECT_DOUBLE_EQ(domain.points[0].size, 0.1 * factor);
    EXPECT_DOUBLE_EQ(domain.points[1].size, 0.1);
    EXPECT_DOUBLE_EQ(domain.points[2].size, 0.2 * factor);
  }
}

// Four bays with holes, and unlike each other.
class PlannedBays : public ::testing::Test {
 protected:
  static Model model() {
    Model model;
    model.size = 1;
    model.outer.push_back({.items = {{{0, 0}}, {{24, 0}}, {{24, 24}}, {{0, 24}}}});
    model.lines.push_back({.name = {}, .path = {.items = {{{12, 0}}, {{12, 24}}}}});
    model.lines.push_back({.name = {}, .path = {.items = {{{0, 12}}, {{24, 12}}}}});
    model.holes = {{.circle = Circle{{6, 6}, 1.3}},
                   {.circle = Circle{{18, 6}, 1.9}},
                   {.circle = Circle{{6, 18}, 2.4}},
                   {.circle = Circle{{18, 18}, 2.9}}};
    return model;
  }
  std::size_t n_planned() const {
    std::size_t n = 0;
    for (std::size_t i = 0; i < plan_.domain().cells.count(); ++i) n += plan_.recipe(CellId(i)).is_grid_planned();
    return n;
  }
  static Trouble no_grid(std::size_t cell) {
    return {.cell = CellId(cell), .reason = "it does not come out", .at = {}, .is_grid = true};
  }

  Context context_;
  const Options options_;
  FallbackPlan plan_{arrange(model(), {}, context_), options_, context_};
};

TEST_F(PlannedBays, AGridInTroubleIsDroppedAndTheCellMeshedAsAsked) {
  ASSERT_EQ(n_planned(), 4u);
  ASSERT_TRUE(plan_.advance({no_grid(0)}));
  EXPECT_EQ(n_planned(), 3u);
  EXPECT_FALSE(plan_.recipe(CellId(std::size_t{0})).is_grid_planned());
  EXPECT_FALSE(plan_.is_changed(CellId(std::size_t{0})));
  std::size_t n_with_rings = 0;
  for (const Domain::Curve& curve : plan_.domain().curves) n_with_rings += curve.has_rings;
  EXPECT_EQ(n_with_rings, 6u);
}

TEST_F(PlannedBays, AfterTwoFailuresNoGridIsPlanned) {
  ASSERT_TRUE(plan_.advance({no_grid(0)}));
  ASSERT_TRUE(plan_.advance({no_grid(1)}));
  EXPECT_EQ(n_planned(), 2u);
  ASSERT_TRUE(plan_.advance({no_grid(2)}));
  EXPECT_EQ(n_planned(), 0u);
}

// Nine cells that take turns.
TEST(FallbackPlan, GivesUpAfterManyAttempts) {
  Model model;
  model.size = 1;
  model.outer.push_back({.items = {{{0, 0}}, {{9, 0}}, {{9.5, 9}}, {{0, 9}}}});  // not symmetric
  for (const double at : {3.0, 6.0}) {
    model.lines.push_back({.name = {}, .path = {.items = {{{at, 0}}, {{at, 9}}}}});
    model.lines.push_back({.name = {}, .path = {.items = {{{0, at}}, {{9.5, at}}}}});
  }
  Context context;
  const Options options;
  FallbackPlan plan(arrange(model, {}, context), options, context);
  ASSERT_EQ(plan.domain().cells.count(), 9u);
  EXPECT_TRUE(plan.is_first());
  int n_advanced = 0;
  for (std::size_t i = 0; plan.advance({{CellId(i % 9), "it looks bad", {}}}); ++i) ++n_advanced;
  EXPECT_EQ(n_advanced, 23);
  EXPECT_FALSE(plan.is_first());
}

TEST_F(Fallback, SameBytesTwice) {
  take_left_to(kFirstHalving);
  const Mesh a = attempt().result.mesh, b = attempt().result.mesh;
  EXPECT_EQ(a.quads, b.quads);
  EXPECT_EQ(a.points, b.points);
}

TEST_F(Fallback, CancellingStopsIt) {
  take_left_to(kFirstHalving);
  context_.is_cancelled = [] { return true; };
  EXPECT_THROW(attempt(), Cancelled);
}

TEST(FallbackChain, EndsWithAValidMeshAndAFindingForTheCell) {
  Context context;
  const MeshResult result = generate(shapes::near_ends(), {}, context);
  ASSERT_FALSE(result.failure) << result.failure->reason;
  ASSERT_FALSE(result.report.findings.empty());
  EXPECT_NE(result.report.findings.back().text.find("a cell of region 'domain' is meshed"), std::string::npos);
  const MeshResult again = generate(shapes::near_ends(), {}, context);
  EXPECT_EQ(again.mesh.quads, result.mesh.quads);
  EXPECT_EQ(again.mesh.points, result.mesh.points);
}

TEST(FallbackChain, AThinQuadTakesItsCellStraightToHalving) {
  Context context;
  const Domain domain = arrange(shapes::near_ends(), {}, context);
  const Options options;
  FallbackPlan plan(domain, options, context);
  CellCache cache(domain.cells.count());
  StageClock clock;
  const Attempt first = attempt_mesh(plan, options, cache, clock, context);
  ASSERT_EQ(first.troubles.size(), 1u);
  EXPECT_TRUE(first.troubles[0].is_thin);
  ASSERT_TRUE(plan.advance(first.troubles));
  EXPECT_TRUE(plan.rung(first.troubles[0].cell).is_halved);
}

// As a method, halving holds no quads: clean-up and smoothing mend the flat ones that it leaves beside arcs.
TEST(Methods, MendTheFlatQuadsOfHalving) {
  for (const Method method : {Method::Merge, Method::Split}) {
    Context context;
    const MeshResult result =
        generate(read_model("models/structures/perforated-8x8.json"), {.method = method}, context);
    ASSERT_FALSE(result.failure);
    EXPECT_LT(result.report.before_smoothing.scaled_jacobian.min, 0.4);
    EXPECT_GT(result.report.quality.scaled_jacobian.min, 0.7);
  }
}

std::size_t n_attempts(const MeshResult& result) {
  std::size_t n = 0;
  for (const StageTime& time : result.report.stages) n += time.stage == "sizing";
  return n;
}

std::string refusal(const Model& model, double max_quads) {
  Context context;
  try {
    generate(model, {.max_quads = max_quads}, context);
  } catch (const InputError& error) {
    return error.what();
  }
  return "not refused";
}

TEST(MaxQuads, HoldsForFallBacks) {
  Context context;
  Options options;
  options.max_quads = 240;  // more than the first mesh takes, fewer than those that would help
  const MeshResult result = generate(shapes::near_ends(), options, context);
  ASSERT_TRUE(result.failure);
  EXPECT_LE(static_cast<double>(result.mesh.quads.size()), options.max_quads);
  EXPECT_EQ(result.report.findings.back().text, "what may help needs more quads than allowed");
}

TEST(MaxQuads, HoldsForTheFirstMesh) {
  Model plate;
  plate.size = 0.2;
  plate.outer.push_back({.items = {{{0, 0}}, {{6, 0}}, {{6, 4}}, {{0, 4}}}});
  EXPECT_EQ(refusal(plate, 100),
            "about 6e+02 quads are expected, more than 100: choose a larger size, or raise --max-quads");
  EXPECT_EQ(refusal(plate, 600), "not refused");
  // more than expected
  EXPECT_EQ(refusal(shapes::near_ends(), 230),
            "236 quads are needed, more than 230: choose a larger size, or raise --max-quads");
}

// The report of a model that nothing helps is about the mesh that comes with it, that of the first attempt.
TEST(FallbackChain, TheReportOfAFailureIsAboutItsMesh) {
  Model model;
  model.size = 1;
  model.outer.push_back({.items = {{{0, 0}}, {{10, 0}}, {{10, 10}}, {{0, 10}}}});
  model.lines.push_back({.name = "a", .path = {.items = {{{0, 5}}, {{10, 5}}}}});
  model.lines.push_back({.name = "b", .path = {.items = {{{0, 5}}, {{10, 5 + 3e-6}}}}});
  Context context;
  const MeshResult result = generate(model, {.tolerance = 1e-8}, context);
  ASSERT_TRUE(result.failure);
  EXPECT_GT(n_attempts(result), 1u);
  EXPECT_EQ(result.report.quality.n_quads, result.mesh.quads.size());
  EXPECT_NEAR(static_cast<double>(result.report.before_smoothing.n_quads),
              static_cast<double>(result.mesh.quads.size()), 0.2 * static_cast<double>(result.mesh.quads.size()));
}

}  // namespace
}  // namespace quadline
