#include "stages/verify/verify.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "geom/curve.hpp"
#include "geom/predicates.hpp"

namespace quadline {

namespace {

constexpr double kAreaError = 1e-9;  // relative: sums of rounded products

struct Edge {
  NodeIndex a, b;  // a < b
  friend auto operator<=>(const Edge&, const Edge&) = default;
};

Edge edge(NodeIndex a, NodeIndex b) { return a < b ? Edge{a, b} : Edge{b, a}; }

double twice_area(const Mesh& mesh, NodeIndex a, NodeIndex b, Point origin) {
  return cross(mesh.points[a] - origin, mesh.points[b] - origin);
}

class Verifier {
 public:
  Verifier(const Mesh& mesh, const Domain& domain) : mesh_(mesh), domain_(domain) {}

  std::optional<Failure> run() {
    check_quads();
    if (!failure_) check_nodes();
    if (!failure_) check_edges();
    if (!failure_) check_area();
    if (!failure_) check_curves();
    if (!failure_) check_points();
    return failure_;
  }

 private:
  void fail(const std::string& reason, Point at) {
    if (!failure_) failure_ = Failure{"verify", reason, at};
  }

  // All quads, counter-clockwise, strictly convex.
  void check_quads() {
    if (mesh_.quads.empty()) return fail("the mesh has no quads", domain_.box.lo);
    if (!mesh_.triangles.empty()) return fail("a triangle is left", mesh_.points[mesh_.triangles[0][0]]);
    for (const auto& q : mesh_.quads)
      for (int i = 0; i < 4; ++i) {
        if (q[i] >= mesh_.points.size()) return fail("a quad names a node that is not there", domain_.box.lo);
        const Point p = mesh_.points[q[i]];
        if (!std::isfinite(p.x) || !std::isfinite(p.y)) return fail("a node has no finite coordinates", p);
      }
    for (const auto& q : mesh_.quads)
      for (int i = 0; i < 4; ++i) {
        const Point p = mesh_.points[q[i]];
        if (orientation(mesh_.points[q[(i + 3) % 4]], p, mesh_.points[q[(i + 1) % 4]]) <= 0)
          return fail("a quad is not convex", p);
      }
  }

  // No node stands alone, no two at one place.
  void check_nodes() {
    std::vector<std::uint8_t> used(mesh_.points.size(), 0);
    for (const auto& q : mesh_.quads)
      for (const NodeIndex v : q) used[v] = 1;
    order_.resize(mesh_.points.size());
    for (std::size_t i = 0; i < order_.size(); ++i) {
      order_[i] = static_cast<NodeIndex>(i);
      if (!used[i]) return fail("a node belongs to no quad", mesh_.points[i]);
    }
    std::sort(order_.begin(), order_.end(),
              [&](NodeIndex i, NodeIndex j) { return before(mesh_.points[i], mesh_.points[j]); });
    for (std::size_t i = 1; i < order_.size(); ++i)
      if (mesh_.points[order_[i]] == mesh_.points[order_[i - 1]])
        return fail("two nodes lie at one place", mesh_.points[order_[i]]);
  }

  // Conforming: an edge has two faces on different sides, or one on a boundary curve; each curve edge is there.
  void check_edges() {
    struct Use {
      Edge edge;
      bool forward;
    };
    std::vector<Use> uses;
    uses.reserve(4 * mesh_.quads.size());
    for (const auto& q : mesh_.quads)
      for (int i = 0; i < 4; ++i) uses.push_back({edge(q[i], q[(i + 1) % 4]), q[i] < q[(i + 1) % 4]});
    std::sort(uses.begin(), uses.end(),
              [](const Use& s, const Use& t) { return s.edge != t.edge ? s.edge < t.edge : s.forward < t.forward; });
    std::vector<Edge> rim;
    for (std::size_t i = 0; i < uses.size();) {
      std::size_t j = i + 1;
      while (j < uses.size() && uses[j].edge == uses[i].edge) ++j;
      if (j - i > 2 || (j - i == 2 && uses[i].forward == uses[i + 1].forward))
        return fail("an edge has more than two faces, or two on one side", mesh_.points[uses[i].edge.a]);
      if (j - i == 1) rim.push_back(uses[i].edge);
      i = j;
    }
    std::vector<Edge> boundary;
    for (const EdgeSet& set : mesh_.curves)
      for (const auto& [a, b] : set.edges) {
        const Edge e = edge(a, b);
        const auto found =
            std::lower_bound(uses.begin(), uses.end(), e, [](const Use& u, Edge x) { return u.edge < x; });
        if (found == uses.end() || found->edge != e)
          return fail("'" + set.name + "' has an edge that is no side of a quad", mesh_.points[a]);
        if (set.kind != CurveKind::Line && std::binary_search(rim.begin(), rim.end(), e)) boundary.push_back(e);
      }
    std::sort(boundary.begin(), boundary.end());
    boundary.erase(std::unique(boundary.begin(), boundary.end()), boundary.end());
    for (const Edge e : rim)
      if (!std::binary_search(boundary.begin(), boundary.end(), e))
        return fail("an edge inside the domain has only one quad", mesh_.points[e.a]);
  }

