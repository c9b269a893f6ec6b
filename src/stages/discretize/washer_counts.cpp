#include "stages/discretize/washer_counts.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace quadline {
namespace {

using Walk = std::vector<DirectedCurve>;

/// Edges that the sizes ask for round a circle.
double edges_asked(const Walk& circle, const IdVector<CurveId, CountTarget>& targets) {
  double sum = 0;
  for (const DirectedCurve& d : circle) sum += std::max(targets[d.curve].length, double(targets[d.curve].least));
  return sum;
}

/// What a grid wishes for one of the circles; else between what the inner and what the outer circle want, as the others
/// lie between.
std::uint32_t common_count(const Domain::Washer& washer, const IdVector<CurveId, CountTarget>& targets) {
  for (const Walk& circle : washer.circles)
    if (std::all_of(circle.begin(), circle.end(), [&](const DirectedCurve& d) { return targets[d.curve].is_wished; }))
      return static_cast<std::uint32_t>(edges_asked(circle, targets) + 0.5);
  constexpr double kMost = 1e9;
  const double inner = edges_asked(washer.circles.front(), targets),
               outer = edges_asked(washer.circles.back(), targets);
  const double fours = std::round(0.25 * std::sqrt(inner * outer));
  return 4 * static_cast<std::uint32_t>(std::clamp(fours, 1.0, 0.25 * kMost));
}

/// Cuts a number of edges, in steps of `unit`, into parts for the curves of a circle by their turns; none gets none.
/// @pre there are as many steps as curves.
std::vector<std::uint32_t> parts_of(std::uint32_t edges, std::uint32_t unit, const Domain& domain, const Walk& circle) {
  constexpr double kTie = 1e-6;  // steps: halves are rounded down, whatever the last bit says
  const auto turn_of = [&](const DirectedCurve& d) { return std::abs(domain.curves[d.curve].piece.sweep); };
  double turn = 0, turned = 0;
  for (const DirectedCurve& d : circle) turn += turn_of(d);
  const std::uint32_t steps = edges / unit;
  std::vector<std::uint32_t> parts;
  std::uint32_t done = 0;
  for (std::size_t i = 0; i < circle.size(); ++i) {
    turned += turn_of(circle[i]);
    const double most = steps - static_cast<double>(circle.size() - 1 - i);
    const auto upto =
        static_cast<std::uint32_t>(std::clamp(std::round(steps * (turned / turn) - kTie), done + 1.0, most));
    parts.push_back(unit * (upto - done));
    done = upto;
  }
  return parts;
}

}  // namespace

void set_washer_counts(const Domain& domain, bool all_halved, IdVector<CurveId, CountTarget>& targets) {
  for (const Domain::Washer& washer : domain.washers) {
    const auto is_even = [&](const DirectedCurve& d) { return targets[d.curve].is_halved; };
    const bool any_even = std::any_of(washer.circles.begin(), washer.circles.end(), [&](const Walk& circle) {
      return std::any_of(circle.begin(), circle.end(), is_even);
    });
    std::size_t n_curves = 0;
    for (const Walk& circle : washer.circles) n_curves = std::max(n_curves, circle.size());
    const std::uint32_t unit = any_even ? 2 : 1, least = unit * static_cast<std::uint32_t>(n_curves);
    const std::uint32_t given = all_halved ? washer.edges / 2 : washer.edges;
    const std::uint32_t edges = std::max(washer.edges > 0 ? given : common_count(washer, targets), least);
    for (const Walk& circle : washer.circles) {
      const std::vector<std::uint32_t> parts = parts_of(edges, unit, domain, circle);
      for (std::size_t i = 0; i < circle.size(); ++i) {
        CountTarget& target = targets[circle[i].curve];
        target = {.length = double(parts[i]), .least = parts[i], .is_halved = target.is_halved, .exact = parts[i]};
      }
    }
  }
}

}  // namespace quadline
