#include "quad_shapes.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

namespace quadline::shapes {

namespace {

// Numbers that are the same everywhere.
class Random {
 public:
  explicit Random(std::uint32_t seed) : state_(seed * 2654435761u + 12345u) {}
  std::uint32_t next() {
    state_ ^= state_ << 13;
    state_ ^= state_ >> 17;
    state_ ^= state_ << 5;
    return state_;
  }
  double unit() { return next() / 4294967296.0; }

 private:
  std::uint32_t state_;
};

}  // namespace

WorkMesh quad_mesh(const std::vector<Point>& points, const QuadList& quads, const EdgeList& lines) {
  std::vector<Polygon> polygons;
  for (const auto& q : quads) polygons.emplace_back(NodeId(q[0]), NodeId(q[1]), NodeId(q[2]), NodeId(q[3]));
  Topology topo;
  topo.build(points.size(), polygons);
  std::vector<NodeTag> tags(points.size());
  for (std::size_t i = 0; i < topo.edge_capacity(); ++i) {
    const HalfId h = half_of(EdgeId(i));
    if (topo.face(h).valid() && topo.face(twin(h)).valid()) continue;
    const HalfId out = topo.face(h).valid() ? twin(h) : h;
    const Point a = points[topo.tail(out).value], b = points[topo.head(out).value];
    const Point c = points[topo.head(topo.next(out)).value];
    const double turn = std::abs(cross(b - a, c - b)) / (norm(b - a) * norm(c - b));
    const bool corner = turn > 0.3 || dot(b - a, c - b) < 0;
    tags[topo.head(out).value].kind = corner ? NodeKind::Fixed : NodeKind::OnCurve;
  }
  std::map<std::uint32_t, int> ends;
  for (const auto& [a, b] : lines) {
    ++ends[a];
    ++ends[b];
  }
  for (const auto& [v, n] : ends)
    tags[v].kind = n == 2 && tags[v].kind == NodeKind::Free ? NodeKind::OnCurve : NodeKind::Fixed;
  WorkMesh mesh;
  mesh.build(points, tags, polygons);
  const Topology& t = mesh.topo();
  for (std::size_t i = 0; i < t.face_capacity(); ++i) mesh.set_cell(FaceId(i), CellId(0));
  for (std::size_t i = 0; i < t.edge_capacity(); ++i)
    if (mesh.is_boundary(EdgeId(i))) mesh.set_curve(EdgeId(i), CurveId(0));
  for (const auto& [a, b] : lines) mesh.set_curve(edge_of(t.find(NodeId(a), NodeId(b))), CurveId(1));
  return mesh;
}

WorkMesh grid(int nx, int ny, double h, const EdgeList& lines) {
  std::vector<Point> points;
  QuadList quads;
  const auto id = [&](int i, int j) { return static_cast<std::uint32_t>(j * (nx + 1) + i); };
  for (int j = 0; j <= ny; ++j)
    for (int i = 0; i <= nx; ++i) points.push_back({h * i, h * j});
  for (int j = 0; j < ny; ++j)
    for (int i = 0; i < nx; ++i) quads.push_back({id(i, j), id(i + 1, j), id(i + 1, j + 1), id(i, j + 1)});
  return quad_mesh(points, quads, lines);
}

WorkMesh split_triangles(int n, double h, std::uint32_t seed, bool line) {
  Random random(seed);
  std::vector<Point> points;
  const auto id = [&](int i, int j) { return static_cast<std::uint32_t>(j * (n + 1) + i); };
  const int row = n / 2;
  for (int j = 0; j <= n; ++j) {
    for (int i = 0; i <= n; ++i) {
      Point p{h * i, h * j};
      const bool inner = i > 0 && j > 0 && i < n && j < n;
      if (inner && !(line && j == row)) p += 0.4 * h * Point{random.unit() - 0.5, random.unit() - 0.5};
      points.push_back(p);
    }
  }
  std::map<std::array<std::uint32_t, 2>, std::uint32_t> middles;
  const auto middle = [&](std::uint32_t a, std::uint32_t b) {
    const auto [at, is_new] = middles.try_emplace({std::min(a, b), std::max(a, b)}, points.size());
    if (is_new) points.push_back(midpoint(points[a], points[b]));
    return at->second;
  };
  QuadList quads;
  const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    const std::uint32_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
    const auto m = static_cast<std::uint32_t>(points.size());
    points.push_back((1.0 / 3) * (points[a] + points[b] + points[c]));
    quads.push_back({a, ab, m, ca});
    quads.push_back({b, bc, m, ab});
    quads.push_back({c, ca, m, bc});
  };
  for (int j = 0; j < n; ++j) {
    for (int i = 0; i < n; ++i) {
      const std::uint32_t a = id(i, j), b = id(i + 1, j), c = id(i + 1, j + 1), d = id(i, j + 1);
      if (random.next() % 2 == 0) {
        add(a, b, c);
        add(a, c, d);
      } else {
        add(a, b, d);
        add(b, c, d);
      }
    }
  }
  EdgeList lines;
  for (int i = n / 4; line && i < n - n / 4; ++i) {
    const std::uint32_t a = id(i, row), b = id(i + 1, row);
    lines.push_back({a, middle(a, b)});
    lines.push_back({middle(a, b), b});
  }
  return quad_mesh(points, quads, lines);
}

