// The conforming split of mixed meshes [Rank1993]. A straight triangle gives three convex quads, a convex quad four,
// however thin they are. We differ beside arcs that bend into a face: its centre keeps clear of them.
#include "stages/halve/halve.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "geom/predicates.hpp"
#include "quality/limits.hpp"

namespace quadline {

namespace {

// Least sine of a corner; not positive where the triangle is not counter-clockwise.
double least_sine(Point a, Point b, Point c) {
  if (orientation(a, b, c) <= 0) return 0;
  const double ab = distance(a, b), bc = distance(b, c), ca = distance(c, a);
  return twice_area(a, b, c) / std::max({ab * bc, bc * ca, ca * ab});
}

// The corner from which the better diagonal starts; -1: none lies inside.
int better_diagonal(const WorkMesh& mesh, FaceId f) {
  const QuadPoints p = mesh.quad_points(f);
  const Polygon q = mesh.topo().polygon(f);
  int best = -1;
  double most = 0;
  for (int k = 0; k < 2; ++k) {
    if (mesh.topo().find(q.nodes[k], q.nodes[k + 2]).valid()) continue;  // two faces would lie on one side of it
    const double least = std::min(least_sine(p[k], p[k + 1], p[k + 2]), least_sine(p[k], p[k + 2], p[(k + 3) % 4]));
    if (least <= most) continue;
    most = least;
    best = k;
  }
  return best;
}

void cut_thin_quads(WorkMesh& mesh) {
  const Topology& topo = mesh.topo();
  std::vector<FaceId> made;
  for (const FaceId f : topo.faces()) {
    if (topo.is_triangle(f) || scaled_jacobian(mesh.quad_points(f)) > kThinJacobian) continue;
    const int k = better_diagonal(mesh, f);
    if (k < 0) continue;
    const Polygon q = topo.polygon(f);
    const std::array<Polygon, 2> halves{Polygon(q.nodes[k], q.nodes[k + 1], q.nodes[k + 2]),
                                        Polygon(q.nodes[k], q.nodes[k + 2], q.nodes[(k + 3) % 4])};
    mesh.replace_cavity(std::array{f}, halves, made);
  }
}

// The middle of a segment along its curve.
struct Middle {
  Point at;
  double s;
  bool is_forward;  // a comes before b on the curve
};

Middle middle_of(const WorkMesh& mesh, const Domain& domain, NodeId a, NodeId b, CurveId c) {
  const CurvePiece& piece = domain.curves[c].piece;
  const double sa = project(piece, mesh.point(a)), sb = project(piece, mesh.point(b)), s = 0.5 * (sa + sb);
  return {point_at(piece, s), s, sa < sb};
}

// Cuts off what of a convex polygon lies on the right of the line from a to b.
void clip(std::vector<Point>& polygon, Point a, Point b) {
  std::vector<Point> kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point p = polygon[i], q = polygon[(i + 1) % polygon.size()];
    const double at_p = twice_area(a, b, p), at_q = twice_area(a, b, q);
    if (at_p >= 0) kept.push_back(p);
    if ((at_p < 0) != (at_q < 0)) kept.push_back(p + (at_p / (at_p - at_q)) * (q - p));
  }
  polygon = std::move(kept);
}

Point mean(std::span<const Point> points) {
  Point sum;
  for (const Point p : points) sum += p;
  return (1.0 / static_cast<double>(points.size())) * sum;
}

class Halving {
 public:
  Halving(WorkMesh& mesh, const Domain& domain) : mesh_(mesh), domain_(domain) {}

  void run() {
    keep_nodes();
    for (const EdgeId e : topo().edges()) add_middle(e);
    for (const FaceId f : topo().faces()) add_quads(f);
    mesh_.build(std::move(points_), std::move(tags_), quads_);
    for (std::size_t i = 0; i < cells_.size(); ++i) mesh_.set_cell(FaceId(i), cells_[i]);
    for (const Segment& s : segments_) mesh_.set_curve(edge_of(topo().find(s.a, s.b)), s.curve);
    mesh_.set_segments(std::move(segments_));
  }

