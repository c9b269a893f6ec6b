#include "quadline/quality.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/constants.hpp"
#include "geom/element.hpp"
#include "quality/face_corners.hpp"
#include "quality/irregular_nodes.hpp"
#include "quality/mesh_edges.hpp"
#include "quality/quad_sums.hpp"

namespace quadline {

namespace {

constexpr double kEndless = 1e12;  // a ratio over nothing

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

// Of the widths of two quads across the edge that they share, the greater over the lesser; for all such edges.
template <class Visit>
void for_each_growth(const Mesh& mesh, const MeshEdges& edges, Visit visit) {
  const auto width = [&](const Side& s) {
    const QuadPoints p = corners(mesh, mesh.quads[s.face]);
    const std::size_t i = s.corner;
    return distance(midpoint(p[i], p[(i + 1) % 4]), midpoint(p[(i + 2) % 4], p[(i + 3) % 4]));
  };
  for (std::size_t e = 0; e < edges.count(); ++e) {
    const std::span<const Side> sides = edges.sides(e);
    for (std::size_t i = 1; i < sides.size(); ++i) {
      const Side &s = sides[i - 1], &t = sides[i];
      if (s.face >= mesh.quads.size() || t.face >= mesh.quads.size()) continue;
      const double a = width(s), b = width(t), least = std::min(a, b);
      visit(s.face, t.face, least * kEndless > std::max(a, b) ? std::max(a, b) / least : kEndless);
    }
  }
}

}  // namespace

std::string_view verdict(double beta) {
  if (beta < 0.36) return "unacceptable";
  if (beta < 0.54) return "marginal";
  return beta < 0.72 ? "good" : "excellent";
}

double distortion(Point a, Point b, Point c, Point d) { return quad_distortion({a, b, c, d}); }

std::vector<std::array<NodeIndex, 2>> edges_of(const Mesh& mesh) {
  const MeshEdges edges(mesh);
  std::vector<std::array<NodeIndex, 2>> nodes;
  nodes.reserve(edges.count());
  for (std::size_t e = 0; e < edges.count(); ++e) nodes.push_back(edges.nodes(e));
  return nodes;
}

std::vector<double> growth_of_quads(const Mesh& mesh) {
  std::vector<double> growth(mesh.quads.size(), 1);
  for_each_growth(mesh, MeshEdges(mesh), [&](std::uint32_t s, std::uint32_t t, double ratio) {
    growth[s] = std::max(growth[s], ratio);
    growth[t] = std::max(growth[t], ratio);
  });
  return growth;
}

Quality measure(const Mesh& mesh, std::span<const double> size) {
  Quality q;
  q.n_nodes = mesh.points.size();
  q.n_quads = mesh.quads.size();
  q.n_triangles = mesh.triangles.size();
  std::vector<double> jacobian, least, greatest, aspect;
  QuadSums sums;
  for (const auto& quad : mesh.quads) {
    const QuadPoints p = corners(mesh, quad);
    jacobian.push_back(scaled_jacobian(p));
    sums.add(quad_distortion(p), jacobian.back());
    double low = 360, high = 0, shortest = 0, longest = 0;
    for (int i = 0; i < 4; ++i) {
      const double angle = corner_angle(p[(i + 3) % 4], p[i], p[(i + 1) % 4]) * kDegreesPerRadian;
      low = std::min(low, angle);
      high = std::max(high, angle);
      const double length = distance(p[i], p[(i + 1) % 4]);
      shortest = i == 0 ? length : std::min(shortest, length);
      longest = std::max(longest, length);
    }
    least.push_back(low);
    greatest.push_back(high);
    aspect.push_back(shortest > 0 ? longest / shortest : kEndless);
  }
  q.n_inverted = sums.n_inverted();
  q.beta_min = sums.beta_min();
  q.beta_mean = sums.beta_mean();
  q.scaled_jacobian = statistics(jacobian);
  q.min_angle_deg = statistics(least);
  q.max_angle_deg = statistics(greatest);
  q.aspect = statistics(aspect);
  std::vector<double> lengths, ratios;
  const MeshEdges edges(mesh);
  for (std::size_t e = 0; e < edges.count(); ++e) {
    const auto [a, b] = edges.nodes(e);
    lengths.push_back(distance(mesh.points[a], mesh.points[b]));
    if (!size.empty()) ratios.push_back(lengths.back() / size[e]);
  }
  q.edge_length = statistics(lengths);
  if (!size.empty()) q.edge_to_size = statistics(ratios);
  std::vector<double> growth;
  for_each_growth(mesh, edges, [&](std::uint32_t, std::uint32_t, double ratio) {
    growth.push_back(ratio);
    q.n_growth_over += ratio > kGrowthLimit;
  });
  q.growth = statistics(growth);
  const auto irregular = irregular_nodes(mesh, edges);
  q.n_irregular = static_cast<std::size_t>(std::count(irregular.begin(), irregular.end(), 1));
  return q;
}

}  // namespace quadline
