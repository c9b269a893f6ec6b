#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <map>
#include <string>
#include <vector>

#include "domain/domain.hpp"
#include "domain/size/size_field.hpp"
#include "mesh/work_mesh.hpp"

namespace quadline::shapes {

/// A place of a grid: column and row.
using Spot = std::array<int, 2>;

/// A domain cut from a grid of unit squares and its mesh, which is that grid; a small stand-in for all stages before
/// smoothing.
struct Patch {
  Domain domain;
  WorkMesh mesh;
  std::map<Spot, NodeId> node_at;

  NodeId node(int i, int j) const { return node_at.at({i, j}); }
  SizeField size() const {
    Context context;
    return make_size_field(domain, {}, context);
  }
};

/// What is cut from the grid of nx x ny squares.
struct PatchPlan {
  int nx = 4, ny = 4;
  double h = 1;                                 ///< side of a square
  std::function<bool(int i, int j)> keep = {};  ///< which squares; empty: all
  std::vector<std::array<Spot, 2>> lines = {};  ///< straight, along the grid, inside
  std::vector<Spot> points = {};                ///< point constraints inside
  std::vector<Spot> turned = {};                ///< squares (i, j) whose edge to (i + 1, j) is turned
};

class PatchMaker {
 public:
  explicit PatchMaker(const PatchPlan& plan) : plan_(plan) {}

  Patch make() {
    add_faces();
    trace_loops();
    for (std::size_t i = 0; i < plan_.lines.size(); ++i) add_line(i);
    for (std::size_t i = 0; i < plan_.points.size(); ++i)
      patch_.domain.points.push_back({"point-" + std::to_string(i + 1), vertex(plan_.points[i]), kNone});
    patch_.mesh.build(points_, tags_, polygons_);
    for (std::size_t i = 0; i < polygons_.size(); ++i) patch_.mesh.set_cell(FaceId(i), CellId(0));
    for (const auto& [a, b, curve] : edges_) patch_.mesh.set_curve(edge_of(patch_.mesh.topo().find(a, b)), curve);
    Domain& domain = patch_.domain;
    domain.regions = {"domain"};
    domain.size = plan_.h;
    domain.box = {{0, 0}, {plan_.nx * plan_.h, plan_.ny * plan_.h}};
    domain.tolerance = 1e-7 * norm(domain.box.hi);
    domain.cells[CellId(0)].size = plan_.h;
    return std::move(patch_);
  }

 private:
  static constexpr double kNone = std::numeric_limits<double>::infinity();
  bool keeps(int i, int j) const {
    return i >= 0 && j >= 0 && i < plan_.nx && j < plan_.ny && (!plan_.keep || plan_.keep(i, j));
  }
  bool is_turned(int i, int j) const {
    for (const Spot s : plan_.turned)
      if (s == Spot{i, j}) return true;
    return false;
  }

  NodeId node(Spot s) {
    const auto [it, is_new] = patch_.node_at.emplace(s, NodeId(points_.size()));
    if (is_new) {
      points_.push_back({plan_.h * s[0], plan_.h * s[1]});
      tags_.emplace_back();
    }
    return it->second;
  }

  void add_faces() {
    for (int j = 0; j <= plan_.ny; ++j)
      for (int i = 0; i <= plan_.nx; ++i)
        if (keeps(i, j) || keeps(i - 1, j) || keeps(i, j - 1) || keeps(i - 1, j - 1)) node({i, j});
    for (int j = 0; j < plan_.ny; ++j) {
      for (int i = 0; i < plan_.nx; ++i) {
        if (!keeps(i, j) || is_turned(i - 1, j)) continue;
        const NodeId a = node({i, j}), b = node({i + 1, j}), e = node({i + 1, j + 1}), d = node({i, j + 1});
        if (is_turned(i, j)) {
          const NodeId c = node({i + 2, j}), f = node({i + 2, j + 1});
          polygons_.emplace_back(a, b, c, f);
          polygons_.emplace_back(a, f, e, d);
        } else {
          polygons_.emplace_back(a, b, e, d);
        }
      }
    }
  }

