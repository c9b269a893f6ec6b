#include "stages/discretize/circle_twins.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <tuple>
#include <vector>

namespace quadline {
namespace {

constexpr double kOffHalf = 1e-6;    // radians: what a half circle may turn more or less than half a turn
constexpr double kMostUneven = 1.1;  // ratio of what the halves want beyond which each gets its own count
constexpr double kRoundsAway = 1;    // edges: a lesser difference is rounding

bool are_close(double a, double b) {
  return std::max(a, b) < kMostUneven * std::min(a, b) || std::abs(a - b) < kRoundsAway;
}

}  // namespace

IdVector<CurveId, CurveId> circle_twins(const Domain& domain, const IdVector<CurveId, double>& lengths) {
  using Half = std::tuple<VertexId, VertexId, CurveId>;
  std::vector<Half> halves;
  for (std::size_t i = 0; i < domain.curves.count(); ++i) {
    const Domain::Curve& c = domain.curves[CurveId(i)];
    if (std::abs(std::abs(c.piece.sweep) - std::numbers::pi) < kOffHalf)
      halves.emplace_back(std::min(c.tail, c.head), std::max(c.tail, c.head), CurveId(i));
  }
  std::sort(halves.begin(), halves.end());
  IdVector<CurveId, CurveId> twins(domain.curves.count());
  for (std::size_t k = 1; k < halves.size(); ++k) {
    // Half circles between the same two vertices lie on one circle.
    const auto& [tail, head, a] = halves[k - 1];
    const auto& [other_tail, other_head, b] = halves[k];
    if (tail != other_tail || head != other_head || !are_close(lengths[a], lengths[b])) continue;
    twins[a] = b;
    twins[b] = a;
  }
  return twins;
}

}  // namespace quadline
