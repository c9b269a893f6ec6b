#include "stages/smooth/smooth.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "cells/flatten.hpp"
#include "quadline/quality.hpp"
#include "stages/verify/verify.hpp"
#include "unit/grid_patch.hpp"

namespace quadline {
namespace {

using shapes::least_jacobian;
using shapes::Patch;
using shapes::PatchPlan;

void smoothed(Patch& patch, const SmoothOptions& options = {}) {
  Context context;
  smooth(patch.mesh, patch.domain, patch.size(), options, context);
}

std::string broken_promise(const Patch& patch) {
  Context context;
  const std::optional<Failure> failure = verify(flatten(patch.mesh, patch.domain), patch.domain, context);
  return failure ? failure->reason : "";
}

double beta_mean(const Patch& patch) { return measure(flatten(patch.mesh, patch.domain)).beta_mean; }

const auto is_l_shaped = [](int i, int j) { return i < 4 || j < 4; };
const auto is_frame = [](int i, int j) { return i < 3 || j < 3 || i > 5 || j > 5; };

TEST(Smooth, LeavesAGridAlone) {
  Patch patch = shapes::patch({.nx = 6, .ny = 4});
  const std::vector<Point> before = flatten(patch.mesh, patch.domain).points;
  smoothed(patch);
  EXPECT_EQ(flatten(patch.mesh, patch.domain).points, before);
}

TEST(Smooth, NoPassesNoMoves) {
  Patch patch = shapes::patch({.nx = 6, .ny = 4});
  shapes::shake(patch, 0.3, 1);
  const std::vector<Point> before = flatten(patch.mesh, patch.domain).points;
  smoothed(patch, {.passes = 0});
  EXPECT_EQ(flatten(patch.mesh, patch.domain).points, before);
}

TEST(Smooth, AShakenGridBecomesAGrid) {
  Patch patch = shapes::patch({.nx = 8, .ny = 6});
  shapes::shake(patch, 0.3, 1, 0.3);
  smoothed(patch);
  EXPECT_EQ(broken_promise(patch), "");
  EXPECT_GT(beta_mean(patch), 0.97);
  for (const auto& [spot, v] : patch.node_at)
    EXPECT_LT(distance(patch.mesh.point(v), {double(spot[0]), double(spot[1])}), 0.1) << spot[0] << " " << spot[1];
}

TEST(Smooth, RaisesBetaAtIrregularNodes) {
  Patch patch = shapes::patch({.nx = 10, .ny = 9, .turned = {{2, 2}, {6, 5}}});
  smoothed(patch);
  EXPECT_EQ(broken_promise(patch), "");
  EXPECT_GT(beta_mean(patch), 0.89);  // 0.87 without the polish, 0.91 without its term for rows
  EXPECT_GE(least_jacobian(patch.mesh), 0.84 - 1e-9);
}

// Rows that end at a turned quad crowd beside it; without a term for them the greatest growth is 1.62.
TEST(Smooth, EvensOutTheRowsBesideIrregularNodes) {
  Patch patch = shapes::patch({.nx = 10, .ny = 9, .turned = {{2, 2}, {6, 5}}});
  smoothed(patch);
  EXPECT_LT(measure(flatten(patch.mesh, patch.domain)).growth.max, 1.5);
}

TEST(Smooth, MovesNodesTowardsTheCallersLimits) {
  Criteria criteria;
  criteria.min_jacobian_ratio = 0.6;
  const auto failing = [&](const SmoothOptions& options) {
    Patch patch = shapes::patch({.nx = 10, .ny = 9, .turned = {{2, 2}, {6, 5}}});
    smoothed(patch, options);
    EXPECT_EQ(broken_promise(patch), "");
    EXPECT_GE(least_jacobian(patch.mesh), 0.84 - 1e-9);
    return evaluate(flatten(patch.mesh, patch.domain), criteria).n_failing;
  };
  EXPECT_GT(failing({}), 0u);
  EXPECT_EQ(failing({.criteria = criteria}), 0u);
}

TEST(Smooth, LimitsThatHoldMoveNothing) {
  Criteria criteria;
  criteria.max_aspect = 50;
  Patch plain = shapes::patch({.nx = 10, .ny = 9, .turned = {{2, 2}, {6, 5}}}), aimed = plain;
  smoothed(plain);
  smoothed(aimed, {.criteria = criteria});
  EXPECT_EQ(flatten(plain.mesh, plain.domain).points, flatten(aimed.mesh, aimed.domain).points);
}

TEST(Smooth, ConstraintsLieWhereTheyLay) {
  Patch patch = shapes::patch({.nx = 9, .ny = 9, .keep = is_frame, .lines = {{{{1, 1}, {8, 1}}}}, .points = {{7, 7}}});
  shapes::shake(patch, 0.3, 3, 0.3);
  smoothed(patch);
  EXPECT_EQ(broken_promise(patch), "");  // looks at lines, boundaries and points
  for (const auto& [spot, v] : patch.node_at) {
    const NodeTag& tag = patch.mesh.tag(v);
    if (tag.kind != NodeKind::OnCurve) continue;
    EXPECT_EQ(patch.mesh.point(v), point_at(patch.domain.curves[tag.curve].piece, tag.s));
  }
}

TEST(Smooth, NodesOnCurvesSlide) {
  Patch patch = shapes::patch({.nx = 9, .ny = 4, .lines = {{{{1, 2}, {8, 2}}}}});
  shapes::shake(patch, 0, 5, 0.35);
  smoothed(patch);
  for (int i = 2; i < 8; ++i) EXPECT_NEAR(patch.mesh.point(patch.node(i, 2)).x, i, 0.05);
  for (int i = 1; i < 9; ++i) EXPECT_NEAR(patch.mesh.point(patch.node(i, 0)).x, i, 0.05);
}

TEST(Smooth, NeverHarmsTheWorstElement) {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    Patch patch = shapes::patch({.nx = 8, .ny = 8, .keep = is_l_shaped, .turned = {{1, 1}, {4, 2}}});
    shapes::shake(patch, 0.25, seed, 0.2);
    const double before = least_jacobian(patch.mesh);
    smoothed(patch);
    EXPECT_GE(least_jacobian(patch.mesh), std::fmin(before, 0.84) - 1e-9) << seed;
  }
}

// Meshes that are better than the floor when they come: beta would rise further below it.
TEST(Smooth, LeavesNoElementBelowTheFloor) {
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    Patch patch = shapes::patch({.nx = 10, .ny = 9, .turned = {{2, 2}, {6, 5}}});
    smoothed(patch);
    shapes::shake(patch, 0.02, seed, 0.02);
    smoothed(patch, {.passes = 30});
    EXPECT_GE(least_jacobian(patch.mesh), 0.84 - 1e-9) << seed;
    EXPECT_LT(least_jacobian(patch.mesh), 0.85) << seed;  // it is what holds them
  }
}