  // Boundary edges with the domain on their left, from node to node.
  void trace_loops() {
    std::map<Spot, Spot> next;
    for (int j = 0; j <= plan_.ny; ++j) {
      for (int i = 0; i <= plan_.nx; ++i) {
        if (keeps(i, j) && !keeps(i, j - 1)) next[{i, j}] = {i + 1, j};
        if (!keeps(i, j) && keeps(i, j - 1)) next[{i + 1, j}] = {i, j};
        if (keeps(i, j) && !keeps(i - 1, j)) next[{i, j + 1}] = {i, j};
        if (!keeps(i, j) && keeps(i - 1, j)) next[{i, j}] = {i, j + 1};
      }
    }
    patch_.domain.cells.push_back({});
    int n_holes = 0;
    while (!next.empty()) {
      // The lowest and leftmost node of a loop is a corner of it.
      std::vector<Spot> loop{next.begin()->first};
      double area = 0;
      for (auto it = next.begin(); it != next.end(); it = next.find(loop.back())) {
        area += it->first[0] * it->second[1] - it->first[1] * it->second[0];
        loop.push_back(it->second);
        next.erase(it);
      }
      const bool is_hole = area < 0;
      Domain::Path path{
          is_hole ? "hole-" + std::to_string(++n_holes) : "outer-1", is_hole ? CurveKind::Hole : CurveKind::Outer, {}};
      std::size_t from = 0;
      for (std::size_t k = 1; k < loop.size(); ++k) {
        const Spot p = loop[k - 1], q = loop[k], r = loop[k + 1 == loop.size() ? 1 : k + 1];
        if (q[0] - p[0] == r[0] - q[0] && q[1] - p[1] == r[1] - q[1]) continue;
        path.curves.push_back({add_curve(
            {loop.begin() + static_cast<std::ptrdiff_t>(from), loop.begin() + static_cast<std::ptrdiff_t>(k) + 1},
            false)});
        from = k;
      }
      patch_.domain.cells[CellId(0)].walks.push_back(path.curves);
      auto& paths = patch_.domain.paths;
      paths.insert(is_hole ? paths.end() : paths.begin(), std::move(path));
    }
  }

  void add_line(std::size_t n) {
    const auto [a, b] = plan_.lines[n];
    const auto toward = [](int from, int to) { return (to > from) - (to < from); };
    std::vector<Spot> spots{a};
    while (spots.back() != b)
      spots.push_back({spots.back()[0] + toward(a[0], b[0]), spots.back()[1] + toward(a[1], b[1])});
    const CurveId curve = add_curve(spots, true);
    patch_.domain.paths.push_back({"line-" + std::to_string(n + 1), CurveKind::Line, {{curve}}});
    patch_.domain.cells[CellId(0)].walks.push_back({{curve}, {curve, true}});
  }

  CurveId add_curve(const std::vector<Spot>& spots, bool is_line) {
    Domain::Curve curve;
    curve.tail = vertex(spots.front());
    curve.head = vertex(spots.back());
    curve.piece = {.a = points_[node(spots.front()).value], .b = points_[node(spots.back()).value]};
    curve.left = CellId(0);
    if (is_line) curve.right = CellId(0);
    curve.size = kNone;
    const CurveId id = patch_.domain.curves.push_back(curve);
    for (std::size_t k = 0; k < spots.size(); ++k) {
      const NodeId v = node(spots[k]);
      if (k > 0) edges_.push_back({node(spots[k - 1]), v, id});
      if (k == 0 || k + 1 == spots.size()) continue;
      tags_[v.value].kind = NodeKind::OnCurve;
      tags_[v.value].curve = id;
      tags_[v.value].s = distance(points_[node(spots.front()).value], points_[v.value]);
    }
    return id;
  }

  VertexId vertex(Spot s) {
    NodeTag& tag = tags_[node(s).value];
    if (!tag.vertex.valid()) {
      tag.kind = NodeKind::Fixed;
      tag.vertex = patch_.domain.vertices.push_back({points_[node(s).value]});
    }
    return tag.vertex;
  }

  struct CurveEdge {
    NodeId a, b;
    CurveId curve;
  };
  const PatchPlan& plan_;
  Patch patch_;
  std::vector<Point> points_;
  std::vector<NodeTag> tags_;
  std::vector<Polygon> polygons_;
  std::vector<CurveEdge> edges_;
};

inline Patch patch(const PatchPlan& plan) { return PatchMaker(plan).make(); }

/// Numbers in [-1, 1], the same on every machine.
class Noise {
 public:
  explicit Noise(std::uint64_t seed) : state_(seed) {}
  double next() {
    state_ = state_ * 6364136223846793005u + 1442695040888963407u;
    return static_cast<double>(state_ >> 11) * 0x1p-52 - 1;
  }

 private:
  std::uint64_t state_;
};

/// Moves every free node by up to `reach` in x and in y, and slides those on curves by up to `slide` along them.
inline void shake(Patch& patch, double reach, std::uint64_t seed, double slide = 0) {
  Noise noise(seed);
  for (std::size_t i = 0; i < patch.mesh.topo().node_capacity(); ++i) {
    const NodeId v(i);
    const double x = noise.next(), y = noise.next();
    const NodeTag tag = patch.mesh.tag(v);
    if (tag.kind == NodeKind::Free) patch.mesh.move(v, patch.mesh.point(v) + Point{reach * x, reach * y});
    if (tag.kind == NodeKind::OnCurve) {
      const double s = tag.s + slide * x;
      patch.mesh.slide(v, s, point_at(patch.domain.curves[tag.curve].piece, s));
    }
  }
}

/// Least scaled Jacobian of the quads.
inline double least_jacobian(const WorkMesh& mesh) {
  double least = 1;
  for (std::size_t i = 0; i < mesh.topo().face_capacity(); ++i)
    if (mesh.topo().is_live(FaceId(i))) least = std::fmin(least, scaled_jacobian(mesh.quad_points(FaceId(i))));
  return least;
}

}  // namespace quadline::shapes
