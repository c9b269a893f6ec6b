// The chain of attempts, with cells that are made to look troubled.
#include "cells/fallback_plan.hpp"

#include <gtest/gtest.h>

#include <array>
#include <optional>

#include "cells/attempt.hpp"
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
  FallbackPlan plan_{domain_, options_};
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
    EXPECT_NE(findings[0].text.find(kRungs[rung].what), std::string::npos);
    EXPECT_NE(findings[0].text.find("it looks bad"), std::string::npos);
    EXPECT_LT(findings[0].at.x, 4);
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

// Lines that end 1e-5 beside a third, closer than anything that can be meshed as asked.
Model near_ends() {
  Model model;
  model.size = 0.5;
  model.outer.push_back({.items = {{{0, 0}}, {{8, 0}}, {{8, 6}}, {{0, 6}}}});
  model.lines.push_back({.name = "deck", .path = {.items = {{{1, 3}}, {{7, 3.4}}}}});
  for (const auto& [x, y, gap] : {std::array{3.2, 1.0, -1e-5}, std::array{3.5, 5.0, 2e-5}, std::array{3.7, 5.5, 1e-5}})
    model.lines.push_back({.name = {}, .path = {.items = {{{x, y}}, {{x, 3 + 0.4 * (x - 1) / 6 + gap}}}}});
  return model;
}

TEST(FallbackChain, EndsWithAValidMeshAndAFindingForTheCell) {
  Context context;
  const MeshResult result = generate(near_ends(), {}, context);
  ASSERT_FALSE(result.failure) << result.failure->reason;
  ASSERT_FALSE(result.report.findings.empty());
  EXPECT_NE(result.report.findings.back().text.find("a cell of region 'domain' is meshed"), std::string::npos);
  const MeshResult again = generate(near_ends(), {}, context);
  EXPECT_EQ(again.mesh.quads, result.mesh.quads);
  EXPECT_EQ(again.mesh.points, result.mesh.points);
}

TEST(FallbackChain, AThinQuadTakesItsCellStraightToHalving) {
  Context context;
  const Domain domain = arrange(near_ends(), {}, context);
  const Options options;
  FallbackPlan plan(domain, options);
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
  const MeshResult result = generate(near_ends(), options, context);
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
  EXPECT_EQ(refusal(near_ends(), 230),
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