WorkMesh turned_grid(int nx, int ny, double h, double share, std::uint32_t seed, bool line) {
  Random random(seed);
  EdgeList lines;
  const auto node = [&](int i, int j) { return static_cast<std::uint32_t>(j * (nx + 1) + i); };
  for (int i = nx / 4; line && i < nx - nx / 4; ++i) lines.push_back({node(i, ny / 2), node(i + 1, ny / 2)});
  WorkMesh mesh = grid(nx, ny, h, lines);
  const std::size_t n_edges = mesh.topo().edge_count();
  std::vector<FaceId> made;
  for (std::size_t i = 0; i < n_edges; ++i) {
    const Topology& topo = mesh.topo();
    const HalfId e = half_of(EdgeId(i)), t = twin(e);
    const bool left = random.next() % 2 == 0;
    if (random.unit() > share || mesh.is_constraint(e)) continue;
    const NodeId a = topo.tail(e), b = topo.head(e);
    const NodeId c = topo.head(topo.next(e)), d = topo.tail(topo.prev(e));
    const NodeId f = topo.head(topo.next(t)), g = topo.tail(topo.prev(t));
    // The hexagon is b c d a f g, cut by a-b; valences of two stay out of the mesh.
    if (topo.edge_valence(a) < 4 || topo.edge_valence(b) < 4) continue;
    if (topo.find(c, f).valid() || topo.find(d, g).valid()) continue;
    const std::array<FaceId, 2> faces{topo.face(e), topo.face(t)};
    if (left)
      mesh.replace_cavity(faces, std::vector<Polygon>{{f, c, d, a}, {c, f, g, b}}, made);
    else
      mesh.replace_cavity(faces, std::vector<Polygon>{{d, a, f, g}, {g, b, c, d}}, made);
  }
  return mesh;
}

SizeField constant_size(double h) {
  Domain domain;
  domain.size = h;
  domain.box = {{0, 0}, {1, 1}};
  Context context;
  return make_size_field(domain, Options{}, context);
}

Figures figures(const WorkMesh& mesh) {
  const Topology& topo = mesh.topo();
  Figures f;
  f.n_nodes = topo.node_count();
  double sum = 0;
  for (std::size_t i = 0; i < topo.face_capacity(); ++i) {
    if (!topo.is_live(FaceId(i))) continue;
    const QuadPoints q = mesh.quad_points(FaceId(i));
    ++f.n_quads;
    const double jacobian = scaled_jacobian(q);
    f.least_jacobian = std::min(f.least_jacobian, jacobian);
    sum += std::log(jacobian > 0 ? std::max(1e-3, quad_distortion(q)) : 1e-3);
  }
  f.mean_beta = std::exp(sum / static_cast<double>(f.n_quads));
  for (std::size_t i = 0; i < topo.node_capacity(); ++i) {
    const NodeId v(i);
    if (!topo.is_live(v)) continue;
    bool irregular = mesh.is_free(v) && topo.edge_valence(v) != 4;
    mesh.for_each_sector(v, [&](HalfId first, HalfId last, Angle angle) {
      int n = 1;
      for (HalfId h = topo.rotate_ccw(first); h != last; h = topo.rotate_ccw(h)) ++n;
      const double quarters = radians(angle) * 2 / std::numbers::pi,
                   tie = 2.0 / 90;  // within two degrees of a tie both will do
      const long least = std::max(1L, std::lround(quarters - tie)), most = std::max(1L, std::lround(quarters + tie));
      if (n < least || n > most) irregular = true;
    });
    f.n_irregular += irregular;
  }
  f.irregular_share = static_cast<double>(f.n_irregular) / static_cast<double>(f.n_nodes);
  return f;
}

std::vector<std::array<Point, 2>> constraint_edges(const WorkMesh& mesh) {
  const Topology& topo = mesh.topo();
  std::vector<std::array<Point, 2>> edges;
  const auto less = [](Point a, Point b) { return a.x != b.x ? a.x < b.x : a.y < b.y; };
  for (std::size_t i = 0; i < topo.edge_capacity(); ++i) {
    const EdgeId e(i);
    if (!topo.is_live(e) || !mesh.is_constraint(e)) continue;
    Point a = mesh.point(topo.tail(half_of(e))), b = mesh.point(topo.head(half_of(e)));
    if (less(b, a)) std::swap(a, b);
    edges.push_back({a, b});
  }
  std::sort(edges.begin(), edges.end(),
            [&](const auto& l, const auto& r) { return l[0] == r[0] ? less(l[1], r[1]) : less(l[0], r[0]); });
  return edges;
}

double area(const WorkMesh& mesh) {
  double sum = 0;
  for (std::size_t i = 0; i < mesh.topo().face_capacity(); ++i) {
    if (!mesh.topo().is_live(FaceId(i))) continue;
    const QuadPoints q = mesh.quad_points(FaceId(i));
    sum += 0.5 * (twice_area(q[0], q[1], q[2]) + twice_area(q[0], q[2], q[3]));
  }
  return sum;
}

void smooth_simply(WorkMesh& mesh, int sweeps) {
  const Topology& topo = mesh.topo();
  const auto worst = [&](NodeId v) {
    double least = 1;
    topo.for_each_out(v, [&](HalfId h) { least = std::min(least, scaled_jacobian(mesh.quad_points(topo.face(h)))); });
    return least;
  };
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    for (std::size_t i = 0; i < topo.node_capacity(); ++i) {
      const NodeId v(i);
      if (!topo.is_live(v) || !mesh.is_free(v)) continue;
      Point sum;
      topo.for_each_out(v, [&](HalfId h) { sum += mesh.point(topo.head(h)); });
      const Point old = mesh.point(v);
      const double before = worst(v);
      mesh.move(v, (1.0 / topo.edge_valence(v)) * sum);
      if (worst(v) < std::min(before, 0.5)) mesh.move(v, old);
    }
  }
}

}  // namespace quadline::shapes
