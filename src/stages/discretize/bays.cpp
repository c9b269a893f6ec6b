#include "stages/discretize/bays.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
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

/// The sides of a cell between its corners, at most four; none where it has more, reflex corners, or something inside.
std::vector<std::vector<CurveId>> sides_of(const Domain& domain, const Domain::Cell& cell) {
  if (cell.walks.size() != 1 || !cell.lone_points.empty()) return {};
  const auto& walk = cell.walks[0];
  std::vector<std::size_t> corners;
  for (std::size_t i = 0; i < walk.size(); ++i) {
    const int quads = quads_at(domain, walk, i);
    if (quads == 1) corners.push_back(i);
    if (quads > 2 || corners.size() > 4) return {};
  }
  std::vector<std::vector<CurveId>> sides(corners.size());
  for (std::size_t k = 0; k < corners.size(); ++k) {
    std::size_t i = corners[k];
    do {
      sides[k].push_back(walk[i].curve);
      i = (i + 1) % walk.size();
    } while (i != corners[(k + 1) % corners.size()]);
  }
  return sides;
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
    const std::size_t walk = std::exchange(next_walk, next_walk + cell.walks.size());
    std::vector<std::vector<CurveId>> sides = sides_of(domain, cell);
    if (sides.size() != 4) continue;
    Bay bay{};
    bay.walk = walk;
    for (std::size_t k = 0; k < 4; ++k) bay.sides[k] = std::move(sides[k]);
    for (std::size_t k = 0; k < 2; ++k) {
      const double a = side_length(bay.sides[k], wishes), b = side_length(bay.sides[k + 2], wishes);
      bay.is_close[k] = std::max(a, b) < kMostEvened * std::min(a, b) || std::abs(a - b) < kRoundsAway;
    }
    if (bay.is_close[0] || bay.is_close[1]) bays.push_back(std::move(bay));
  }
  return bays;
}

void widen_triangles(const Domain& domain, IdVector<CurveId, CountWish>& wishes) {
  for (const Domain::Cell& cell : domain.cells) {
    const std::vector<std::vector<CurveId>> sides = sides_of(domain, cell);
    if (sides.size() != 3) continue;
    for (const std::vector<CurveId>& side : sides)
      if (side.size() == 1) wishes[side[0]].least = std::max(wishes[side[0]].least, 2u);
  }
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
