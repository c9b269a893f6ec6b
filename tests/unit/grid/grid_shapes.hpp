#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "domain/arrange/arrange.hpp"
#include "domain/domain.hpp"
#include "geom/angles.hpp"
#include "mesh/work_mesh.hpp"
#include "quadline/model.hpp"
#include "stages/grid/fill_grid.hpp"
#include "stages/grid/lattice.hpp"
#include "stages/verify/verify.hpp"
#include "tests/unit/domain/size/size_shapes.hpp"

namespace quadline::shapes {

/// A closed walk over the lattice by its corners, in its direction; a node for each place.
class WalkMaker {
 public:
  NodeWalk walk(const std::vector<GridPlace>& corners) {
    std::vector<GridPlace> places;
    for (std::size_t n = 0; n < corners.size(); ++n) {
      const GridPlace to = corners[(n + 1) % corners.size()];
      for (GridPlace at = corners[n]; at != to; at = {at.i + sign(to.i - at.i), at.j + sign(to.j - at.j)})
        places.push_back(at);
    }
    NodeWalk made;
    for (std::size_t n = 0; n < places.size(); ++n) {
      const GridPlace before = places[(n + places.size() - 1) % places.size()], at = places[n],
                      after = places[(n + 1) % places.size()];
      const int turn = turn_of({at.i - before.i, at.j - before.j}, {after.i - at.i, after.j - at.j});
      made.turns += turn;
      made.nodes.push_back({node(at), turn});
    }
    return made;
  }

  NodeId node(GridPlace p) { return nodes_.emplace(std::pair(p.i, p.j), NodeId(nodes_.size())).first->second; }

 private:
  static int sign(int x) { return (x > 0) - (x < 0); }
  static int turn_of(GridPlace in, GridPlace out) {
    const int left = in.i * out.j - in.j * out.i;
    return left != 0 ? left : in.i * out.i + in.j * out.j > 0 ? 0 : -2;
  }
  std::map<std::pair<int, int>, NodeId> nodes_;
};

/// Squares of a lattice that are quads.
inline int quad_count(const Lattice& lattice) {
  int n = 0;
  for (int j = 0; j < lattice.rows(); ++j)
    for (int i = 0; i < lattice.columns(); ++i) n += lattice.is_quad(i, j);
  return n;
}

/// A domain of straight links along a list of corners, counter-clockwise, turned about the origin.
inline Domain polygon(std::vector<Point> corners, double angle_rad = 0) {
  std::vector<Link> links;
  for (Point& p : corners) p = turned(p, angle_rad);
  for (std::size_t n = 0; n < corners.size(); ++n) links.push_back({n, (n + 1) % corners.size()});
  return Builder(std::move(corners), std::move(links), 1).build();
}

/// A rectangle from the origin with a round hole, whose two arcs end on its diagonal; all turned about the origin. The
/// first curve goes along the width.
inline Domain plate_with_hole(double width, double height, Point center, double radius, double angle_rad = 0) {
  const Point way = radius * std::sqrt(0.5) * Point{1, 1}, side = left_normal(way);
  std::vector<Point> points{{0, 0}, {width, 0}, {width, height}, {0, height}, center + way, center - way};
  for (Point& p : points) p = turned(p, angle_rad);
  return Builder(points,
                 {{0, 1},
                  {1, 2},
                  {2, 3},
                  {3, 0},
                  {4, 5, turned(center + side, angle_rad)},
                  {5, 4, turned(center - side, angle_rad)}},
                 1)
      .build({turned(center, angle_rad)});
}

/// The ring between two circles about the origin, each of two arcs that end on the x axis.
inline Domain ring(double inner, double outer, double size) {
  return Builder({{outer, 0}, {-outer, 0}, {inner, 0}, {-inner, 0}},
                 {{0, 1, Point{0, outer}}, {1, 0, Point{0, -outer}}, {2, 3, Point{0, inner}}, {3, 2, Point{0, -inner}}},
                 size)
      .build({{0, 0}});
}

/// Nodes at all vertices and, equally spaced, on all curves: `counts[c]` edges on curve c.
inline WorkMesh nodes_on(const Domain& domain, const std::vector<std::uint32_t>& counts) {
  WorkMesh mesh;
  for (std::size_t v = 0; v < domain.vertices.count(); ++v)
    mesh.add_node(domain.vertices[VertexId(v)].at, {NodeKind::Fixed, CurveId(), 0, VertexId(v)});
  for (std::size_t i = 0; i < domain.curves.count(); ++i) {
    const Domain::Curve& curve = domain.curves[CurveId(i)];
    NodeId last(curve.tail.value);
    for (std::uint32_t k = 1; k < counts[i]; ++k) {
      const double s = length(curve.piece) * k / counts[i];
      const NodeId v = mesh.add_node(point_at(curve.piece, s), {NodeKind::OnCurve, CurveId(i), s, VertexId()});
      mesh.add_segment({last, v, CurveId(i)});
      last = v;
    }
    mesh.add_segment({last, NodeId(curve.head.value), CurveId(i)});
  }
  return mesh;
}

/// The numbers of quads at the free nodes that have not four.
inline std::vector<int> irregular_valences(const WorkMesh& mesh) {
  std::vector<int> found;
  for (const NodeId v : mesh.topo().nodes())
    if (const int n = mesh.topo().edge_valence(v); mesh.is_free(v) && n != 4) found.push_back(n);
  return found;
}

inline std::size_t unsound_count(const WorkMesh& mesh) {
  std::size_t n = 0;
  for (const FaceId f : mesh.topo().faces()) n += !is_sound(mesh.quad_points(f));
  return n;
}

/// A rectangular plate of the model's size 1 with round holes of one radius.
inline Model plate_model(double width, double height, const std::vector<Point>& centers, double radius) {
  Model model;
  model.size = 1;
  model.outer.push_back({.items = {{{0, 0}}, {{width, 0}}, {{width, height}}, {{0, height}}}});
  for (const Point center : centers) model.holes.push_back({.circle = Circle{center, radius}});
  return model;
}

/// A round flange: outer radius 12, bore 5, bolts of radius 0.9 at 8.5, the first on the x axis; size 1.
inline Model flange_model(int bolts) {
  Model model;
  model.size = 1;
  model.outer.push_back({.circle = Circle{{0, 0}, 12}});
  model.holes.push_back({.circle = Circle{{0, 0}, 5}});
  for (int n = 0; n < bolts; ++n)
    model.holes.push_back({.circle = Circle{turned({8.5, 0}, 2 * std::numbers::pi * n / bolts), 0.9}});
  return model;
}

inline Domain arranged(const Model& model) {
  Context context;
  return arrange(model, {}, context);
}

}  // namespace quadline::shapes
