#include "stages/discretize/submappable_faces.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "domain/walk_turns.hpp"

// Equal counts on opposite sides: interval assignment [Mitchell1997] as a soft target, for what submapping would mesh
// [Whiteley1996]. An integer program is not needed, because a submappable face that stays unequal costs a few irregular
// nodes, not the mesh.

namespace quadline {
namespace {

// Ratio of the targets of opposite sides beyond which rows had better end; round a ring they show more where they do.
constexpr double kMostUnequal = 1.6, kMostUnequalRing = 1.75;
constexpr double kRoundsAway = 0.7;  // edges: a lesser difference is hardly more than rounding

/// The curves of a walk by the direction in which the rows of a grid would see them.
std::array<std::vector<CurveId>, 4> sides_by_direction(const std::vector<DirectedCurve>& walk,
                                                       const std::vector<int>& quads) {
  std::array<std::vector<CurveId>, 4> sides;
  unsigned direction = 0;
  for (std::size_t i = 0; i < walk.size(); ++i) {
    if (i > 0) direction += 2u - static_cast<unsigned>(quads[i]);
    sides[direction % 4].push_back(walk[i].curve);
  }
  return sides;
}

double side_length(const std::vector<CurveId>& side, const IdVector<CurveId, CountTarget>& targets) {
  double sum = 0;
  for (CurveId c : side) sum += std::max(targets[c].length, double(targets[c].least));
  return sum;
}

}  // namespace

std::vector<SubmappableFace> find_submappable_faces(const Domain& domain,
                                                    const IdVector<CurveId, CountTarget>& targets) {
  std::vector<SubmappableFace> submaps;
  const auto add = [&](SubmappableFace submap) {
    const double most = submap.is_ring() ? kMostUnequalRing : kMostUnequal;
    for (std::size_t k = 0; k < 2; ++k) {
      const double a = side_length(submap.sides[k], targets), b = side_length(submap.sides[k + 2], targets);
      submap.is_close[k] = a > 0 && b > 0 && (std::max(a, b) < most * std::min(a, b) || std::abs(a - b) < kRoundsAway);
    }
    if (submap.is_close[0] || submap.is_close[1]) submaps.push_back(std::move(submap));
  };
  std::size_t next_walk = 0;
  for (const Domain::Cell& cell : domain.cells) {
    std::vector<int> turned;
    for (const auto& walk : cell.walks) {
      const std::vector<int> quads = quads_along(domain, walk);
      turned.push_back(turns(quads));
      if (std::abs(turned.back()) == 4) add({next_walk, sides_by_direction(walk, quads), {}});
      ++next_walk;
    }
    if (turned.size() == 2 && turned[0] == 0 && turned[1] == 0) {
      SubmappableFace ring{SubmappableFace::kNoWalk, {}, {}};
      for (std::size_t k = 0; k < 2; ++k)
        for (const DirectedCurve& d : cell.walks[k]) ring.sides[2 * k].push_back(d.curve);
      add(std::move(ring));
    }
  }
  return submaps;
}

void even_out(const std::vector<SubmappableFace>& submaps, IdVector<CurveId, CountTarget>& targets) {
  // All submappable faces at once, each curve by the mean of its two submappable faces: the result does not depend on
  // their order.
  constexpr int kSweeps = 16;
  struct Factor {
    double product = 1;
    int count = 0;
  };
  const IdVector<CurveId, CountTarget> original = targets;
  IdVector<CurveId, double> most;
  most.assign(targets.count(), kMostRefined);
  for (const SubmappableFace& submap : submaps)
    for (const auto& side : submap.sides)
      for (CurveId c : side)
        if (submap.is_ring()) most[c] = kMostRefinedRing;
  IdVector<CurveId, Factor> factors;
  for (int sweep = 0; sweep < kSweeps; ++sweep) {
    factors.assign(targets.count(), {});
    for (const SubmappableFace& submap : submaps)
      for (std::size_t k = 0; k < 4; ++k) {
        if (!submap.is_close[k % 2]) continue;
        const double own = side_length(submap.sides[k], targets),
                     other = side_length(submap.sides[(k + 2) % 4], targets);
        for (CurveId c : submap.sides[k]) {
          factors[c].product *= std::sqrt(other / own);
          ++factors[c].count;
        }
      }
    for (std::size_t i = 0; i < targets.count(); ++i) {
      const CurveId c(i);
      if (factors[c].count == 0 || targets[c].is_wished) continue;
      const double l = original[c].length;
      const double factor = factors[c].count == 1 ? factors[c].product : std::sqrt(factors[c].product);
      targets[c].length = std::clamp(targets[c].length * factor, l / kMostCoarsened, l * most[c]);
    }
  }
}

}  // namespace quadline
