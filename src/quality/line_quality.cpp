#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "base/constants.hpp"
#include "base/csr.hpp"
#include "base/elementary.hpp"
#include "geom/element.hpp"
#include "quadline/quality.hpp"
#include "quality/face_corners.hpp"
#include "quality/irregular_nodes.hpp"
#include "quality/mesh_edges.hpp"
#include "quality/quad_sums.hpp"

namespace quadline {

namespace {

// What all curves of a mesh share: the quads and edges at their nodes.
class CurveNodes {
 public:
  CurveNodes(const Mesh& mesh, const MeshEdges& edges)
      : is_curve_(edges.count() + 1, 0), place_(mesh.points.size(), kNone) {
    std::uint32_t n_places = 0;
    for (const EdgeSet& set : mesh.curves)
      for (const auto& edge : set.edges) {
        is_curve_[edges.find(edge[0], edge[1])] = 1;
        for (const NodeIndex v : edge)
          if (place_[v] == kNone) place_[v] = n_places++;
      }
    quads_.fill(n_places, [&](const auto& visit) {
      for (std::size_t i = 0; i < mesh.quads.size(); ++i)
        for (const NodeIndex v : mesh.quads[i])
          if (place_[v] != kNone) visit(place_[v], i);
    });
  }

  bool is_curve(std::size_t edge) const { return is_curve_[edge]; }
  std::span<const std::size_t> quads(NodeIndex v) const { return quads_[place_[v]]; }

 private:
  std::vector<std::uint8_t> is_curve_;  // of edges; the last: of those that the mesh has not
  std::vector<std::uint32_t> place_;    // of nodes among those on curves
  Rows<std::size_t> quads_;             // by place
};

class LineMeasure {
 public:
  LineMeasure(const Mesh& mesh, std::span<const double> size)
      : mesh_(mesh), size_(size), edges_(mesh), nodes_(mesh, edges_), is_irregular_(irregular_nodes(mesh, edges_)) {}

  LineQuality measure(const EdgeSet& set) const {
    LineQuality line{.name = set.name, .kind = set.kind, .n_edges = set.edges.size()};
    std::vector<NodeIndex> nodes;
    for (const auto& edge : set.edges) nodes.insert(nodes.end(), edge.begin(), edge.end());
    sort_unique(nodes);
    std::vector<std::size_t> quads;
    for (const NodeIndex v : nodes) {
      line.n_irregular += is_irregular_[v];
      const std::span<const std::size_t> round = nodes_.quads(v);
      quads.insert(quads.end(), round.begin(), round.end());
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
    QuadSums sums;
    line.min_angle_deg = 360;
    for (const std::size_t i : quads) {
      const QuadPoints p = corners(mesh_, mesh_.quads[i]);
      sums.add(quad_distortion(p), scaled_jacobian(p));
      for (std::size_t k = 0; k < 4; ++k) {
        const double angle = corner_angle(p[(k + 3) % 4], p[k], p[(k + 1) % 4]) * kDegreesPerRadian;
        line.min_angle_deg = std::min(line.min_angle_deg, angle);
        line.max_angle_deg = std::max(line.max_angle_deg, angle);
      }
    }
    line.beta_min = sums.beta_min();
    line.beta_mean = sums.beta_mean();
    line.scaled_jacobian_min = sums.jacobian_min();
    line.scaled_jacobian_mean = sums.jacobian_mean();
  }

  void add_lengths(const EdgeSet& set, LineQuality& line) const {
    if (size_.empty() || set.edges.empty()) return;
    LengthToSize& r = line.edge_to_size.emplace();
    std::size_t n = 0;
    for (const auto& [a, b] : set.edges) {
      const std::size_t e = edges_.find(a, b);
      if (e == edges_.count()) continue;
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
      for (const std::size_t q : nodes_.quads(v)) {
        const auto& quad = mesh_.quads[q];
        const auto corner = static_cast<std::size_t>(std::find(quad.begin(), quad.end(), v) - quad.begin());
        const NodeIndex next = quad[(corner + 1) % 4];
        if (nodes_.is_curve(edges_.find(v, next))) continue;
        const Point rung = direction(v, next);
        sum += arc_tangent(std::abs(dot(along, rung)), std::abs(cross(along, rung))) * kDegreesPerRadian;
        ++n;
      }
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
  MeshEdges edges_;
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
