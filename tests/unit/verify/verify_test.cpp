#include "stages/verify/verify.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "cells/flatten.hpp"
#include "unit/grid_patch.hpp"

namespace quadline {
namespace {

// A plate with a hole, an open line and a named point; each test breaks one promise.
class Verify : public testing::Test {
 protected:
  Verify()
      : patch_(shapes::patch({.nx = 6,
                              .ny = 6,
                              .keep = [](int i, int j) { return i != 4 || j != 4; },
                              .lines = {{{{1, 2}, {5, 2}}}},
                              .points = {{2, 4}}})),
        mesh_(flatten(patch_.mesh, patch_.domain)) {}

  std::string reason() const {
    Context context;
    const std::optional<Failure> failure = verify(mesh_, patch_.domain, context);
    EXPECT_TRUE(!failure || failure->stage == "verify");
    return failure ? failure->reason : "";
  }
  NodeIndex at(double x, double y) const {
    for (std::size_t i = 0; i < mesh_.points.size(); ++i)
      if (mesh_.points[i] == Point{x, y}) return static_cast<NodeIndex>(i);
    throw std::out_of_range("no such node");
  }
  EdgeSet& line() { return mesh_.curves.back(); }

  shapes::Patch patch_;
  Mesh mesh_;
};

TEST_F(Verify, FindsNothingWrongWithAGrid) { EXPECT_EQ(reason(), ""); }

TEST_F(Verify, MovedInnerNodesAreFine) {
  mesh_.points[at(3, 1)] = {3.2, 1.3};
  EXPECT_EQ(reason(), "");
}

TEST_F(Verify, Triangle) {
  mesh_.triangles.push_back({0, 1, 2});
  EXPECT_EQ(reason(), "a triangle is left");
}

TEST_F(Verify, NoQuads) {
  mesh_.quads.clear();
  EXPECT_EQ(reason(), "the mesh has no quads");
}

TEST_F(Verify, QuadThatIsNotConvex) {
  mesh_.points[at(3, 1)] = {3.7, 1.6};
  EXPECT_EQ(reason(), "a quad is not convex");
}

TEST_F(Verify, ClockwiseQuad) {
  std::swap(mesh_.quads[3][0], mesh_.quads[3][2]);
  EXPECT_EQ(reason(), "a quad is not convex");
}

TEST_F(Verify, QuadWithAStraightCorner) {
  mesh_.points[at(1, 1)] = {0.5, 0.5};
  EXPECT_EQ(reason(), "a quad is not convex");
}

// Each corner of a quad in the middle, drawn over the opposite one.
TEST_F(Verify, QuadWithAnyCornerReflex) {
  const auto quad = mesh_.quads[1];
  const Mesh whole = mesh_;
  for (std::size_t i = 0; i < 4; ++i) {
    mesh_.points.push_back(whole.points[quad[(i + 2) % 4]]);
    mesh_.points.back() += 0.3 * (whole.points[quad[(i + 2) % 4]] - whole.points[quad[i]]);
    mesh_.quads[1][i] = static_cast<NodeIndex>(whole.points.size());
    EXPECT_EQ(reason(), "a quad is not convex") << i;
    mesh_ = whole;
  }
}

TEST_F(Verify, QuadThatIsAlmostFlat) {
  mesh_.points[at(1, 1)] = {0.5, 0.5 + 1e-8};
  EXPECT_EQ(reason(), "a quad is flat");
}

TEST_F(Verify, NodeThatDoesNotExist) {
  for (const std::size_t v : {mesh_.points.size(), std::size_t{1000}}) {
    mesh_.quads[0][0] = static_cast<NodeIndex>(v);
    EXPECT_EQ(reason(), "a quad names a node that is not there") << v;
  }
}

TEST_F(Verify, NodeThatIsNotFinite) {
  mesh_.points[7].x = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(reason(), "a node has no finite coordinates");
  mesh_.points[7] = {1, std::numeric_limits<double>::infinity()};
  EXPECT_EQ(reason(), "a node has no finite coordinates");
}

TEST_F(Verify, NodeWithoutQuads) {
  mesh_.points.push_back({1.5, 1.5});
  EXPECT_EQ(reason(), "a node belongs to no quad");
}

// A crack: the quad to the right of a node gets a node of its own, in all directions and in all parts of the squares
// by which near ones are sought.
TEST_F(Verify, TwoNodesInOnePlace) {
  const NodeIndex old = at(3, 1);
  const double near = 0.01 * patch_.domain.tolerance;
  mesh_.points.push_back({});
  for (auto& q : mesh_.quads)
    if (q[0] == old) q[0] = static_cast<NodeIndex>(mesh_.points.size() - 1);
  mesh_.points.back() = {3, 1};
  EXPECT_EQ(reason(), "two nodes stand in one place");
  for (int i = 0; i < 16; ++i)
    for (int k = 0; k < 24; ++k) {
      const double angle = 0.2618 * k;
      mesh_.points[old] = {3 + 0.51 * near * (i % 8), 1 + 0.53 * near * (i / 2)};
      mesh_.points.back() = mesh_.points[old] + 0.99 * near * Point{std::cos(angle), std::sin(angle)};
      ASSERT_EQ(reason(), "two nodes stand in one place") << i << " " << k;
      mesh_.points.back() = mesh_.points[old] + 1.01 * near * Point{std::cos(angle), std::sin(angle)};
      ASSERT_NE(reason(), "two nodes stand in one place") << i << " " << k;
    }
}

TEST_F(Verify, Crack) {
  const NodeIndex old = at(3, 1);
  mesh_.points.push_back({3.01, 1.01});
  for (auto& q : mesh_.quads)
    if (q[0] == old) q[0] = static_cast<NodeIndex>(mesh_.points.size() - 1);
  EXPECT_EQ(reason(), "an edge inside the domain has only one quad");
}

TEST_F(Verify, MissingQuad) {
  mesh_.quads.erase(mesh_.quads.begin() + 19);
  mesh_.quad_region.pop_back();
  EXPECT_EQ(reason(), "an edge inside the domain has only one quad");
}

TEST_F(Verify, MissingQuadBesideALine) {
  const Mesh whole = mesh_;
  for (const int row : {1, 2}) {  // on its right, on its left
    mesh_ = whole;
    mesh_.quads.erase(mesh_.quads.begin() + 6 * row + 2);
    mesh_.quad_region.pop_back();
    EXPECT_EQ(reason(), "an edge of 'line-1' does not have its quads") << row;
  }
}

TEST_F(Verify, QuadTwice) {
  mesh_.quads.push_back(mesh_.quads[19]);
  mesh_.quad_region.push_back(0);
  EXPECT_EQ(reason(), "quads overlap at an edge");
}

TEST_F(Verify, FilledHole) {
  mesh_.quads.push_back({at(4, 4), at(5, 4), at(5, 5), at(4, 5)});
  mesh_.quad_region.push_back(0);
  EXPECT_EQ(reason(), "an edge of 'hole-1' does not have its quads");
}

TEST_F(Verify, VertexThatMovedByALittle) {
  mesh_.points[at(0, 0)].x = 1e-16;
  EXPECT_EQ(reason(), "a vertex of the domain is no node");
}

TEST_F(Verify, NodeOffItsCurve) {
  mesh_.points[at(3, 2)].y += 1e-3;
  EXPECT_EQ(reason(), "a node of 'line-1' lies off it");
}

TEST_F(Verify, NodeOnItsCurveWithinTheTolerance) {
  mesh_.points[at(3, 2)] = {3.2, 2 + 1e-9};
  EXPECT_EQ(reason(), "");
}

TEST_F(Verify, CurveOfAnotherNameOrKind) {
  line().name = "line-2";
  EXPECT_EQ(reason(), "'line-1' is missing");
  line().name = "line-1";
  line().kind = CurveKind::Hole;
  EXPECT_EQ(reason(), "'line-1' is missing");
}

// The same curve twice, under two names: its part of the area counts once.
TEST_F(Verify, CurveThatTwoPathsWalk) {
  patch_.domain.paths.push_back(patch_.domain.paths[0]);
  patch_.domain.paths.back().name = "ring";
  mesh_.curves.push_back(mesh_.curves[0]);
  mesh_.curves.back().name = "ring";
  EXPECT_EQ(reason(), "");
}

TEST_F(Verify, LineThatEndsEarly) {
  line().edges.pop_back();
  EXPECT_EQ(reason(), "'line-1' is not covered by edges to its end");
}

TEST_F(Verify, LineWithAGap) {
  line().edges.erase(line().edges.begin() + 1);
  EXPECT_EQ(reason(), "'line-1' has a gap");
}

TEST_F(Verify, LineWithoutMeshEdges) {
  line().edges = {{at(1, 2), at(3, 2)}, {at(3, 2), at(5, 2)}};
  EXPECT_EQ(reason(), "'line-1' has an edge that is no side of a quad");
}

TEST_F(Verify, LineThatRunsOn) {
  line().edges.push_back({at(5, 2), at(6, 2)});
  EXPECT_EQ(reason(), "'line-1' has edges too many");
}

TEST_F(Verify, LineThatTurnsBack) {
  const NodeIndex a = at(1, 2), b = at(2, 2), c = at(3, 2);
  line().edges.insert(line().edges.begin() + 2, {{c, b}, {b, c}});
  EXPECT_EQ(line().edges[0], (std::array<NodeIndex, 2>{a, b}));
  EXPECT_EQ(reason(), "the edges of 'line-1' run back");
}

TEST_F(Verify, MissingEdgeSet) {
  mesh_.curves.pop_back();
  EXPECT_EQ(reason(), "a curve is missing");
}

TEST_F(Verify, CurveThatNoPathWalks) {
  patch_.domain.paths.pop_back();
  mesh_.curves.pop_back();
  EXPECT_EQ(reason(), "a curve of the domain has no edges");
}

TEST_F(Verify, PointWithoutItsNode) {
  mesh_.node_sets[0].nodes[0] += 1;
  EXPECT_EQ(reason(), "point 'point-1' is no node");
}

TEST_F(Verify, PointOfAnotherName) {
  mesh_.node_sets[0].name = "point-2";
  EXPECT_EQ(reason(), "point 'point-1' is no node");
}

TEST_F(Verify, MissingPoint) {
  mesh_.node_sets.clear();
  EXPECT_EQ(reason(), "a named point is missing");
}

TEST_F(Verify, RegionsMustHaveTheirArea) {
  patch_.domain.regions.push_back("web");
  mesh_.regions.push_back("web");
  mesh_.quad_region[5] = 1;
  EXPECT_EQ(reason(), "the quads of region 'domain' do not add up to its area");
  mesh_.quad_region[5] = 2;
  EXPECT_EQ(reason(), "a quad names a region that is not there");
}

TEST_F(Verify, CancelsWhenAsked) {
  Context context;
  context.is_cancelled = [] { return true; };
  EXPECT_THROW((void)verify(mesh_, patch_.domain, context), Cancelled);
}

}  // namespace
}  // namespace quadline
