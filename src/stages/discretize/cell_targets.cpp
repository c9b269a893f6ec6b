#include "stages/discretize/cell_targets.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "domain/walk_turns.hpp"

namespace quadline {
namespace {

constexpr double kLongSide = 10;   // edges
constexpr double kStraight = 0.8;  // radians: a walk whose arcs turn by more has corners that its vertices do not show

/// A cell with one walk and about straight sides: what its corners say holds.
bool is_polygon(const Domain& domain, const Domain::Cell& cell) {
  if (cell.walks.size() != 1) return false;
  double turn = 0;
  for (const DirectedCurve& d : cell.walks[0]) turn += std::abs(domain.curves[d.curve].piece.sweep);
  return turn < kStraight;
}

/// Twice the area inside a walk.
double twice_area(const Domain& domain, const std::vector<DirectedCurve>& walk) {
  const Point origin = domain.curves[walk[0].curve].piece.a;
  double sum = 0;
  for (const DirectedCurve& d : walk)
    sum += (d.reversed ? -1 : 1) * twice_area_under(domain.curves[d.curve].piece, origin);
  return sum;
}

/// Ratio of the edges that a polygon with n corners wants round it to the edges that its sizes ask for: P edges round n
/// corners hold P^2 / (4 n) quads by midpoint subdivision, which cuts the polygon into n four-sided pieces [Li1995].
/// On long sides less than that, as rows that begin inside then disturb a smaller part of the cell.
double crowding(const Domain& domain, const std::vector<DirectedCurve>& walk, int n,
                const IdVector<CurveId, CountTarget>& targets) {
  double edges = 0, perimeter = 0;
  for (const DirectedCurve& d : walk) {
    edges += targets[d.curve].length;
    perimeter += length(domain.curves[d.curve].piece);
  }
  const double quads = 0.5 * twice_area(domain, walk) * (edges * edges) / (perimeter * perimeter);
  const double wanted = std::sqrt(4 * n * std::max(quads, 0.0)) / edges;
  return 1 + (std::clamp(wanted, 1.0, kMostCrowded) - 1) * std::min(1.0, kLongSide * n / edges);
}

}  // namespace

void widen_triangles(const Domain& domain, IdVector<CurveId, CountTarget>& targets) {
  for (const Domain::Cell& cell : domain.cells) {
    if (cell.walks.size() != 1 || !cell.lone_points.empty()) continue;
    const auto& walk = cell.walks[0];
    const std::vector<int> quads = quads_along(domain, walk);
    if (turns(quads) != 3 || std::count(quads.begin(), quads.end(), 1) != 3) continue;
    for (std::size_t i = 0; i < walk.size(); ++i) {
      CountTarget& target = targets[walk[i].curve];
      if (quads[i] == 1 && quads[(i + 1) % quads.size()] == 1) target.least = std::max(target.least, 2u);
    }
  }
}

void crowd_polygons(const Domain& domain, IdVector<CurveId, CountTarget>& targets) {
  IdVector<CurveId, double> factors;
  factors.assign(targets.count(), 1.0);
  for (const Domain::Cell& cell : domain.cells) {
    if (!is_polygon(domain, cell)) continue;
    const auto& walk = cell.walks[0];
    const int corners = turns(quads_along(domain, walk));
    if (corners <= 4) continue;
    const double factor = crowding(domain, walk, corners, targets);
    for (const DirectedCurve& d : walk)  // a curve between two cells gets the mean of what they want
      factors[d.curve] *= domain.curves[d.curve].is_boundary() ? factor : std::sqrt(factor);
  }
  for (std::size_t i = 0; i < targets.count(); ++i)
    if (CountTarget& target = targets[CurveId(i)]; !target.is_wished) target.length *= factors[CurveId(i)];
}

}  // namespace quadline