  // The quads fill what the boundary edges enclose, once.
  void check_area() {
    double quads = 0, loops = 0, scale = 0;
    const Point origin = domain_.box.lo;
    for (const auto& q : mesh_.quads) {
      double area = 0;
      for (int i = 0; i < 4; ++i) area += twice_area(mesh_, q[i], q[(i + 1) % 4], origin);
      quads += area;
      scale += std::fabs(area);
    }
    for (std::size_t i = 0; i < domain_.paths.size() && i < mesh_.curves.size(); ++i) {
      if (domain_.paths[i].kind == CurveKind::Line) continue;
      std::size_t k = 0;
      for (const DirectedCurve& d : domain_.paths[i].curves) {
        const Domain::Curve& c = domain_.curves[d.curve];
        const VertexId end = d.reversed ? c.tail : c.head;
        double area = 0;
        for (; k < mesh_.curves[i].edges.size(); ++k) {
          const auto& [a, b] = mesh_.curves[i].edges[k];
          area += twice_area(mesh_, a, b, origin);
          if (mesh_.points[b] == domain_.vertices[end].at) break;
        }
        ++k;
        if (c.is_boundary()) loops += c.left.valid() != d.reversed ? area : -area;
      }
    }
    if (std::fabs(quads - loops) > kAreaError * scale)
      fail("the quads cover " + std::to_string(quads / loops) + " of the area inside the boundary", origin);
  }

  // Every curve is covered by edges from end to end, in order, with its nodes on it.
  void check_curves() {
    if (mesh_.curves.size() != domain_.paths.size()) return fail("a curve is missing", domain_.box.lo);
    for (std::size_t i = 0; i < domain_.paths.size(); ++i) check_path(domain_.paths[i], mesh_.curves[i]);
  }

  void check_path(const Domain::Path& path, const EdgeSet& set) {
    std::size_t k = 0;
    for (const DirectedCurve& d : path.curves) {
      const Domain::Curve& c = domain_.curves[d.curve];
      const CurvePiece piece = d.reversed ? reversed(c.piece) : c.piece;
      double s = 0;
      Point here = piece.a;
      const double total = length(piece);
      while (here != piece.b) {
        if (k == set.edges.size()) return fail("'" + path.name + "' is not covered by edges to its end", here);
        const auto& [a, b] = set.edges[k++];
        if (mesh_.points[a] != here) return fail("'" + path.name + "' has a gap", here);
        here = mesh_.points[b];
        const double next = here == piece.b ? total : project(piece, here);
        if (distance(here, point_at(piece, next)) > domain_.tolerance)
          return fail("a node of '" + path.name + "' lies off it", here);
        if (next <= s) return fail("the edges of '" + path.name + "' run back", here);
        s = next;
      }
    }
    if (k != set.edges.size()) fail("'" + path.name + "' has edges too many", mesh_.points[set.edges[k][0]]);
  }

  // Every vertex of the arrangement is a node, also each point constraint.
  void check_points() {
    const auto is_node = [&](Point p) {
      const auto found = std::lower_bound(order_.begin(), order_.end(), p,
                                          [&](NodeIndex i, Point x) { return before(mesh_.points[i], x); });
      return found != order_.end() && mesh_.points[*found] == p;
    };
    for (const Domain::Cell& cell : domain_.cells) {
      for (const VertexId v : cell.lone_points)
        if (!is_node(domain_.vertices[v].at)) return fail("a point constraint is no node", domain_.vertices[v].at);
      for (const auto& walk : cell.walks)
        for (const DirectedCurve& d : walk)
          if (const Point p = domain_.vertices[domain_.curves[d.curve].tail].at; !is_node(p))
            return fail("a corner of the domain is no node", p);
    }
    for (const Domain::PointUse& use : domain_.points)
      if (const Point p = domain_.vertices[use.vertex].at; !is_node(p)) fail("'" + use.name + "' is no node", p);
    if (mesh_.node_sets.size() != domain_.points.size()) fail("a named point is missing", domain_.box.lo);
  }

  static bool before(Point p, Point q) { return p.x != q.x ? p.x < q.x : p.y < q.y; }

  const Mesh& mesh_;
  const Domain& domain_;
  std::vector<NodeIndex> order_;  // nodes by place
  std::optional<Failure> failure_;
};

}  // namespace

std::optional<Failure> verify(const Mesh& mesh, const Domain& domain, Context& context) {
  context.progress("verify", 0);
  return Verifier(mesh, domain).run();
}

}  // namespace quadline
