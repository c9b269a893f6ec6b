#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <vector>

#include "domain/size/size_field.hpp"
#include "mesh/delaunay.hpp"
#include "mesh/work_mesh.hpp"

namespace quadline::shapes {

using Edge = std::array<std::size_t, 2>;

/// A working mesh of one cell from points, faces (triangles and quads, counter-clockwise) and constraint edges.
inline WorkMesh mesh_of(const std::vector<Point>& points, const std::vector<std::vector<std::size_t>>& faces,
                        const std::vector<Edge>& constraints) {
  std::vector<Polygon> polygons;
  for (const auto& f : faces) {
    polygons.push_back(f.size() == 3 ? Polygon(NodeId(f[0]), NodeId(f[1]), NodeId(f[2]))
                                     : Polygon(NodeId(f[0]), NodeId(f[1]), NodeId(f[2]), NodeId(f[3])));
  }
  std::vector<NodeTag> tags(points.size());
  for (const Edge& e : constraints)
    for (const std::size_t v : e) tags[v].kind = NodeKind::Fixed;
  WorkMesh mesh;
  mesh.build(points, tags, polygons);
  for (std::size_t i = 0; i < mesh.topo().face_capacity(); ++i) mesh.set_cell(FaceId(i), CellId(0));
  for (const Edge& e : constraints) {
    mesh.set_curve(edge_of(mesh.topo().find(NodeId(e[0]), NodeId(e[1]))), CurveId(0));
    mesh.add_segment({NodeId(e[0]), NodeId(e[1]), CurveId(0)});
  }
  return mesh;
}

/// Rectangle of nx x ny unit cells, each cut by its rising diagonal; node (i, j) is j (nx + 1) + i; `lines` are further
/// constraint edges.
inline WorkMesh triangulated_grid(std::size_t nx, std::size_t ny, const std::vector<Edge>& lines = {}) {
  std::vector<Point> points;
  std::vector<std::vector<std::size_t>> faces;
  std::vector<Edge> constraints = lines;
  const auto node = [nx](std::size_t i, std::size_t j) { return j * (nx + 1) + i; };
  for (std::size_t j = 0; j <= ny; ++j)
    for (std::size_t i = 0; i <= nx; ++i) points.push_back({static_cast<double>(i), static_cast<double>(j)});
  for (std::size_t j = 0; j < ny; ++j)
    for (std::size_t i = 0; i < nx; ++i) {
      faces.push_back({node(i, j), node(i + 1, j), node(i + 1, j + 1)});
      faces.push_back({node(i, j), node(i + 1, j + 1), node(i, j + 1)});
    }
  for (std::size_t i = 0; i < nx; ++i) {
    constraints.push_back({node(i, 0), node(i + 1, 0)});
    constraints.push_back({node(i + 1, ny), node(i, ny)});
  }
  for (std::size_t j = 0; j < ny; ++j) {
    constraints.push_back({node(nx, j), node(nx, j + 1)});
    constraints.push_back({node(0, j + 1), node(0, j)});
  }
  return mesh_of(points, faces, constraints);
}

/// Numbers that look random, the same everywhere.
class Dice {
 public:
  explicit Dice(std::uint32_t seed) : state_(seed) {}
  /// In [-1, 1).
  double roll() {
    state_ = state_ * 1664525u + 1013904223u;
    return static_cast<double>(state_ >> 8) / 8388608.0 - 1;
  }

 private:
  std::uint32_t state_;
};

/// The same with rising and falling diagonals in no order: pairs of triangles show no rows, the nodes do.
inline WorkMesh shuffled_grid(std::size_t nx, std::size_t ny, const std::vector<Edge>& lines = {}) {
  WorkMesh mesh = triangulated_grid(nx, ny, lines);
  Dice dice(7);
  for (std::size_t j = 0; j < ny; ++j)
    for (std::size_t i = 0; i < nx; ++i) {
      const std::size_t v = j * (nx + 1) + i;
      const EdgeId diagonal = edge_of(mesh.topo().find(NodeId(v), NodeId(v + nx + 2)));
      if (dice.roll() < 0 && mesh.can_swap(diagonal) == Refusal::None) mesh.swap_edge(diagonal);
    }
  return mesh;
}

/// The same with its free nodes moved four times by up to `most` along each axis, and Delaunay: no grid is left inside.
inline WorkMesh jittered_grid(std::size_t nx, std::size_t ny, double most, std::uint32_t seed,
                              const std::vector<Edge>& lines = {}) {
  WorkMesh mesh = triangulated_grid(nx, ny, lines);
  const Topology& topo = mesh.topo();
  Dice dice(seed);
  for (int round = 0; round < 4; ++round) {
    for (std::size_t i = 0; i < topo.node_capacity(); ++i) {
      const NodeId v(i);
      const Point from = mesh.point(v), to = from + Point{most * dice.roll(), most * dice.roll()};
      bool is_valid = mesh.is_free(v);
      topo.for_each_out(v, [&](HalfId h) {
        is_valid = is_valid && cross(mesh.point(topo.head(h)) - to, mesh.point(topo.tail(topo.prev(h))) - to) > 0.02;
      });
      if (is_valid) mesh.move(v, to);
    }
    std::vector<EdgeId> edges;
    for (std::size_t i = 0; i < topo.edge_capacity(); ++i) edges.push_back(EdgeId(i));
    restore_delaunay(mesh, edges);
  }
  return mesh;
}

/// A node 0 at the origin with `n_quads` quads round it and a triangle in the gap between them: front edges leave along
/// the x axis to node 1 and arrive from node 2, `angle_deg` counter-clockwise of it.
inline WorkMesh gap(double angle_deg, int n_quads, const std::vector<Edge>& constraints = {}) {
  constexpr double kDegree = 0.017453292519943295;
  const auto at = [](double deg, double r) { return Point{r * std::cos(deg * kDegree), r * std::sin(deg * kDegree)}; };
  const double share = (360 - angle_deg) / n_quads;
  std::vector<Point> points{{0, 0}, {1, 0}, at(angle_deg, 1)};
  std::vector<std::vector<std::size_t>> faces{{0, 1, 2}};
  std::size_t rim = 2;
  for (int i = 0; i < n_quads; ++i) {
    points.push_back(at(angle_deg + (i + 0.5) * share, 2));
    const std::size_t far = points.size() - 1, next = i + 1 < n_quads ? points.size() : 1;
    if (next != 1) points.push_back(at(angle_deg + (i + 1) * share, 1));
    faces.push_back({0, rim, far, next});
    rim = next;
  }
  return mesh_of(points, faces, constraints);
}

/// A size field that is 1 everywhere.
inline SizeField unit_size() {
  Domain domain;
  domain.size = 1;
  domain.box = {{-64, -64}, {64, 64}};
  domain.cells.push_back({});
  domain.cells[CellId(0)].size = 1;
  domain.tolerance = 1e-6;
  Context context;
  return make_size_field(domain, {}, context);
}

inline std::size_t n_triangles(const WorkMesh& mesh) {
  std::size_t n = 0;
  for (std::size_t i = 0; i < mesh.topo().face_capacity(); ++i)
    if (mesh.topo().is_live(FaceId(i)) && mesh.topo().is_triangle(FaceId(i))) ++n;
  return n;
}

inline std::size_t n_constraints(const WorkMesh& mesh) {
  std::size_t n = 0;
  for (std::size_t i = 0; i < mesh.topo().edge_capacity(); ++i)
    if (mesh.topo().is_live(EdgeId(i)) && mesh.is_constraint(EdgeId(i))) ++n;
  return n;
}

}  // namespace quadline::shapes
