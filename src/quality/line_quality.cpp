#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>

#include "base/elementary.hpp"
#include "geom/element.hpp"
#include "quadline/quality.hpp"
#include "quality/irregular_nodes.hpp"
#include "quality/mesh_sides.hpp"

namespace quadline {

namespace {

constexpr double kDegrees = 180 / std::numbers::pi;
constexpr std::uint32_t kNowhere = UINT32_MAX;

// What all curves of a mesh share: the quads and edges at their nodes.
class CurveNodes {
 public:
  CurveNodes(const Mesh& mesh, const std::vector<std::array<NodeIndex, 2>>& edges) : place_(mesh.points.size()) {
    is_curve_.assign(edges.size(), 0);
    std::fill(place_.begin(), place_.end(), kNowhere);
    for (const EdgeSet& set : mesh.curves)
      for (const auto& edge : set.edges)
        for (const NodeIndex v : edge)
          if (place_[v] == kNowhere) place_[v] = n_places_++;
    first_.assign(n_places_ + 1, 0);
    for_each_corner(mesh, [&](std::size_t, NodeIndex v) { ++first_[place_[v] + 1]; });
    for (std::size_t i = 1; i < first_.size(); ++i) first_[i] += first_[i - 1];
    quads_.resize(first_.back());
    std::vector<std::size_t> fill = first_;
    for_each_corner(mesh, [&](std::size_t quad, NodeIndex v) { quads_[fill[place_[v]]++] = quad; });
  }

  void mark(std::size_t edge) { is_curve_[edge] = 1; }
  bool is_curve(std::size_t edge) const { return is_curve_[edge]; }

  template <class Visit>
  void for_each_quad(NodeIndex v, Visit visit) const {
    for (std::size_t i = first_[place_[v]]; i < first_[place_[v] + 1]; ++i) visit(quads_[i]);
  }

 private:
  template <class Visit>
  void for_each_corner(const Mesh& mesh, Visit visit) const {
    for (std::size_t i = 0; i < mesh.quads.size(); ++i)
      for (const NodeIndex v : mesh.quads[i])
        if (place_[v] != kNowhere) visit(i, v);
  }

  std::vector<std::uint32_t> place_;  // of nodes among those on curves
  std::uint32_t n_places_ = 0;
  std::vector<std::size_t> first_;  // by place: the first of its quads
  std::vector<std::size_t> quads_;
  std::vector<std::uint8_t> is_curve_;  // of edges
};

class LineMeasure {
 public:
  LineMeasure(const Mesh& mesh, std::span<const double> size)
      : mesh_(mesh),
        size_(size),
        sides_(sorted_sides(mesh)),
        edges_(unique_edges(sides_)),
        numbers_(edges_, mesh.points.size()),
        nodes_(mesh, edges_),
        is_irregular_(irregular_nodes(mesh, sides_)) {
    for (const EdgeSet& set : mesh.curves)
      for (const auto& [a, b] : set.edges)
        if (const std::size_t e = numbers_.find(a, b); e < numbers_.count()) nodes_.mark(e);
  }

  LineQuality measure(const EdgeSet& set) const {
    LineQuality line{.name = set.name, .kind = set.kind, .n_edges = set.edges.size()};
    std::vector<NodeIndex> nodes;
    for (const auto& edge : set.edges) nodes.insert(nodes.end(), edge.begin(), edge.end());
    sort_unique(nodes);
    std::vector<std::size_t> quads;
    for (const NodeIndex v : nodes) {
      line.n_irregular += is_irregular_[v];
      nodes_.for_each_quad(v, [&](std::size_t q) { quads.push_back(q); });
    }
    sort_unique(quads);
    add_quads(quads, line);
    add_lengths(set, line);
    add_off_normal(set, line);
    return line;
  }

 private:
  template <class T>
  static void sort_unique(std::vector<T>& values) {
    std::sort(values.begin(), values.end());
    values.erase(std::unique(values.begin(), values.end()), values.end());
  }

