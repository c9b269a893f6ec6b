#include "stages/discretize/bays.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

#include "geom/element.hpp"
#include "mesh/work_mesh.hpp"

// Equal counts on opposite sides of four-sided cells: interval assignment [Mitchell1997] as a soft wish. An integer
// program is not needed, because a bay that stays unequal costs a few irregular nodes, not the mesh.

namespace quadline {
namespace {

constexpr double kRoundsAway = 0.7;  // edges: a lesser difference is hardly more than rounding

Point direction(const Domain& domain, DirectedCurve d, bool at_end) {
  const CurvePiece& piece = domain.curves[d.curve].piece;
  const Point t = tangent_at(piece, d.reversed != at_end ? length(piece) : 0);
  return d.reversed ? -1.0 * t : t;
}

/// Quads that fit into the corner of the walk before its i-th curve.
int quads_at(const Domain& domain, const std::vector<DirectedCurve>& walk, std::size_t i) {
  const DirectedCurve before = walk[(i + walk.size() - 1) % walk.size()];
  const Point in = direction(domain, before, true), out = direction(domain, walk[i], false);
  return quads_for_angle(corner_angle(-1.0 * in, {0, 0}, out));
}

std::optional<Bay> as_bay(const Domain& domain, const Domain::Cell& cell) {
  if (cell.walks.size() != 1 || !cell.lone_points.empty()) return std::nullopt;
  const auto& walk = cell.walks[0];
  std::vector<std::size_t> corners;
  for (std::size_t i = 0; i < walk.size(); ++i) {
    const int quads = quads_at(domain, walk, i);
    if (quads == 1) corners.push_back(i);
    if (quads > 2 || corners.size() > 4) return std::nullopt;
  }
  if (corners.size() != 4) return std::nullopt;
  Bay bay{};
  for (std::size_t k = 0; k < 4; ++k) {
    for (std::size_t i = corners[k]; i != corners[(k + 1) % 4]; i = (i + 1) % walk.size())
      bay.sides[k].push_back(walk[i].curve);
  }
  return bay;
}

double side_length(const std::vector<CurveId>& side, const IdVector<CurveId, CountWish>& wishes) {
  double sum = 0;
  for (CurveId c : side) sum += std::max(wishes[c].length, double(wishes[c].least));
  return sum;
}

}  // namespace

std::vector<Bay> find_bays(const Domain& domain, const IdVector<CurveId, CountWish>& wishes) {
  std::vector<Bay> bays;
  std::size_t next_walk = 0;
  for (const Domain::Cell& cell : domain.cells) {
    std::optional<Bay> bay = as_bay(domain, cell);
    const std::size_t walk = std::exchange(next_walk, next_walk + cell.walks.size());
    if (!bay) continue;
    bay->walk = walk;
    for (std::size_t k = 0; k < 2; ++k) {
      const double a = side_length(bay->sides[k], wishes), b = side_length(bay->sides[k + 2], wishes);
      bay->is_close[k] = std::max(a, b) < kMostEvened * std::min(a, b) || std::abs(a - b) < kRoundsAway;
    }
    if (bay->is_close[0] || bay->is_close[1]) bays.push_back(std::move(*bay));
  }
  return bays;
}

void even_out(const std::vector<Bay>& bays, IdVector<CurveId, CountWish>& wishes) {
  // All bays at once, each curve by the mean of its two bays: the result does not depend on their order.
  constexpr int kSweeps = 16;
  struct Factor {
    double product = 1;
    int count = 0;
  };
  const IdVector<CurveId, CountWish> original = wishes;
  IdVector<CurveId, Factor> factors;
  for (int sweep = 0; sweep < kSweeps; ++sweep) {
    factors.assign(wishes.count(), {});
    for (const Bay& bay : bays)
      for (std::size_t k = 0; k < 4; ++k) {
        if (!bay.is_close[k % 2]) continue;
        const double own = side_length(bay.sides[k], wishes), other = side_length(bay.sides[(k + 2) % 4], wishes);
        for (CurveId c : bay.sides[k]) {
          factors[c].product *= std::sqrt(other / own);
          ++factors[c].count;
        }
      }
    for (std::size_t i = 0; i < wishes.count(); ++i) {
      const CurveId c(i);
      if (factors[c].count == 0) continue;
      const double l = original[c].length;
      const double factor = factors[c].count == 1 ? factors[c].product : std::sqrt(factors[c].product);
      wishes[c].length = std::clamp(wishes[c].length * factor, l / kMostEvened, l * kMostEvened);
    }
  }
}

}  // namespace quadline
