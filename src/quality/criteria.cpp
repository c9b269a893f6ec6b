#include "quadline/criteria.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/constants.hpp"
#include "quadline/quality.hpp"
#include "quality/criteria_values.hpp"
#include "quality/face_corners.hpp"
#include "quality/mesh_edges.hpp"

namespace quadline {

namespace {

constexpr std::size_t kWorst = 5;
constexpr double kRoundOff = 1e-12;  // relative; a right angle computed as 90 - 1e-14 is not below 90

void keep_worst(std::vector<FailingQuad>& worst, const FailingQuad& quad, bool is_least) {
  const auto is_worse = [&](const FailingQuad& a, const FailingQuad& b) {
    return is_least ? a.value < b.value : a.value > b.value;
  };
  worst.insert(std::upper_bound(worst.begin(), worst.end(), quad, is_worse), quad);
  if (worst.size() > kWorst) worst.pop_back();
}

}  // namespace

const std::vector<CriteriaField>& criteria_fields() {
  static const std::vector<CriteriaField> fields{
      {"min_angle_deg", &Criteria::min_angle_deg, true, false, 0, 360},
      {"max_angle_deg", &Criteria::max_angle_deg, false, false, 0, 360},
      {"max_aspect", &Criteria::max_aspect, false, false, 1, kInfinity},
      {"min_scaled_jacobian", &Criteria::min_scaled_jacobian, true, false, -1, 1},
      {"min_jacobian_ratio", &Criteria::min_jacobian_ratio, true, false, -1, 1},
      {"max_skew_deg", &Criteria::max_skew_deg, false, false, 0, 90},
      {"max_taper", &Criteria::max_taper, false, false, 0, kInfinity},
      {"min_beta", &Criteria::min_beta, true, false, 0, 1},
      {"max_growth", &Criteria::max_growth, false, false, 1, kInfinity},
      {"min_edge", &Criteria::min_edge, true, false, 0, kInfinity},
      {"max_edge", &Criteria::max_edge, false, false, 0, kInfinity},
      {"min_edge_to_size", &Criteria::min_edge_to_size, true, true, 0, kInfinity},
      {"max_edge_to_size", &Criteria::max_edge_to_size, false, true, 0, kInfinity}};
  return fields;
}

std::optional<Criteria> named_criteria(std::string_view name) {
  Criteria c;
  if (name == "csr-fine") {
    c.min_angle_deg = 45;
    c.max_angle_deg = 135;
    c.max_aspect = 3;
    return c;
  }
  if (name == "growth") {
    c.max_growth = kGrowthLimit;
    return c;
  }
  if (name != "hypermesh-10mm") return std::nullopt;
  c.min_angle_deg = 40;
  c.max_angle_deg = 140;
  c.max_aspect = 5;
  c.min_jacobian_ratio = 0.6;
  c.max_skew_deg = 40;
  c.max_taper = 0.6;
  c.min_edge_to_size = 0.2;
  c.max_edge_to_size = 2;
  return c;
}

namespace {

// `sizes_of(i)`: target sizes at the sides of quad i, 1 where they are not known.
template <class SizesOf>
CriteriaResult evaluate_sized(const Mesh& mesh, const Criteria& criteria, bool has_sizes, SizesOf sizes_of) {
  CriteriaResult result;
  std::vector<CriteriaField> asked;
  for (const CriteriaField& field : criteria_fields()) {
    const auto& limit = criteria.*field.limit;
    if (!limit) continue;
    asked.push_back(field);
    result.limits.push_back({field.name, *limit, has_sizes || !field.to_size, 0, {}});
  }
  std::vector<double> growth;
  if (criteria.max_growth) growth = growth_of_quads(mesh);
  for (std::size_t i = 0; i < mesh.quads.size(); ++i) {
    const QuadPoints p = corners(mesh, mesh.quads[i]);
    const Point center = 0.25 * (p[0] + p[1] + p[2] + p[3]);
    const Criteria values = criteria_values(criteria, p, sizes_of(i), growth.empty() ? 1 : growth[i]);
    bool fails = false;
    for (std::size_t k = 0; k < asked.size(); ++k) {
      const CriteriaField& field = asked[k];
      LimitResult& limit = result.limits[k];
      if (!limit.is_checked) continue;
      const double value = *(values.*field.limit);
      const double beyond = field.is_least ? limit.limit - value : value - limit.limit;
      if (beyond <= kRoundOff * std::abs(limit.limit)) continue;
      fails = true;
      ++limit.n_failing;
      keep_worst(limit.worst, {i, center, value}, field.is_least);
    }
    result.n_failing += fails;
  }
  return result;
}

}  // namespace

CriteriaResult evaluate(const Mesh& mesh, const Criteria& criteria, std::optional<double> size) {
  std::array<double, 4> sizes{};
  sizes.fill(size.value_or(1));
  return evaluate_sized(mesh, criteria, size.has_value(), [&](std::size_t) { return sizes; });
}

CriteriaResult evaluate(const Mesh& mesh, const Criteria& criteria, std::span<const double> size) {
  if (size.empty() || !(criteria.min_edge_to_size || criteria.max_edge_to_size)) return evaluate(mesh, criteria);
  const MeshEdges edges(mesh);
  return evaluate_sized(mesh, criteria, true, [&](std::size_t i) {
    const auto& q = mesh.quads[i];
    std::array<double, 4> sizes{};
    for (std::size_t k = 0; k < 4; ++k) sizes[k] = size[edges.find(q[k], q[(k + 1) % 4])];
    return sizes;
  });
}

}  // namespace quadline
