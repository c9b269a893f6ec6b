#include "better_cells.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <tuple>
#include <utility>
#include <vector>

#include "base/check.hpp"
#include "geom/element.hpp"
#include "stages/verify/verify.hpp"

namespace quadline {

namespace {

constexpr double kDistortion = 0.1;        // what a quad of no beta counts, in irregular nodes
constexpr double kUnsound = 1000;          // what a quad that is not convex counts
constexpr double kTie = 2.0 / 90;          // in right angles
constexpr std::size_t kMostQuads = 10000;  // of a cell that is looked at

// Quads too many (too few: negative) for the angle of a sector, in radians; 0 for either number near a tie.
int quads_off(double angle, int quads) {
  const double wanted = angle / (std::numbers::pi / 2);
  const double least = std::max(1.0, std::round(wanted - kTie)), most = std::max(1.0, std::round(wanted + kTie));
  return quads > most ? quads - static_cast<int>(most) : quads < least ? quads - static_cast<int>(least) : 0;
}

template <class Visit>
void for_each_quad(const WorkMesh& mesh, Visit visit) {
  for (std::size_t i = 0; i < mesh.topo().face_capacity(); ++i)
    if (const FaceId f(i); mesh.topo().is_live(f) && mesh.cell(f).valid()) visit(f);
}

// Calls visit(cell, quads too many) for every sector, an inner node's too, that has not the number of quads that suits
// its angle, as the report counts them.
template <class Visit>
void for_each_irregular(const WorkMesh& mesh, Visit visit) {
  const Topology& topo = mesh.topo();
  for (std::size_t i = 0; i < topo.node_capacity(); ++i) {
    const NodeId v(i);
    if (!topo.is_live(v) || !topo.out(v).valid()) continue;
    bool on_curve = false;
    mesh.for_each_sector(v, [&](HalfId first, HalfId last, double angle) {
      on_curve = true;
      int quads = 0;
      for (HalfId h = first; quads == 0 || h != last; h = topo.rotate_ccw(h)) ++quads;
      if (const int off = quads_off(angle, quads); off != 0) visit(mesh.cell(topo.face(first)), off);
    });
    if (on_curve) continue;
    int quads = 0;
    topo.for_each_out(v, [&](HalfId) { ++quads; });
    if (quads != 4) visit(mesh.cell(topo.face(topo.out(v))), quads - 4);
  }
}

// Of each cell; infinite where the mesh has none of it.
IdVector<CellId, double> costs(const WorkMesh& mesh) {
  constexpr double kAbsent = std::numeric_limits<double>::infinity();
  IdVector<CellId, double> cost;
  for_each_quad(mesh, [&](FaceId f) {
    const QuadPoints q = mesh.quad_points(f);
    cost.grow(mesh.cell(f).value + std::size_t{1}, kAbsent);
    double& sum = cost[mesh.cell(f)];
    if (sum == kAbsent) sum = 0;
    sum += kDistortion * (1 - quad_distortion(q)) + (is_sound(q) ? 0 : kUnsound);
  });
  for_each_irregular(mesh, [&](CellId c, int) { cost[c] += 1; });
  return cost;
}

// Puts faces of two meshes with the same nodes on the curves together.
class Joiner {
 public:
  explicit Joiner(const WorkMesh& mesh) : mesh_(mesh) {
    for (std::size_t i = 0; i < mesh.topo().node_capacity(); ++i)
      if (const NodeId v(i); mesh.topo().is_live(v) && !mesh.is_free(v)) curve_nodes_.push_back(place(mesh, v));
    std::sort(curve_nodes_.begin(), curve_nodes_.end());
  }

  WorkMesh join(const WorkMesh& other, const CellSet& of_other) {
    add(mesh_, [&](CellId c) { return !of_other.contains(c); });
    add(other, [&](CellId c) { return of_other.contains(c); });
    WorkMesh joined;
    joined.build(std::move(points_), std::move(tags_), quads_);
    for (std::size_t i = 0; i < cells_.size(); ++i) joined.set_cell(FaceId(i), cells_[i]);
    add_constraints(joined);
    joined.sort_in_space();
    return joined;
  }

