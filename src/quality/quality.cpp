#include "quadline/quality.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "base/elementary.hpp"
#include "geom/element.hpp"
#include "quality/irregular_nodes.hpp"
#include "quality/mesh_sides.hpp"

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

QuadPoints points_of(const Mesh& mesh, const std::array<NodeIndex, 4>& q) {
  return {mesh.points[q[0]], mesh.points[q[1]], mesh.points[q[2]], mesh.points[q[3]]};
}

// Of the widths of two quads across the edge that they share, the greater over the lesser; for all such edges.
template <class Visit>
void for_each_growth(const Mesh& mesh, const std::vector<Side>& sides, Visit visit) {
  const auto width = [&](const Side& s) {
    const QuadPoints p = points_of(mesh, mesh.quads[s.face]);
    const std::size_t i = s.corner;
    return distance(midpoint(p[i], p[(i + 1) % 4]), midpoint(p[(i + 2) % 4], p[(i + 3) % 4]));
  };
  for (std::size_t i = 1; i < sides.size(); ++i) {
    const Side &s = sides[i - 1], &t = sides[i];
    if (!same_edge(s, t) || s.face >= mesh.quads.size() || t.face >= mesh.quads.size()) continue;
    const double a = width(s), b = width(t), least = std::min(a, b);
    visit(s.face, t.face, least * kEndless > std::max(a, b) ? std::max(a, b) / least : kEndless);
  }
}

}  // namespace

std::string_view verdict(double beta) {
  if (beta < 0.36) return "unacceptable";
  if (beta < 0.54) return "marginal";
  return beta < 0.72 ? "good" : "excellent";
}

double distortion(Point a, Point b, Point c, Point d) { return quad_distortion({a, b, c, d}); }

std::vector<std::array<NodeIndex, 2>> edges_of(const Mesh& mesh) { return unique_edges(sorted_sides(mesh)); }

std::vector<double> growth_of_quads(const Mesh& mesh) {
  std::vector<double> growth(mesh.quads.size(), 1);
  for_each_growth(mesh, sorted_sides(mesh), [&](std::uint32_t s, std::uint32_t t, double ratio) {
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
  double log_beta = 0;
  q.beta_min = 1;
  for (const auto& quad : mesh.quads) {
    const QuadPoints p = points_of(mesh, quad);
    const double beta = quad_distortion(p);
    log_beta += logarithm(std::max(beta, 1e-12));
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
    aspect.push_back(shortest > 0 ? longest / shortest : kEndless);
  }
  if (mesh.quads.empty()) q.beta_min = 0;
  q.beta_mean = mesh.quads.empty() ? 0 : exponential(log_beta / static_cast<double>(mesh.quads.size()));
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
  std::vector<double> growth;
  for_each_growth(mesh, sides, [&](std::uint32_t, std::uint32_t, double ratio) {
    growth.push_back(ratio);
    q.n_growth_over += ratio > kGrowthLimit;
  });
  q.growth = statistics(growth);
  const auto irregular = irregular_nodes(mesh, sides);
  q.n_irregular = static_cast<std::size_t>(std::count(irregular.begin(), irregular.end(), 1));
  return q;
}

}  // namespace quadline
