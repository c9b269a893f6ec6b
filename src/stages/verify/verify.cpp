// Why these checks are enough: quads that turn left at every corner, joined across every edge that is not on the
// boundary, and a boundary that is the domain's with the domain on its left, cover each point of the domain once: the
// number of quads over a point is the winding number of the boundary round it. The areas then only say that each quad
// bears the name of the region it lies in.
#include "stages/verify/verify.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "geom/curve.hpp"
#include "geom/element.hpp"
#include "geom/predicates.hpp"
#include "quality/limits.hpp"
#include "quality/mesh_edges.hpp"

namespace quadline {

namespace {

constexpr double kSameNode = 0.01;   // in tolerances: nodes nearer than this stand in one place
constexpr double kSquare = 4;        // side of the squares by which near nodes are sought, in the same distance
constexpr double kAreaError = 1e-9;  // relative to the square of the domain's diagonal

// The first corner that is no left turn, -1: none. Four left turns, each below a half turn, add up to one full turn:
// such a quad is simple and convex.
int reflex_corner(const QuadPoints& p) {
  for (int i = 0; i < 4; ++i)
    if (orientation(p[(i + 3) % 4], p[i], p[(i + 1) % 4]) <= 0) return i;
  return -1;
}

bool is_flat(const QuadPoints& p) { return !(scaled_jacobian(p) > kFlatJacobian); }

bool is_before(Point p, Point q) { return p.x != q.x ? p.x < q.x : p.y < q.y; }

class Verifier {
 public:
  Verifier(const Mesh& mesh, const Domain& domain)
      : mesh_(mesh),
        domain_(domain),
        center_(midpoint(domain.box.lo, domain.box.hi)),
        names_regions_(mesh.regions == domain.regions && mesh.quad_region.size() == mesh.quads.size()) {}

  std::optional<Failure> run(const Context& context) {
    check_quads();
    if (!failure_) check_nodes();
    context.progress("verify", 0.4);
    if (failure_) return failure_;
    edges_.emplace(mesh_);
    check_vertices();
    if (!failure_) check_curves();
    if (!failure_) check_edges();
    if (!failure_) check_areas();
    context.progress("verify", 1);
    return failure_;
  }

 private:
  void fail(std::string reason, Point at) {
    if (!failure_) failure_ = Failure{"verify", std::move(reason), at};
  }
  Point point(NodeIndex v) const { return mesh_.points[v]; }

  void check_quads() {
    if (!mesh_.triangles.empty()) return fail("a triangle is left", point(mesh_.triangles[0][0]));
    if (mesh_.quads.empty()) return fail("the mesh has no quads", domain_.box.lo);
    for (const Point p : mesh_.points)
      if (!std::isfinite(p.x) || !std::isfinite(p.y)) return fail("a node has no finite coordinates", domain_.box.lo);
    for (const auto& q : mesh_.quads) {
      for (const NodeIndex v : q)
        if (v >= mesh_.points.size()) return fail("a quad names a node that is not there", domain_.box.lo);
      const QuadPoints p{point(q[0]), point(q[1]), point(q[2]), point(q[3])};
      if (const int i = reflex_corner(p); i >= 0) return fail("a quad is not convex", p[i]);
      if (is_flat(p)) return fail("a quad is flat", p[0]);
    }
  }

  void check_nodes() {
    std::vector<std::uint8_t> used(mesh_.points.size(), 0);
    for (const auto& q : mesh_.quads)
      for (const NodeIndex v : q) used[v] = 1;
    for (std::size_t i = 0; i < used.size(); ++i)
      if (!used[i]) return fail("a node belongs to no quad", mesh_.points[i]);
    check_distances();
  }

