#pragma once

#include <array>
#include <initializer_list>
#include <vector>

#include "domain/size/size_field.hpp"
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