TEST(Untangle, ANodeThatLiesFarOff) {
  Patch patch = shapes::patch({.nx = 5, .ny = 5});
  patch.mesh.move(patch.node(2, 2), {4.5, 3.7});
  EXPECT_LT(least_jacobian(patch.mesh), 0);
  smoothed(patch);
  EXPECT_GT(least_jacobian(patch.mesh), 0.98);
}

TEST(Untangle, NodesThrownAboutInAnLShape) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    Patch patch = shapes::patch({.nx = 9, .ny = 9, .keep = is_l_shaped, .turned = {{1, 6}, {5, 1}}});
    shapes::shake(patch, 3, seed, 0.3);
    EXPECT_LT(least_jacobian(patch.mesh), 0);
    smoothed(patch);
    EXPECT_EQ(broken_promise(patch), "") << seed;
    EXPECT_GT(least_jacobian(patch.mesh), 0.6) << seed;
  }
}

TEST(Untangle, NodesThrownAboutRoundAHoleAndALine) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    Patch patch = shapes::patch({.nx = 9, .ny = 9, .keep = is_frame, .lines = {{{{1, 1}, {1, 8}}}}});
    shapes::shake(patch, 2, seed, 0.3);
    smoothed(patch);
    EXPECT_EQ(broken_promise(patch), "") << seed;
  }
}

