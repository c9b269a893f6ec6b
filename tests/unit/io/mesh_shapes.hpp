#pragma once

#include <cmath>
#include <numbers>

#include "quadline/mesh.hpp"

namespace quadline::shapes {

/// A plate of 2 nx x ny quads over 0..4 x 0..2: two regions side by side, a line between them that a second line
/// follows half-way before it goes on along the upper edge, points at a corner and inside the line.
inline Mesh plate_with_lines(NodeIndex nx = 2, NodeIndex ny = 2) {
  Mesh mesh;
  const NodeIndex n_columns = 2 * nx + 1;
  const auto node = [&](NodeIndex i, NodeIndex j) { return j * n_columns + i; };
  for (NodeIndex j = 0; j <= ny; ++j)
    for (NodeIndex i = 0; i < n_columns; ++i)
      mesh.points.push_back({2.0 * i / nx + 0.1 * (i % 2) * (j % 2), 2.0 * j / ny + 1.0 / 3 * (i % 2) * (j % 2) / ny});
  for (NodeIndex j = 0; j < ny; ++j) {
    for (NodeIndex i = 0; i + 1 < n_columns; ++i) {
      mesh.quads.push_back({node(i, j), node(i + 1, j), node(i + 1, j + 1), node(i, j + 1)});
      mesh.quad_region.push_back(i < nx ? 1 : 0);
    }
  }
  mesh.regions = {"domain", "left"};
  EdgeSet outer{"outer-1", CurveKind::Outer, {}};
  for (NodeIndex i = 0; i + 1 < n_columns; ++i) outer.edges.push_back({node(i, 0), node(i + 1, 0)});
  for (NodeIndex j = 0; j < ny; ++j) outer.edges.push_back({node(2 * nx, j), node(2 * nx, j + 1)});
  for (NodeIndex i = n_columns - 1; i > 0; --i) outer.edges.push_back({node(i, ny), node(i - 1, ny)});
  for (NodeIndex j = ny; j > 0; --j) outer.edges.push_back({node(0, j), node(0, j - 1)});
  EdgeSet middle{"middle", CurveKind::Line, {}};
  for (NodeIndex j = 0; j < ny; ++j) middle.edges.push_back({node(nx, j), node(nx, j + 1)});
  EdgeSet bent{"bent", CurveKind::Line, {}};
  for (NodeIndex j = ny / 2; j < ny; ++j) bent.edges.push_back({node(nx, j), node(nx, j + 1)});
  for (NodeIndex i = nx; i > 0; --i) bent.edges.push_back({node(i, ny), node(i - 1, ny)});
  mesh.curves = {outer, middle, bent};
  mesh.node_sets = {{"corner", {node(0, 0)}}, {"load", {node(nx, ny / 2)}}};
  return mesh;
}

/// A ring of n x 2 quads between radius 1 and 3 with a closed line loop at radius 2.
inline Mesh ring(NodeIndex n = 12) {
  Mesh mesh;
  for (NodeIndex j = 0; j <= 2; ++j) {
    for (NodeIndex i = 0; i < n; ++i) {
      const double angle = 2 * std::numbers::pi * i / n;
      mesh.points.push_back({(1.0 + j) * std::cos(angle), (1.0 + j) * std::sin(angle)});
    }
  }
  const auto node = [&](NodeIndex i, NodeIndex j) { return j * n + i % n; };
  for (NodeIndex j = 0; j < 2; ++j) {
    for (NodeIndex i = 0; i < n; ++i) {
      mesh.quads.push_back({node(i, j), node(i, j + 1), node(i + 1, j + 1), node(i + 1, j)});
      mesh.quad_region.push_back(0);
    }
  }
  mesh.regions = {"domain"};
  mesh.curves = {{"outer-1", CurveKind::Outer, {}}, {"hole-1", CurveKind::Hole, {}}, {"girder", CurveKind::Line, {}}};
  for (NodeIndex i = 0; i < n; ++i) {
    mesh.curves[0].edges.push_back({node(i, 2), node(i + 1, 2)});
    mesh.curves[1].edges.push_back({node(i, 0), node(i + 1, 0)});
    mesh.curves[2].edges.push_back({node(i, 1), node(i + 1, 1)});
  }
  return mesh;
}

/// Two triangles and a quad, as a snapshot of a stage that has not merged all triangles.
inline Mesh mixed() {
  Mesh mesh;
  mesh.points = {{0, 0}, {1, 0}, {2, 0}, {0, 1}, {1, 1}, {2, 1}};
  mesh.quads = {{0, 1, 4, 3}};
  mesh.triangles = {{1, 2, 5}, {1, 5, 4}};
  mesh.quad_region = {0};
  mesh.triangle_region = {0, 0};
  mesh.regions = {"domain"};
  return mesh;
}

}  // namespace quadline::shapes
