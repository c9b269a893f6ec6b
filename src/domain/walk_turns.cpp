#include "domain/walk_turns.hpp"

#include <cstddef>

#include "geom/angles.hpp"

namespace quadline {
namespace {

Point direction(const Domain& domain, DirectedCurve d, bool at_end) {
  const CurvePiece& piece = domain.curves[d.curve].piece;
  const Point t = tangent_at(piece, d.reversed != at_end ? length(piece) : 0);
  return d.reversed ? -1.0 * t : t;
}

}  // namespace

std::vector<int> quads_along(const Domain& domain, const std::vector<DirectedCurve>& walk) {
  std::vector<int> quads;
  for (std::size_t i = 0; i < walk.size(); ++i) {
    const DirectedCurve before = walk[(i + walk.size() - 1) % walk.size()];
    const Point in = direction(domain, before, true), out = direction(domain, walk[i], false);
    quads.push_back(quads_for_angle(angle_at(-1.0 * in, {0, 0}, out)));
  }
  return quads;
}

int turns(const std::vector<int>& quads) {
  int sum = 0;
  for (int k : quads) sum += 2 - k;
  return sum;
}

}  // namespace quadline
