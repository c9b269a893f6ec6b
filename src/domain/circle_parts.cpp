#include "domain/circle_parts.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace quadline {

void share_edges(Domain& domain, const std::vector<DirectedCurve>& circle, std::uint32_t edges) {
  constexpr double kTie = 1e-6;  // edges: halves are rounded down, whatever the last bit says
  const auto turn_of = [&](const DirectedCurve& d) { return std::abs(domain.curves[d.curve].piece.sweep); };
  double whole = 0, turned = 0;
  for (const DirectedCurve& d : circle) whole += turn_of(d);
  std::uint32_t done = 0;
  for (std::size_t i = 0; i < circle.size(); ++i) {
    turned += turn_of(circle[i]);
    const double most = edges - static_cast<double>(circle.size() - 1 - i);
    const double upto = std::clamp(std::floor(edges * (turned / whole) + 0.5 - kTie), done + 1.0, most);
    domain.curves[circle[i].curve].edges = static_cast<std::uint32_t>(upto) - done;
    done = static_cast<std::uint32_t>(upto);
  }
}

std::uint32_t given_edges(const Domain& domain, const std::vector<DirectedCurve>& circle) {
  std::uint32_t sum = 0;
  for (const DirectedCurve& d : circle) {
    if (domain.curves[d.curve].edges == 0) return 0;
    sum += domain.curves[d.curve].edges;
  }
  return sum;
}

}  // namespace quadline