 private:
  const Topology& topo() const { return mesh_.topo(); }

  NodeId add_node(Point p, const NodeTag& tag) {
    points_.push_back(p);
    tags_.push_back(tag);
    return NodeId(points_.size() - 1);
  }

  void keep_nodes() {
    for (const NodeId v : topo().nodes()) add_node(mesh_.point(v), mesh_.tag(v));
  }

  void add_middle(EdgeId e) {
    const NodeId a = topo().tail(half_of(e)), b = topo().head(half_of(e));
    if (!mesh_.is_constraint(e)) {
      middle_.push_back(add_node(midpoint(mesh_.point(a), mesh_.point(b)), {}));
      return;
    }
    const CurveId c = mesh_.curve(e);
    const Middle middle = middle_of(mesh_, domain_, a, b, c);
    const NodeId m = add_node(middle.at, {NodeKind::OnCurve, c, middle.s, VertexId()});
    middle_.push_back(m);
    segments_.push_back({middle.is_forward ? a : b, m, c});
    segments_.push_back({m, middle.is_forward ? b : a, c});
  }

  void add_quads(FaceId f) {
    std::array<NodeId, 4> corner, middle;
    int n = 0;
    bool is_bent = false;
    topo().for_each_half(f, [&](HalfId h) {
      corner[n] = topo().tail(h);
      middle[n] = middle_[edge_of(h)];
      is_bent = is_bent || (mesh_.is_constraint(h) && domain_.curves[mesh_.curve(edge_of(h))].piece.is_arc());
      ++n;
    });
    const std::span corners(corner.data(), static_cast<std::size_t>(n)), middles(middle.data(), corners.size());
    const NodeId centre = add_node(centre_of(corners, middles, is_bent), {});
    for (int k = 0; k < n; ++k) {
      quads_.push_back({corner[k], middle[k], centre, middle[(k + n - 1) % n]});
      cells_.push_back(mesh_.cell(f));
    }
  }

  // The mean of the middles; where they may lie off their edges, of the part of their polygon from which all quads are
  // convex.
  Point centre_of(std::span<const NodeId> corners, std::span<const NodeId> middles, bool is_bent) const {
    std::vector<Point> polygon;
    for (const NodeId m : middles) polygon.push_back(points_[m.value]);
    const Point usual = mean(polygon);
    if (!is_bent) return usual;
    for (std::size_t k = 0; k < corners.size(); ++k) {
      const Point a = points_[corners[k].value], m = points_[middles[k].value];
      const Point b = points_[corners[(k + 1) % corners.size()].value];
      clip(polygon, a, m);
      clip(polygon, m, b);
    }
    return polygon.size() < 3 ? usual : mean(polygon);
  }

  WorkMesh& mesh_;
  const Domain& domain_;
  std::vector<Point> points_;
  std::vector<NodeTag> tags_;
  std::vector<Polygon> quads_;
  std::vector<CellId> cells_;
  IdVector<EdgeId, NodeId> middle_;
  std::vector<Segment> segments_;
};

}  // namespace

void halve(WorkMesh& mesh, const Domain& domain, Context& context) {
  context.progress("halve", 0);
  cut_thin_quads(mesh);
  mesh.compact();
  Halving(mesh, domain).run();
  mesh.sort_in_space();
  context.progress("halve", 1);
}

void halve_segments(WorkMesh& mesh, const Domain& domain, const std::vector<CurveId>& curves) {
  IdVector<CurveId, std::uint8_t> is_halved(domain.curves.count(), 0);
  for (const CurveId c : curves) is_halved[c] = 1;
  std::vector<Segment> segments;
  for (const Segment& s : mesh.segments()) {
    if (!is_halved[s.curve]) {
      segments.push_back(s);
      continue;
    }
    const Middle middle = middle_of(mesh, domain, s.a, s.b, s.curve);
    const NodeId m = mesh.add_node(middle.at, {NodeKind::OnCurve, s.curve, middle.s, VertexId()});
    segments.push_back({s.a, m, s.curve});
    segments.push_back({m, s.b, s.curve});
  }
  mesh.set_segments(std::move(segments));
}

}  // namespace quadline