TEST(Untangle, MendsWhatLiesBesideAHopelessQuad) {
  // A node with two quads only, in the middle of what was one: they cannot both be convex.
  Patch patch = shapes::patch({.nx = 4, .ny = 4});
  const NodeId a = patch.node(2, 2), b = patch.node(3, 2), c = patch.node(3, 3), d = patch.node(2, 3);
  const NodeId doublet = patch.mesh.add_node({2.5, 2.5});
  const Topology& topo = patch.mesh.topo();
  const std::array<FaceId, 1> cavity{topo.face(topo.find(a, b))};
  const std::array<Polygon, 2> pair{Polygon(a, b, doublet, d), Polygon(b, c, d, doublet)};
  std::vector<FaceId> made;
  patch.mesh.replace_cavity(cavity, pair, made);
  shapes::shake(patch, 1, 4);
  smoothed(patch);
  int n_hopeless = 0;
  for (std::size_t i = 0; i < topo.face_capacity(); ++i) {
    if (!topo.is_live(FaceId(i))) continue;
    const bool is_of_pair = FaceId(i) == made[0] || FaceId(i) == made[1];
    const double jacobian = scaled_jacobian(patch.mesh.quad_points(FaceId(i)));
    if (is_of_pair) n_hopeless += jacobian <= 0.1;
    EXPECT_TRUE(is_of_pair || jacobian > 0.1) << i;
  }
  EXPECT_GE(n_hopeless, 1);
}

// A ring of `n` by `rings` quads between the radii 1 and 2; both circles are two half circles.
Patch ring(int n, int rings) {
  Patch patch;
  Domain& domain = patch.domain;
  domain.cells.push_back({});
  domain.cells[CellId(0)].size = 0.4;
  domain.size = 0.4;
  domain.regions = {"domain"};
  domain.box = {{-2, -2}, {2, 2}};
  domain.tolerance = 1e-7;
  constexpr double kNone = std::numeric_limits<double>::infinity();
  constexpr double kPi = 3.14159265358979323846;
  for (const double r : {2.0, 1.0}) {
    const VertexId right = domain.vertices.push_back({{r, 0}}), left = domain.vertices.push_back({{-r, 0}});
    const bool is_outer = r == 2;
    Domain::Path path{is_outer ? "outer-1" : "hole-1", is_outer ? CurveKind::Outer : CurveKind::Hole, {}};
    for (const double side : {1.0, -1.0}) {
      Domain::Curve curve;
      curve.tail = side > 0 ? right : left;
      curve.head = side > 0 ? left : right;
      curve.piece = arc_through({side * r, 0}, {0, side * r}, {-side * r, 0});
      (is_outer ? curve.left : curve.right) = CellId(0);
      curve.size = kNone;
      path.curves.push_back({domain.curves.push_back(curve)});
    }
    domain.cells[CellId(0)].walks.push_back(path.curves);
    domain.paths.push_back(path);
  }
  std::vector<Point> points;
  std::vector<NodeTag> tags;
  std::vector<Polygon> quads;
  const auto node = [&](int i, int k) { return NodeId(static_cast<std::size_t>(k * n + i % n)); };
  for (int k = 0; k <= rings; ++k) {
    for (int i = 0; i < n; ++i) {
      const double r = 1 + static_cast<double>(k) / rings, angle = 2 * kPi * i / n;
      NodeTag tag;
      Point p{r * std::cos(angle), r * std::sin(angle)};
      if (k == 0 || k == rings) {
        const std::size_t circle = k == 0 ? 2 : 0;
        if (2 * i % n == 0) {
          tag.kind = NodeKind::Fixed;
          tag.vertex = VertexId(circle + (i == 0 ? 0 : 1));
          p = domain.vertices[tag.vertex].at;
        } else {
          tag.kind = NodeKind::OnCurve;
          tag.curve = CurveId(circle + (2 * i < n ? 0 : 1));
          tag.s = r * (2 * i < n ? angle : angle - kPi);
        }
      }
      points.push_back(p);
      tags.push_back(tag);
      if (k > 0) quads.emplace_back(node(i, k - 1), node(i, k), node(i + 1, k), node(i + 1, k - 1));
    }
  }
  patch.mesh.build(points, tags, quads);
  for (std::size_t i = 0; i < quads.size(); ++i) patch.mesh.set_cell(FaceId(i), CellId(0));
  for (const int k : {0, rings})
    for (int i = 0; i < n; ++i)
      patch.mesh.set_curve(edge_of(patch.mesh.topo().find(node(i, k), node(i + 1, k))),
                           CurveId((k == 0 ? 2 : 0) + (2 * i < n ? 0 : 1)));
  return patch;
}

