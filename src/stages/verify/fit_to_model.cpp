#include "stages/verify/fit_to_model.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "base/constants.hpp"
#include "domain/whole_circle.hpp"
#include "geom/curve.hpp"
#include "quality/mesh_edges.hpp"
#include "search/box_tree.hpp"

namespace quadline {

namespace {

using Edge = std::array<NodeIndex, 2>;

std::vector<Box> boxes_of(const std::vector<Point>& points) {
  std::vector<Box> boxes;
  boxes.reserve(points.size());
  for (const Point p : points) boxes.push_back({p, p});
  return boxes;
}

class Fitter {
 public:
  Fitter(Mesh mesh, const Domain& domain)
      : mesh_(std::move(mesh)), domain_(domain), tree_(boxes_of(mesh_.points)), edges_(mesh_) {
    double sum = 0;
    for (std::size_t e = 0; e < edges_.count(); ++e) {
      const auto [a, b] = edges_.nodes(e);
      sum += distance(mesh_.points[a], mesh_.points[b]);
    }
    step_ = sum / static_cast<double>(std::max<std::size_t>(edges_.count(), 1));
  }

  Mesh run() {
    mesh_.curves.clear();
    mesh_.node_sets.clear();
    std::vector<std::vector<Edge>> of_curve;
    for (const Domain::Curve& curve : domain_.curves) of_curve.push_back(edges_along(curve.piece));
    for (const Domain::Path& path : domain_.paths) {
      EdgeSet set{path.name, path.kind, {}};
      for (const DirectedCurve& use : path.curves) append(of_curve[use.curve.value], use.reversed, set.edges);
      mesh_.curves.push_back(std::move(set));
    }
    for (const Domain::PointUse& use : domain_.points)
      if (const NodeIndex node = node_near(domain_.vertices[use.vertex].at); node != kNone)
        mesh_.node_sets.push_back({use.name, {node}});
    for (const Domain::Vertex& vertex : domain_.vertices)
      if (const NodeIndex node = node_near(vertex.at); node != kNone) mesh_.points[node] = vertex.at;
    return std::move(mesh_);
  }

 private:
  NodeIndex node_near(Point p) const {
    std::pair<double, NodeIndex> nearest{domain_.tolerance, kNone};
    tree_.query(inflated({p, p}, domain_.tolerance), [&](std::size_t i) {
      const auto node = static_cast<NodeIndex>(i);
      nearest = std::min(nearest, {distance(p, tree_.box_of(i).lo), node});
    });
    return nearest.second;
  }

  /// The edges between nodes that follow each other on the piece, from its start on.
  std::vector<Edge> edges_along(const CurvePiece& piece) const {
    // Short parts, for the boxes of long slanted ones hold the whole mesh.
    const double total = length(piece);
    const double n_parts = std::clamp(std::ceil(total / step_), 1.0, 1e6);
    std::vector<std::pair<double, NodeIndex>> nodes;
    Point start = piece.a;
    for (double i = 1; i <= n_parts; ++i) {
      const Point end = i == n_parts ? piece.b : point_at(piece, i / n_parts * total);
      const CurvePiece part = sub_piece(piece, (i - 1) / n_parts * total, i / n_parts * total, start, end);
      tree_.query(inflated(box(part), domain_.tolerance), [&](std::size_t node) {
        const Point p = mesh_.points[node];
        const double s = project(piece, p);
        if (distance(p, point_at(piece, s)) <= domain_.tolerance) nodes.push_back({s, static_cast<NodeIndex>(node)});
      });
      start = end;
    }
    std::sort(nodes.begin(), nodes.end());
    nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
    std::vector<Edge> along;
    for (std::size_t i = 1; i < nodes.size(); ++i) {
      const NodeIndex a = nodes[i - 1].second, b = nodes[i].second;
      if (edges_.find(a, b) != edges_.count()) along.push_back({a, b});
    }
    return along;
  }

  static void append(const std::vector<Edge>& edges, bool reversed, std::vector<Edge>& out) {
    if (!reversed) {
      out.insert(out.end(), edges.begin(), edges.end());
      return;
    }
    for (auto edge = edges.rbegin(); edge != edges.rend(); ++edge) out.push_back({(*edge)[1], (*edge)[0]});
  }

  Mesh mesh_;
  const Domain& domain_;
  BoxTree tree_;
  MeshEdges edges_;
  double step_ = 0;
};

// The nodes of a mesh that lie on a circle.
class NodesOnCircles {
 public:
  NodesOnCircles(const Mesh& mesh, double tolerance) : tree_(boxes_of(mesh.points)), tolerance_(tolerance) {}

  // The nearest to a place on it, but one; in a widening square.
  NodeIndex nearest(const WholeCircle& circle, Point to, NodeIndex but) const {
    for (double reach = kFirstReach * circle.radius;; reach *= 2) {
      std::pair<double, NodeIndex> found{reach, kNone};
      tree_.query(inflated({to, to}, reach), [&](std::size_t i) {
        const Point p = tree_.box_of(i).lo;
        if (i == but || std::abs(distance(p, circle.center) - circle.radius) > tolerance_) return;
        found = std::min(found, {distance(p, to), static_cast<NodeIndex>(i)});
      });
      if (found.second != kNone || reach > 2 * circle.radius) return found.second;
    }
  }

 private:
  static constexpr double kFirstReach = 1.0 / 16;  // of the radius
  BoxTree tree_;
  double tolerance_;
};

}  // namespace

Domain with_circles_turned_to(const Mesh& mesh, Domain domain) {
  const NodesOnCircles nodes(mesh, domain.tolerance);
  const WholeCircles circles(domain);
  for (const Domain::Cell& cell : domain.cells)
    for (const auto& walk : cell.walks) {
      const std::optional<WholeCircle> circle = circles.find(domain, walk);
      if (!circle) continue;
      const CurvePiece& piece = domain.curves[walk[0].curve].piece;
      const NodeIndex tail = nodes.nearest(*circle, piece.a, kNone), head = nodes.nearest(*circle, piece.b, tail);
      if (tail == kNone || head == kNone) continue;
      WholeCircles::turn(domain, walk, mesh.points[tail] - circle->center, mesh.points[head] - circle->center);
    }
  return domain;
}

Mesh fit_to_model(Mesh mesh, const Domain& domain) { return Fitter(std::move(mesh), domain).run(); }

}  // namespace quadline
