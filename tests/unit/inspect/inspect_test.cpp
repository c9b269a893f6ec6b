#include "quadline/inspect.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

namespace quadline {
namespace {

/// A plate of 6 x 4 with a line that crosses it and leaves it.
Model plate() {
  Model model;
  model.size = 0.5;
  model.outer = {{.items = {{{0, 0}}, {{6, 0}}, {{6, 4}}, {{0, 4}}}}};
  model.lines = {{.name = "stiffener", .path = {.items = {{{0, 2}}, {{7, 2}}}}}};
  return model;
}

Mesh mesh_of(const Model& model, const Options& options = {}) {
  Context context;
  const MeshResult result = generate(model, options, context);
  EXPECT_FALSE(result.failure) << result.failure->reason;
  return result.mesh;
}

TEST(Describe, TellsWhatTheArrangementHolds) {
  Context context;
  const ModelFacts facts = describe(plate(), {}, context);
  EXPECT_EQ(facts.size, 0.5);
  EXPECT_EQ(facts.n_cells, 2u);
  EXPECT_EQ(facts.n_curves, 7u);
  EXPECT_EQ(facts.n_vertices, 6u);
  EXPECT_EQ(facts.low, (Point{0, 0}));
  EXPECT_EQ(facts.high, (Point{6, 4}));
  EXPECT_EQ(facts.expected.area, 24);
  EXPECT_GT(facts.tolerance, 0);
  ASSERT_EQ(facts.findings.size(), 1u);
  EXPECT_NE(facts.findings[0].text.find("line 'stiffener' leaves the domain: trimmed"), std::string::npos);
  EXPECT_TRUE(facts.corners.empty());
  Model sharp = plate();
  sharp.outer[0].items[3].to = {2, 4};
  EXPECT_FALSE(describe(sharp, {}, context).corners.empty());
}

TEST(Estimate, IsNearTheMesh) {
  Context context;
  for (const double size : {0.5, 0.1}) {
    const Options options{.size = size};
    const double n = static_cast<double>(mesh_of(plate(), options).quads.size());
    EXPECT_NEAR(estimate(plate(), options, context).quads, n, 0.2 * n);
  }
}

TEST(Estimate, LooksAtTheSizeFunction) {
  Context context;
  const Options options{.size_at = [](Point p) { return p.x < 3 ? 0.2 : 0.5; }};
  const double n = static_cast<double>(mesh_of(plate(), options).quads.size());
  EXPECT_GT(n, 300);
  EXPECT_NEAR(estimate(plate(), options, context).quads, n, 0.2 * n);
}

TEST(Verify, KeepsItsOwnMeshAndGivesTheSizes) {
  Context context;
  const Mesh mesh = mesh_of(plate());
  const Verification found = verify(mesh, plate(), {}, context);
  EXPECT_FALSE(found.broken) << found.broken->reason;
  EXPECT_EQ(found.edge_sizes, edge_sizes(mesh, plate(), {}, context));
  EXPECT_EQ(found.edge_sizes.size(), edges_of(mesh).size());
}

TEST(Verify, NeedsNoSizeAndThenGivesNone) {
  Context context;
  Model model = plate();
  const Mesh mesh = mesh_of(model);
  model.size = 0;
  const Verification found = verify(mesh, model, {}, context);
  EXPECT_FALSE(found.broken);
  EXPECT_TRUE(found.edge_sizes.empty());
}

TEST(Verify, SeesWhatTheMeshBreaks) {
  Context context;
  Mesh mesh = mesh_of(plate());
  Model other = plate();
  other.lines[0].path.items = {{{0, 2.2}}, {{6, 2.2}}};
  EXPECT_TRUE(verify(mesh, other, {}, context).broken);  // no edges along the line
  mesh.quads.pop_back();
  mesh.quad_region.pop_back();
  EXPECT_TRUE(verify(mesh, plate(), {}, context).broken);  // a hole
}

TEST(Verify, RefusesArraysThatDoNotFit) {
  Context context;
  const auto code_of = [&](const Mesh& mesh) {
    try {
      verify(mesh, plate(), {}, context);
    } catch (const InputError& error) {
      return error.code();
    }
    return ErrorCode::Internal;
  };
  Mesh mesh = mesh_of(plate());
  mesh.points[3].x = std::nan("");
  EXPECT_EQ(code_of(mesh), ErrorCode::InvalidMesh);
  mesh = mesh_of(plate());
  mesh.quads[0][2] = static_cast<NodeIndex>(mesh.points.size());
  EXPECT_EQ(code_of(mesh), ErrorCode::InvalidMesh);
}

}  // namespace
}  // namespace quadline
