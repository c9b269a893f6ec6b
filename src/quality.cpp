#include "quadline/quality.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "geom/element.hpp"

namespace quadline {

namespace {

struct Side {
  NodeIndex a, b;  // a < b
  std::uint32_t face;
  std::uint8_t corner;  // of the face, where the edge starts
  bool forward;         // the face walks from a to b
};

bool same_edge(const Side& s, const Side& t) { return s.a == t.a && s.b == t.b; }

// All sides of all faces, equal edges beside each other: by the lower node through counting, then each node's few.
std::vector<Side> sorted_sides(const Mesh& mesh) {
  const auto for_each_side = [&](auto visit) {
    std::uint32_t face = 0;
    const auto walk = [&](const auto& nodes) {
      for (std::size_t i = 0; i < nodes.size(); ++i) {
        const NodeIndex p = nodes[i], q = nodes[(i + 1) % nodes.size()];
        visit(Side{std::min(p, q), std::max(p, q), face, static_cast<std::uint8_t>(i), p < q});
      }
      ++face;
    };
    for (const auto& q : mesh.quads) walk(q);
    for (const auto& t : mesh.triangles) walk(t);
  };
  std::vector<std::size_t> first(mesh.points.size() + 1, 0);
  for_each_side([&](const Side& s) { ++first[s.a + 1]; });
  for (std::size_t i = 1; i < first.size(); ++i) first[i] += first[i - 1];
  std::vector<Side> sides(first.back());
  std::vector<std::size_t> fill = first;
  for_each_side([&](const Side& s) { sides[fill[s.a]++] = s; });
  for (std::size_t v = 0; v + 1 < first.size(); ++v) {
    std::sort(sides.data() + first[v], sides.data() + first[v + 1],
              [](const Side& s, const Side& t) { return s.b != t.b ? s.b < t.b : s.face < t.face; });
  }
  return sides;
}

std::vector<std::array<NodeIndex, 2>> unique_edges(const std::vector<Side>& sides) {
  std::vector<std::array<NodeIndex, 2>> edges;
  for (std::size_t i = 0; i < sides.size(); ++i)
    if (i == 0 || !same_edge(sides[i], sides[i - 1])) edges.push_back({sides[i].a, sides[i].b});
  return edges;
}

// Percentiles without sorting it all; `values` is left in another order.
Statistics statistics(std::vector<double>& values) {
  Statistics s;
  if (values.empty()) return s;
  for (const double v : values) s.mean += v;
  s.mean /= static_cast<double>(values.size());
  std::size_t done = 0;  // values before it are in their places
  const auto value_at = [&](std::size_t i) {
    if (i >= done)
      std::nth_element(values.begin() + static_cast<std::ptrdiff_t>(done),
                       values.begin() + static_cast<std::ptrdiff_t>(i), values.end());
    done = std::max(done, i + 1);
    return values[i];
  };
  const auto at = [&](double part) {  // linear between the neighbours
    const double place = part * static_cast<double>(values.size() - 1);
    const std::size_t i = static_cast<std::size_t>(place);
    const double low = value_at(i), high = value_at(std::min(i + 1, values.size() - 1));
    return low + (place - static_cast<double>(i)) * (high - low);
  };
  s.min = at(0);
  s.p1 = at(0.01);
  s.p5 = at(0.05);
  s.median = at(0.5);
  s.p95 = at(0.95);
  s.p99 = at(0.99);
  s.max = at(1);
  return s;
}

QuadPoints points_of(const Mesh& mesh, const std::array<NodeIndex, 4>& q) {
  return {mesh.points[q[0]], mesh.points[q[1]], mesh.points[q[2]], mesh.points[q[3]]};
}

// Counts the nodes whose number of faces does not suit them. Corners of faces are joined across edges that are no
// curve: each group so made is a wedge between curves, or all that is round an inner node.
class Irregularity {
 public:
  Irregularity(const Mesh& mesh, const std::vector<Side>& sides) : mesh_(mesh), sides_(sides) {}

  std::size_t count() {
    mark_curves();
    join_wedges();
    const std::size_t n_corners = group_.size();
    std::vector<double> angle(n_corners, 0);
    std::vector<std::uint32_t> faces(n_corners, 0);
    std::vector<std::uint8_t> bad(mesh_.points.size(), 0);
    for (std::size_t c = 0; c < n_corners; ++c) {
      const std::size_t g = find(c);
      angle[g] += corner(c);
      ++faces[g];
    }
    for (std::size_t c = 0; c < n_corners; ++c) {
      if (find(c) != c) continue;
      const NodeIndex v = node(c);
      bad[v] |= on_curve_[v] ? !suits(angle[c], faces[c]) : faces[c] != 4;
    }
    return static_cast<std::size_t>(std::count(bad.begin(), bad.end(), 1));
  }

 private:
  static bool suits(double angle, std::uint32_t faces) {
    const double degrees = angle * 180 / std::numbers::pi;
    const double least = std::max(1.0, std::round((degrees - 2) / 90)),
                 most = std::max(1.0, std::round((degrees + 2) / 90));
    return faces >= least && faces <= most;
  }

  void mark_curves() {
    on_curve_.assign(mesh_.points.size(), 0);
    std::vector<std::array<NodeIndex, 2>> curve_edges;
    for (const EdgeSet& set : mesh_.curves)
      for (const auto& [a, b] : set.edges) curve_edges.push_back({std::min(a, b), std::max(a, b)});
    std::sort(curve_edges.begin(), curve_edges.end());
    curve_.assign(sides_.size(), 0);
    for (std::size_t i = 0; i < sides_.size(); ++i) {
      const Side& s = sides_[i];
      const bool shared =
          (i > 0 && same_edge(s, sides_[i - 1])) || (i + 1 < sides_.size() && same_edge(s, sides_[i + 1]));
      curve_[i] =
          !shared || std::binary_search(curve_edges.begin(), curve_edges.end(), std::array<NodeIndex, 2>{s.a, s.b});
      if (curve_[i]) on_curve_[s.a] = on_curve_[s.b] = 1;
    }
  }