TEST(Smooth, NodesOnArcsStayAtTheirPlaces) {
  Patch patch = ring(24, 4);
  shapes::shake(patch, 0.08, 7);
  std::vector<double> places;
  std::vector<Point> before;
  for (std::size_t i = 0; i < patch.mesh.topo().node_capacity(); ++i) {
    places.push_back(patch.mesh.tag(NodeId(i)).s);
    before.push_back(patch.mesh.point(NodeId(i)));
  }
  smoothed(patch);
  EXPECT_EQ(broken_promise(patch), "");
  EXPECT_GT(beta_mean(patch), 0.7);
  int n_on_arcs = 0;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const NodeTag& tag = patch.mesh.tag(NodeId(i));
    if (tag.kind != NodeKind::OnCurve) continue;
    ++n_on_arcs;
    EXPECT_EQ(tag.s, places[i]);
    EXPECT_EQ(patch.mesh.point(NodeId(i)), before[i]);
  }
  EXPECT_EQ(n_on_arcs, 44);
}

TEST(Smooth, ScaledInputGivesTheScaledMeshBitForBit) {
  PatchPlan plan{.nx = 7, .ny = 6, .keep = [](int i, int j) { return i != 3 || j != 3; }, .turned = {{1, 1}}};
  Patch one = shapes::patch(plan);
  plan.h = 1024;
  Patch large = shapes::patch(plan);
  shapes::shake(one, 0.3, 11, 0.3);
  shapes::shake(large, 1024 * 0.3, 11, 1024 * 0.3);
  smoothed(one);
  smoothed(large);
  const std::vector<Point> small = flatten(one.mesh, one.domain).points;
  const std::vector<Point> big = flatten(large.mesh, large.domain).points;
  ASSERT_EQ(small.size(), big.size());
  for (std::size_t i = 0; i < small.size(); ++i) EXPECT_EQ(1024 * small[i], big[i]) << i;
}

TEST(Smooth, ReportsProgressFromNothingToAll) {
  Patch patch = shapes::patch({.nx = 6, .ny = 6, .turned = {{2, 2}}});
  shapes::shake(patch, 3, 1);
  std::vector<double> parts;
  Context context;
  context.on_progress = [&](std::string_view stage, double part) {
    EXPECT_EQ(stage, "smooth");
    parts.push_back(part);
  };
  smooth(patch.mesh, patch.domain, patch.size(), {}, context);
  ASSERT_GT(parts.size(), 10u);
  EXPECT_TRUE(std::is_sorted(parts.begin(), parts.end()));
  EXPECT_EQ(parts.front(), 0);
  EXPECT_EQ(parts.back(), 1);
}

TEST(Smooth, CancelledItLeavesTheMeshAsItWas) {
  Patch patch = shapes::patch({.nx = 5, .ny = 5});
  shapes::shake(patch, 0.3, 1);
  const std::vector<Point> before = flatten(patch.mesh, patch.domain).points;
  Context context;
  int n_asked = 0;
  context.is_cancelled = [&] { return ++n_asked == 8; };
  EXPECT_THROW(smooth(patch.mesh, patch.domain, patch.size(), {}, context), Cancelled);
  EXPECT_EQ(flatten(patch.mesh, patch.domain).points, before);
}

}  // namespace
}  // namespace quadline