 private:
  struct Place {
    VertexId vertex;
    CurveId curve;
    double s;
    NodeId node;
    bool operator<(const Place& o) const { return std::tie(vertex, curve, s) < std::tie(o.vertex, o.curve, o.s); }
  };
  static Place place(const WorkMesh& mesh, NodeId v) {
    const NodeTag& tag = mesh.tag(v);
    return {tag.vertex, tag.curve, tag.s, v};
  }

  template <class Choose>
  void add(const WorkMesh& mesh, Choose choose) {
    IdVector<NodeId, NodeId> free(mesh.topo().node_capacity());
    for_each_quad(mesh, [&](FaceId f) {
      if (!choose(mesh.cell(f))) return;
      Polygon q = mesh.topo().polygon(f);
      for (NodeId& v : q.nodes) v = number(mesh, v, free);
      quads_.push_back(q);
      cells_.push_back(mesh.cell(f));
    });
  }

  // Of a node in the joined mesh.
  NodeId number(const WorkMesh& mesh, NodeId v, IdVector<NodeId, NodeId>& known) {
    NodeId& n = known[v];
    if (n.valid()) return n;
    if (mesh.is_free(v)) return n = add_node(mesh, v);
    const auto found = std::lower_bound(curve_nodes_.begin(), curve_nodes_.end(), place(mesh, v));
    QUADLINE_CHECK(found != curve_nodes_.end() && !(place(mesh, v) < *found));
    NodeId& shared = shared_[found->node];
    if (!shared.valid()) shared = add_node(mesh, v);
    return n = shared;
  }

  NodeId add_node(const WorkMesh& mesh, NodeId v) {
    points_.push_back(mesh.point(v));
    tags_.push_back(mesh.tag(v));
    return NodeId(points_.size() - 1);
  }

  void add_constraints(WorkMesh& joined) const {
    for (Segment s : mesh_.segments) {
      s.a = shared_[s.a];
      s.b = shared_[s.b];
      const HalfId h = joined.topo().find(s.a, s.b);
      QUADLINE_CHECK(h.valid());
      joined.set_curve(edge_of(h), s.curve);
      joined.segments.push_back(s);
    }
  }

  const WorkMesh& mesh_;
  std::vector<Place> curve_nodes_;  // of the first mesh, sorted
  IdVector<NodeId, NodeId> shared_{mesh_.topo().node_capacity()};
  std::vector<Point> points_;
  std::vector<NodeTag> tags_;
  std::vector<Polygon> quads_;
  std::vector<CellId> cells_;
};

}  // namespace

CellSet improvable_cells(const WorkMesh& mesh, const CellSet& but) {
  IdVector<CellId, std::size_t> n_quads;
  for_each_quad(mesh, [&](FaceId f) {
    n_quads.grow(mesh.cell(f).value + std::size_t{1}, 0);
    ++n_quads[mesh.cell(f)];
  });
  CellSet too_many, too_few, both;
  for_each_irregular(mesh, [&](CellId c, int off) {
    (off > 0 ? too_many : too_few).insert(c);
    if (too_many.contains(c) && too_few.contains(c) && n_quads[c] <= kMostQuads && !but.contains(c)) both.insert(c);
  });
  return both;
}

void keep_cells(WorkMesh& mesh, const CellSet& cells) {
  for (std::size_t i = 0; i < mesh.topo().face_capacity(); ++i)
    if (const FaceId f(i); mesh.topo().is_live(f) && !cells.contains(mesh.cell(f))) mesh.set_cell(f, CellId());
  std::erase_if(mesh.segments, [&](const Segment& s) {
    const HalfId h = mesh.topo().find(s.a, s.b);
    return mesh.is_outside(h) && mesh.is_outside(twin(h));
  });
}

CellSet better_cells(const WorkMesh& mesh, const WorkMesh& other) {
  const IdVector<CellId, double> now = costs(mesh), then = costs(other);
  CellSet better;
  for (std::size_t i = 0; i < then.count(); ++i)
    if (const CellId c(i); then[c] < now[c]) better.insert(c);
  return better;
}

WorkMesh joined(const WorkMesh& mesh, const WorkMesh& other, const CellSet& of_other) {
  return Joiner(mesh).join(other, of_other);
}

}  // namespace quadline