  void add_quads(const std::vector<std::size_t>& quads, LineQuality& line) const {
    line.n_quads = quads.size();
    if (quads.empty()) return;
    double log_beta = 0;
    line.beta_min = line.scaled_jacobian_min = 1;
    line.min_angle_deg = 360;
    for (const std::size_t i : quads) {
      const auto& q = mesh_.quads[i];
      const QuadPoints p{mesh_.points[q[0]], mesh_.points[q[1]], mesh_.points[q[2]], mesh_.points[q[3]]};
      const double beta = quad_distortion(p), jacobian = scaled_jacobian(p);
      log_beta += logarithm(std::max(beta, 1e-12));
      line.beta_min = std::min(line.beta_min, beta);
      line.scaled_jacobian_mean += jacobian;
      line.scaled_jacobian_min = std::min(line.scaled_jacobian_min, jacobian);
      for (std::size_t k = 0; k < 4; ++k) {
        const double angle = corner_angle(p[(k + 3) % 4], p[k], p[(k + 1) % 4]) * kDegrees;
        line.min_angle_deg = std::min(line.min_angle_deg, angle);
        line.max_angle_deg = std::max(line.max_angle_deg, angle);
      }
    }
    line.beta_mean = exponential(log_beta / static_cast<double>(quads.size()));
    line.scaled_jacobian_mean /= static_cast<double>(quads.size());
  }

  void add_lengths(const EdgeSet& set, LineQuality& line) const {
    if (size_.empty() || set.edges.empty()) return;
    LengthToSize& r = line.edge_to_size.emplace();
    std::size_t n = 0;
    for (const auto& [a, b] : set.edges) {
      const std::size_t e = numbers_.find(a, b);
      if (e == numbers_.count()) continue;
      const double ratio = distance(mesh_.points[a], mesh_.points[b]) / size_[e];
      r.min = n == 0 ? ratio : std::min(r.min, ratio);
      r.max = std::max(r.max, ratio);
      r.mean += ratio;
      ++n;
    }
    if (n > 0) r.mean /= static_cast<double>(n);
  }

  // The edges that leave the line between its ends, against its direction there: the mean of its two edges.
  void add_off_normal(const EdgeSet& set, LineQuality& line) const {
    double sum = 0;
    std::size_t n = 0;
    for (std::size_t i = 0; i < set.edges.size(); ++i) {
      const auto& before = set.edges[i];
      const auto& after = set.edges[(i + 1) % set.edges.size()];
      const NodeIndex v = before[1];
      if (after[0] != v) continue;  // an end
      const Point along = direction(before[0], v) + direction(v, after[1]);
      nodes_.for_each_quad(v, [&](std::size_t q) {
        const auto& quad = mesh_.quads[q];
        const auto corner = static_cast<std::size_t>(std::find(quad.begin(), quad.end(), v) - quad.begin());
        const NodeIndex next = quad[(corner + 1) % 4];
        if (nodes_.is_curve(numbers_.find(v, next))) return;
        const Point rung = direction(v, next);
        sum += arc_tangent(std::abs(dot(along, rung)), std::abs(cross(along, rung))) * kDegrees;
        ++n;
      });
    }
    if (n > 0) line.off_normal_deg = sum / static_cast<double>(n);
  }

  Point direction(NodeIndex a, NodeIndex b) const {
    const Point d = mesh_.points[b] - mesh_.points[a];
    const double length = norm(d);
    return length > 0 ? (1 / length) * d : d;
  }

  const Mesh& mesh_;
  std::span<const double> size_;
  std::vector<Side> sides_;
  std::vector<std::array<NodeIndex, 2>> edges_;
  EdgeNumbers numbers_;
  CurveNodes nodes_;
  std::vector<std::uint8_t> is_irregular_;
};

}  // namespace

std::vector<LineQuality> measure_lines(const Mesh& mesh, std::span<const double> size) {
  const LineMeasure measure(mesh, size);
  std::vector<LineQuality> lines;
  for (const EdgeSet& set : mesh.curves) lines.push_back(measure.measure(set));
  return lines;
}

}  // namespace quadline