  std::size_t n_quads() const { return mesh_.quads.size(); }
  std::size_t first_corner(std::size_t face) const {
    return face < n_quads() ? 4 * face : 4 * n_quads() + 3 * (face - n_quads());
  }
  std::size_t n_sides(std::size_t face) const { return face < n_quads() ? 4 : 3; }
  NodeIndex node_at(std::size_t face, std::size_t i) const {
    return face < n_quads() ? mesh_.quads[face][i] : mesh_.triangles[face - n_quads()][i];
  }
  std::size_t face_of(std::size_t corner) const {
    return corner < 4 * n_quads() ? corner / 4 : n_quads() + (corner - 4 * n_quads()) / 3;
  }
  NodeIndex node(std::size_t corner) const {
    const std::size_t f = face_of(corner);
    return node_at(f, corner - first_corner(f));
  }
  double corner(std::size_t c) const {
    const std::size_t f = face_of(c), n = n_sides(f), i = c - first_corner(f);
    return corner_angle(mesh_.points[node_at(f, (i + n - 1) % n)], mesh_.points[node_at(f, i)],
                        mesh_.points[node_at(f, (i + 1) % n)]);
  }

  void join_wedges() {
    group_.resize(4 * mesh_.quads.size() + 3 * mesh_.triangles.size());
    for (std::size_t c = 0; c < group_.size(); ++c) group_[c] = static_cast<std::uint32_t>(c);
    const auto corner_at = [&](const Side& s, bool at_a) {
      const std::size_t i = s.corner, n = n_sides(s.face);
      return first_corner(s.face) + (s.forward == at_a ? i : (i + 1) % n);
    };
    for (std::size_t i = 1; i < sides_.size(); ++i) {
      if (curve_[i] || !same_edge(sides_[i], sides_[i - 1])) continue;
      for (const bool at_a : {true, false}) {
        const std::size_t p = find(corner_at(sides_[i], at_a)), q = find(corner_at(sides_[i - 1], at_a));
        group_[std::max(p, q)] = static_cast<std::uint32_t>(std::min(p, q));
      }
    }
  }
  std::size_t find(std::size_t c) {
    while (group_[c] != c) c = group_[c] = group_[group_[c]];
    return c;
  }

  const Mesh& mesh_;
  const std::vector<Side>& sides_;
  std::vector<std::uint8_t> curve_, on_curve_;  // of sides; of nodes
  std::vector<std::uint32_t> group_;            // of corners: union-find
};

}  // namespace

std::string_view verdict(double beta) {
  if (beta < 0.36) return "unacceptable";
  if (beta < 0.54) return "marginal";
  return beta < 0.72 ? "good" : "excellent";
}

double distortion(Point a, Point b, Point c, Point d) { return quad_distortion({a, b, c, d}); }

std::vector<std::array<NodeIndex, 2>> edges_of(const Mesh& mesh) { return unique_edges(sorted_sides(mesh)); }

Quality measure(const Mesh& mesh, std::span<const double> size) {
  Quality q;
  q.n_nodes = mesh.points.size();
  q.n_quads = mesh.quads.size();
  q.n_triangles = mesh.triangles.size();
  std::vector<double> jacobian, least, greatest, aspect;
  double log_beta = 0;
  q.beta_min = 1;
  for (const auto& quad : mesh.quads) {
    const QuadPoints p = points_of(mesh, quad);
    const double beta = quad_distortion(p);
    log_beta += std::log(std::max(beta, 1e-12));
    q.beta_min = std::min(q.beta_min, beta);
    jacobian.push_back(scaled_jacobian(p));
    if (jacobian.back() <= 0) ++q.n_inverted;
    double low = 360, high = 0, shortest = 0, longest = 0;
    for (int i = 0; i < 4; ++i) {
      const double angle = corner_angle(p[(i + 3) % 4], p[i], p[(i + 1) % 4]) * 180 / std::numbers::pi;
      low = std::min(low, angle);
      high = std::max(high, angle);
      const double length = distance(p[i], p[(i + 1) % 4]);
      shortest = i == 0 ? length : std::min(shortest, length);
      longest = std::max(longest, length);
    }
    least.push_back(low);
    greatest.push_back(high);
    aspect.push_back(shortest > 0 ? longest / shortest : 1e12);
  }
  if (mesh.quads.empty()) q.beta_min = 0;
  q.beta_mean = mesh.quads.empty() ? 0 : std::exp(log_beta / static_cast<double>(mesh.quads.size()));
  q.scaled_jacobian = statistics(jacobian);
  q.min_angle_deg = statistics(least);
  q.max_angle_deg = statistics(greatest);
  q.aspect = statistics(aspect);
  std::vector<double> lengths, ratios;
  const std::vector<Side> sides = sorted_sides(mesh);
  const auto edges = unique_edges(sides);
  for (std::size_t i = 0; i < edges.size(); ++i) {
    lengths.push_back(distance(mesh.points[edges[i][0]], mesh.points[edges[i][1]]));
    if (!size.empty()) ratios.push_back(lengths.back() / size[i]);
  }
  q.edge_length = statistics(lengths);
  if (!size.empty()) q.edge_to_size = statistics(ratios);
  q.n_irregular = Irregularity(mesh, sides).count();
  return q;
}

}  // namespace quadline