  // Nodes sorted by columns of squares: those near one stand further on in its column, or beside it in the next.
  void check_distances() {
    struct Entry {
      std::int64_t column, row;
      NodeIndex node;
    };
    const auto is_less = [](const Entry& e, const Entry& f) {
      if (e.column != f.column) return e.column < f.column;
      return e.row != f.row ? e.row < f.row : e.node < f.node;
    };
    const double near = kSameNode * domain_.tolerance, side = kSquare * near;
    std::vector<Entry> entries;
    entries.reserve(mesh_.points.size());
    for (NodeIndex v = 0; v < mesh_.points.size(); ++v) {
      const Point p = point(v) - domain_.box.lo;
      entries.push_back(
          {static_cast<std::int64_t>(std::floor(p.x / side)), static_cast<std::int64_t>(std::floor(p.y / side)), v});
    }
    std::sort(entries.begin(), entries.end(), is_less);
    std::size_t beside = 0;
    for (std::size_t i = 0; i < entries.size(); ++i) {
      const Entry e = entries[i];
      const auto seek = [&](std::size_t from, std::int64_t column) {
        for (std::size_t k = from; k < entries.size(); ++k) {
          if (entries[k].column != column || entries[k].row > e.row + 1) return;
          if (distance(point(e.node), point(entries[k].node)) <= near)
            return fail("two nodes stand in one place", point(e.node));
        }
      };
      seek(i + 1, e.column);
      while (beside < entries.size() && is_less(entries[beside], {e.column + 1, e.row - 1, 0})) ++beside;
      seek(beside, e.column + 1);
      if (failure_) return;
    }
  }

