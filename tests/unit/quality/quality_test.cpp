#include "quadline/quality.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

#include "cells/flatten.hpp"
#include "unit/grid_patch.hpp"

namespace quadline {
namespace {

Mesh flat(const shapes::PatchPlan& plan) {
  const shapes::Patch patch = shapes::patch(plan);
  return flatten(patch.mesh, patch.domain);
}

TEST(Verdict, FollowsTableTwo) {
  EXPECT_EQ(verdict(1), "excellent");
  EXPECT_EQ(verdict(0.72), "excellent");
  EXPECT_EQ(verdict(0.71), "good");
  EXPECT_EQ(verdict(0.54), "good");
  EXPECT_EQ(verdict(0.53), "marginal");
  EXPECT_EQ(verdict(0.36), "marginal");
  EXPECT_EQ(verdict(0.35), "unacceptable");
  EXPECT_EQ(verdict(0), "unacceptable");
}

TEST(EdgesOf, NamesEveryEdgeOnceInAscendingOrder) {
  Mesh mesh;
  mesh.points = {{0, 0}, {1, 0}, {1, 1}, {0, 1}, {2, 0}};
  mesh.quads = {{2, 3, 0, 1}};
  mesh.triangles = {{4, 2, 1}};
  const std::vector<std::array<NodeIndex, 2>> expected{{0, 1}, {0, 3}, {1, 2}, {1, 4}, {2, 3}, {2, 4}};
  EXPECT_EQ(edges_of(mesh), expected);
}

TEST(Measure, AGridIsPerfect) {
  const Quality q = measure(flat({.nx = 5, .ny = 3}));
  EXPECT_EQ(q.n_nodes, 24u);
  EXPECT_EQ(q.n_quads, 15u);
  EXPECT_EQ(q.n_triangles, 0u);
  EXPECT_EQ(q.n_inverted, 0u);
  EXPECT_EQ(q.n_irregular, 0u);
  EXPECT_NEAR(q.beta_mean, 1, 1e-12);
  EXPECT_NEAR(q.beta_min, 1, 1e-12);
  EXPECT_NEAR(q.scaled_jacobian.min, 1, 1e-12);
  EXPECT_NEAR(q.min_angle_deg.min, 90, 1e-9);
  EXPECT_NEAR(q.max_angle_deg.max, 90, 1e-9);
  EXPECT_NEAR(q.aspect.max, 1, 1e-12);
  EXPECT_NEAR(q.edge_length.mean, 1, 1e-12);
  EXPECT_FALSE(q.edge_to_size);
}

TEST(Measure, NothingOfNothing) {
  const Quality q = measure(Mesh{});
  EXPECT_EQ(q.n_quads, 0u);
  EXPECT_EQ(q.beta_mean, 0);
  EXPECT_EQ(q.edge_length.max, 0);
}

TEST(Measure, TheMeanOfBetaIsGeometric) {
  Mesh mesh;  // a square and a rhombus of 60 degrees, which has 0.36
  const double y = std::sqrt(0.75);
  mesh.points = {{0, 0}, {1, 0}, {1, 1}, {0, 1}, {5, 0}, {6, 0}, {6.5, y}, {5.5, y}};
  mesh.quads = {{0, 1, 2, 3}, {4, 5, 6, 7}};
  const Quality q = measure(mesh);
  EXPECT_NEAR(q.beta_mean, 0.6, 1e-12);
  EXPECT_NEAR(q.beta_min, 0.36, 1e-12);
  EXPECT_NEAR(q.scaled_jacobian.mean, 0.5 * (1 + y), 1e-12);
  EXPECT_NEAR(q.min_angle_deg.min, 60, 1e-9);
  EXPECT_NEAR(q.max_angle_deg.max, 120, 1e-9);
  EXPECT_NEAR(distortion(mesh.points[4], mesh.points[5], mesh.points[6], mesh.points[7]), 0.36, 1e-12);
}

TEST(Measure, CountsWhatIsNotConvex) {
  Mesh mesh = flat({.nx = 2, .ny = 2});
  mesh.points[4] = {1.6, 1.6};
  EXPECT_EQ(measure(mesh).n_inverted, 1u);
  mesh.points[4] = {1, 1};
  std::swap(mesh.quads[0][1], mesh.quads[0][3]);
  const Quality q = measure(mesh);
  EXPECT_EQ(q.n_inverted, 1u);
  EXPECT_EQ(q.beta_min, 0);
  EXPECT_NEAR(q.scaled_jacobian.min, -1, 1e-12);
}

TEST(Measure, StatisticsLieBetweenNeighbours) {
  Mesh mesh;  // 101 rectangles with aspects 1, 2, ... 101
  for (int i = 0; i <= 100; ++i) {
    const double y = 2 * i;
    const NodeIndex n = static_cast<NodeIndex>(mesh.points.size());
    mesh.points.insert(mesh.points.end(), {{0, y}, {1.0 + i, y}, {1.0 + i, y + 1}, {0, y + 1}});
    mesh.quads.push_back({n, n + 1, n + 2, n + 3});
  }
  const Statistics s = measure(mesh).aspect;
  EXPECT_NEAR(s.min, 1, 1e-12);
  EXPECT_NEAR(s.p1, 2, 1e-12);
  EXPECT_NEAR(s.p5, 6, 1e-12);
  EXPECT_NEAR(s.median, 51, 1e-12);
  EXPECT_NEAR(s.mean, 51, 1e-12);
  EXPECT_NEAR(s.p95, 96, 1e-12);
  EXPECT_NEAR(s.p99, 100, 1e-12);
  EXPECT_NEAR(s.max, 101, 1e-12);
  mesh.quads.resize(3);
  EXPECT_NEAR(measure(mesh).aspect.p95, 2.9, 1e-12);
  EXPECT_NEAR(measure(mesh).aspect.p1, 1.02, 1e-12);
}

TEST(Measure, EdgeLengthOverSize) {
  const Mesh mesh = flat({.nx = 3, .ny = 2});
  const std::vector<double> size(edges_of(mesh).size(), 2.0);
  const Quality q = measure(mesh, size);
  ASSERT_TRUE(q.edge_to_size);
  EXPECT_NEAR(q.edge_to_size->min, 0.5, 1e-12);
  EXPECT_NEAR(q.edge_to_size->mean, 0.5, 1e-12);
}

// Four columns of widths 1, 1, 2 and 3 in a row: growth 1, 2 and 1.5 from each to the next.
Mesh growing_row() {
  Mesh mesh;
  for (const double x : {0, 1, 2, 4, 7}) mesh.points.insert(mesh.points.end(), {{x, 0}, {x, 1}});
  mesh.quads = {{0, 2, 3, 1}, {2, 4, 5, 3}, {4, 6, 7, 5}, {6, 8, 9, 7}};
  return mesh;
}

TEST(Measure, GrowthIsTheRatioOfWidthsAcrossASharedEdge) {
  const Quality q = measure(growing_row());
  EXPECT_NEAR(q.growth.min, 1, 1e-12);
  EXPECT_NEAR(q.growth.median, 1.5, 1e-12);
  EXPECT_NEAR(q.growth.max, 2, 1e-12);
  EXPECT_EQ(q.n_growth_over, 1u);  // one at the limit passes
  const std::vector<double> expected{1, 2, 2, 1.5};
  EXPECT_EQ(growth_of_quads(growing_row()), expected);
}

TEST(Measure, GrowthLooksAcrossTheEdgeNotAlongIt) {
  Mesh mesh = flat({.nx = 3, .ny = 2});
  for (Point& p : mesh.points) p.y *= 7;  // slender quads, but every neighbour is alike
  EXPECT_NEAR(measure(mesh).growth.max, 1, 1e-12);
}

TEST(Irregular, FourOddNodesWhereAnEdgeIsTurned) {
  EXPECT_EQ(measure(flat({.nx = 6, .ny = 5, .turned = {{2, 2}}})).n_irregular, 4u);
}

TEST(Irregular, ReentrantCornersAndHolesOfAGridAreRegular) {
  EXPECT_EQ(measure(flat({.keep = [](int i, int j) { return i < 2 || j < 2; }})).n_irregular, 0u);
  EXPECT_EQ(measure(flat({.nx = 5, .ny = 5, .keep = [](int i, int j) { return i != 2 || j != 2; }})).n_irregular, 0u);
}

TEST(Irregular, TheEndOfALineWantsFourQuads) {
  EXPECT_EQ(measure(flat({.nx = 6, .ny = 4, .lines = {{{{1, 2}, {5, 2}}}}})).n_irregular, 0u);
}

// A node with four quads, one above it and three below: regular, unless a line runs through it.
TEST(Irregular, EachSideOfALineCounts) {
  Mesh mesh;
  mesh.points = {{0, 0}, {1, 0}, {0, 1.5}, {-1, 0}, {-1, -1}, {-0.4, -1}, {0, -2}, {0.4, -1}, {1, -1}};
  mesh.quads = {{0, 1, 2, 3}, {0, 3, 4, 5}, {0, 5, 6, 7}, {0, 7, 8, 1}};
  const Quality without = measure(mesh);
  mesh.curves = {{"line", CurveKind::Line, {{3, 0}, {0, 1}}}};
  EXPECT_EQ(measure(mesh).n_irregular, without.n_irregular + 1);
}

const LineQuality& the_line(const std::vector<LineQuality>& lines) {
  for (const LineQuality& line : lines)
    if (line.kind == CurveKind::Line) return line;
  throw std::logic_error("no line");
}

TEST(MeasureLines, OnAGridALineIsPerfect) {
  const Mesh mesh = flat({.nx = 6, .ny = 4, .lines = {{{{1, 2}, {5, 2}}}}});
  const auto lines = measure_lines(mesh);
  ASSERT_EQ(lines.size(), 2u);  // the loop, then the line
  EXPECT_EQ(lines[0].n_edges, 20u);
  EXPECT_EQ(lines[0].n_quads, 16u);
  EXPECT_NEAR(lines[0].off_normal_deg.value(), 0, 1e-9);
  const LineQuality line = the_line(lines);
  EXPECT_EQ(line.name, "line-1");
  EXPECT_EQ(line.n_edges, 4u);
  EXPECT_EQ(line.n_quads, 12u);
  EXPECT_EQ(line.n_irregular, 0u);
  EXPECT_NEAR(line.beta_min, 1, 1e-12);
  EXPECT_NEAR(line.scaled_jacobian_min, 1, 1e-12);
  EXPECT_NEAR(line.off_normal_deg.value(), 0, 1e-9);  // the edge ahead of an end is no rung
  EXPECT_FALSE(line.edge_to_size);
}

TEST(MeasureLines, AShearShowsInTheRungsAndTheLengthInTheSize) {
  Mesh mesh = flat({.nx = 6, .ny = 4, .lines = {{{{1, 2}, {5, 2}}}}});
  for (Point& p : mesh.points) p = {p.x + 0.5 * p.y, p.y};
  std::vector<double> size;
  for (const auto& edge : edges_of(mesh)) size.push_back(mesh.points[edge[0]].x < 2.5 ? 2 : 1);
  const LineQuality line = the_line(measure_lines(mesh, size));
  const double off = std::atan(0.5) * 180 / std::numbers::pi;
  EXPECT_NEAR(line.off_normal_deg.value(), off, 1e-9);
  EXPECT_NEAR(line.min_angle_deg, 90 - off, 1e-9);
  EXPECT_NEAR(line.max_angle_deg, 90 + off, 1e-9);
  EXPECT_NEAR(line.scaled_jacobian_mean, std::cos(std::atan(0.5)), 1e-12);
  EXPECT_NEAR(line.edge_to_size.value().min, 0.5, 1e-12);  // only its first edge starts left of 2.5
  EXPECT_NEAR(line.edge_to_size.value().max, 1, 1e-12);
  EXPECT_NEAR(line.edge_to_size.value().mean, 0.875, 1e-12);
}

TEST(MeasureLines, IrregularNodesCountWhereTheyAre) {
  // A turned edge beside the line leaves odd nodes on it, one away from it none.
  const shapes::Spot beside{2, 2}, away{2, 0};
  const std::vector<std::array<shapes::Spot, 2>> line{{{{1, 2}, {5, 2}}}};
  EXPECT_EQ(the_line(measure_lines(flat({.nx = 6, .ny = 5, .lines = line, .turned = {beside}}))).n_irregular, 2u);
  EXPECT_EQ(the_line(measure_lines(flat({.nx = 6, .ny = 5, .lines = line, .turned = {away}}))).n_irregular, 0u);
}

}  // namespace
}  // namespace quadline