  // Vertices and points are nodes, at the very coordinates.
  void check_vertices() {
    std::vector<NodeIndex> order(mesh_.points.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = static_cast<NodeIndex>(i);
    std::sort(order.begin(), order.end(), [&](NodeIndex v, NodeIndex w) { return is_before(point(v), point(w)); });
    node_at_.assign(domain_.vertices.count(), 0);
    IdVector<VertexId, bool> is_asked(domain_.vertices.count(), true);
    for (const Domain::Curve& curve : domain_.curves)
      if (curve.is_auxiliary) is_asked[curve.tail] = is_asked[curve.head] = false;
    for (std::size_t i = 0; i < domain_.vertices.count(); ++i) {
      if (!is_asked[VertexId(i)]) continue;
      const Point p = domain_.vertices[VertexId(i)].at;
      const auto found = std::lower_bound(order.begin(), order.end(), p,
                                          [&](NodeIndex v, Point at) { return is_before(point(v), at); });
      if (found == order.end() || point(*found) != p) return fail("a vertex of the domain is no node", p);
      node_at_[VertexId(i)] = *found;
    }
    if (mesh_.node_sets.size() != domain_.points.size()) return fail("a named point is missing", domain_.box.lo);
    for (std::size_t i = 0; i < domain_.points.size(); ++i) {
      const Domain::PointUse& use = domain_.points[i];
      const NodeSet& set = mesh_.node_sets[i];
      if (set.name != use.name || set.nodes != std::vector<NodeIndex>{node_at_[use.vertex]})
        return fail("point '" + use.name + "' is no node", domain_.vertices[use.vertex].at);
    }
  }

  void check_curves() {
    on_curve_.assign(edges_->count(), 0);
    area_.assign(domain_.regions.size(), 0);
    is_covered_.assign(domain_.curves.count(), 0);
    if (mesh_.curves.size() != domain_.paths.size()) return fail("a curve is missing", domain_.box.lo);
    for (std::size_t i = 0; i < domain_.paths.size() && !failure_; ++i) check_path(domain_.paths[i], mesh_.curves[i]);
    for (std::size_t i = 0; i < domain_.curves.count() && !failure_; ++i) {
      const Domain::Curve& curve = domain_.curves[CurveId(i)];
      if (!is_covered_[CurveId(i)] && !curve.is_auxiliary && (curve.left.valid() || curve.right.valid()))
        fail("a curve of the domain has no edges", curve.piece.a);
    }
  }

  void check_path(const Domain::Path& path, const EdgeSet& set) {
    if (set.name != path.name || set.kind != path.kind) return fail("'" + path.name + "' is missing", domain_.box.lo);
    std::size_t k = 0;
    for (const DirectedCurve& d : path.curves) {
      follow(d, set, k);
      if (failure_) return;
      is_covered_[d.curve] = 1;
    }
    if (k != set.edges.size()) fail("'" + path.name + "' has edges too many", point(set.edges[k][0]));
  }

  // Edges from the k-th on follow each other along the curve from end to end, their nodes on it, their faces beside it.
  void follow(const DirectedCurve& d, const EdgeSet& set, std::size_t& k) {
    const Domain::Curve& curve = domain_.curves[d.curve];
    const CurvePiece piece = d.reversed ? reversed(curve.piece) : curve.piece;
    const double total = length(piece);
    const NodeIndex end = node_at_[d.reversed ? curve.tail : curve.head];
    NodeIndex here = node_at_[d.reversed ? curve.head : curve.tail];
    for (double s = 0; here != end; ++k) {
      if (k == set.edges.size()) return fail("'" + set.name + "' is not covered by edges to its end", point(here));
      const auto [a, b] = set.edges[k];
      if (a != here) return fail("'" + set.name + "' has a gap", point(here));
      const std::size_t edge = edges_->find(a, b);
      if (edge == edges_->count()) return fail("'" + set.name + "' has an edge that is no side of a quad", point(a));
      const double next = b == end ? total : project(piece, point(b));
      if (b != end && distance(point(b), point_at(piece, next)) > domain_.tolerance)
        return fail("a node of '" + set.name + "' lies off it", point(b));
      if (next <= s) return fail("the edges of '" + set.name + "' run back", point(b));
      const CellId left = d.reversed ? curve.right : curve.left, right = d.reversed ? curve.left : curve.right;
      check_sides(edge, a < b, left, right, set.name);
      s = next;
      here = b;
    }
  }

  // The faces beside an edge of a curve, and its part of the areas of the regions beside it.
  void check_sides(std::size_t edge, bool forward, CellId left, CellId right, const std::string& name) {
    const auto [a, b] = edges_->nodes(edge);
    if (quads_beside(edge, forward) != (left.valid() ? 1 : 0) ||
        quads_beside(edge, !forward) != (right.valid() ? 1 : 0))
      return fail("an edge of '" + name + "' does not have its quads", midpoint(point(a), point(b)));
    if (on_curve_[edge]) return;  // of another curve of the model as well
    on_curve_[edge] = 1;
    const double part = (forward ? 0.5 : -0.5) * cross(point(a) - center_, point(b) - center_);
    if (left.valid()) area_[region_of(domain_.cells[left].region)] += part;
    if (right.valid()) area_[region_of(domain_.cells[right].region)] -= part;
  }
  // Those that walk it from its smaller node to its greater one, or those that walk it back.
  int quads_beside(std::size_t edge, bool forward) const {
    int n = 0;
    for (const Side& side : edges_->sides(edge)) n += side.forward == forward;
    return n;
  }
  // Meshes with names of their own are not asked for the model's.
  std::size_t region_of(std::size_t region) const { return names_regions_ ? region : 0; }

  void check_edges() {
    for (std::size_t i = 0; i < on_curve_.size() && !failure_; ++i) {
      const auto [a, b] = edges_->nodes(i);
      const int n_forward = quads_beside(i, true), n_backward = quads_beside(i, false);
      const Point at = midpoint(point(a), point(b));
      if (n_forward > 1 || n_backward > 1) fail("quads overlap at an edge", at);
      if (!on_curve_[i] && n_forward + n_backward != 2) fail("an edge inside the domain has only one quad", at);
    }
  }

  void check_areas() {
    for (std::size_t i = 0; i < mesh_.quads.size(); ++i) {
      const auto& q = mesh_.quads[i];
      const std::size_t region = names_regions_ ? mesh_.quad_region[i] : 0;
      if (region >= area_.size()) return fail("a quad names a region that is not there", point(q[0]));
      area_[region] -= 0.5 * cross(point(q[2]) - point(q[0]), point(q[3]) - point(q[1]));
    }
    const double allowed = kAreaError * norm2(domain_.box.hi - domain_.box.lo);
    for (std::size_t i = 0; i < area_.size(); ++i)
      if (!(std::fabs(area_[i]) <= allowed))
        return fail("the quads of region '" + domain_.regions[i] + "' do not add up to its area", domain_.box.lo);
  }

  const Mesh& mesh_;
  const Domain& domain_;
  const Point center_;
  const bool names_regions_;
  std::optional<MeshEdges> edges_;
  IdVector<VertexId, NodeIndex> node_at_;
  std::vector<std::uint8_t> on_curve_;  // of edges
  IdVector<CurveId, std::uint8_t> is_covered_;
  std::vector<double> area_;  // of the regions by their boundaries, less the quads'
  std::optional<Failure> failure_;
};

}  // namespace

bool is_sound(const QuadPoints& quad) { return reflex_corner(quad) < 0 && !is_flat(quad); }

std::optional<Failure> verify(const Mesh& mesh, const Domain& domain, Context& context) {
  return Verifier(mesh, domain).run(context);
}

}  // namespace quadline
