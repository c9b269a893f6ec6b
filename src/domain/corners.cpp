#include "domain/corners.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/elementary.hpp"
#include "geom/element.hpp"

namespace quadline {

namespace {

constexpr double kTouching = 0.003;  // radians; between such tangents the bend of the curves decides
constexpr double kReach = 0.01;      // of the shorter curve, where the bend is looked at
constexpr double kRoundOff = 1e-9;
constexpr unsigned kMostQuads = 8;

// The piece as it leaves a vertex.
CurvePiece leaving(const Domain& domain, DirectedCurve d) {
  const CurvePiece& piece = domain.curves[d.curve].piece;
  return d.reversed ? reversed(piece) : piece;
}

// The angle of the cell, in radians, between the curve that comes in and the one that goes out.
double angle_between(const Domain& domain, DirectedCurve in, DirectedCurve out) {
  constexpr double kTurn = 2 * std::numbers::pi;
  if (in.curve == out.curve) return kTurn;  // round the end of a line
  const CurvePiece back = leaving(domain, {in.curve, !in.reversed}), ahead = leaving(domain, out);
  const double angle = corner_angle(tangent_at(back, 0), {0, 0}, tangent_at(ahead, 0));
  if (angle > kTouching && angle < kTurn - kTouching) return angle;
  const double reach = kReach * std::min(length(back), length(ahead));
  const double near = corner_angle(point_at(back, reach), back.a, point_at(ahead, reach));
  if (near < std::numbers::pi) return angle > kTouching ? 0 : angle;
  return angle > kTouching ? angle : kTurn;
}

}  // namespace

std::vector<CellCorner> corners_of(const Domain& domain) {
  std::vector<CellCorner> corners;
  for (const Domain::Cell& cell : domain.cells) {
    for (const auto& walk : cell.walks) {
      for (std::size_t i = 0; i < walk.size(); ++i) {
        const double angle = angle_between(domain, walk[(i + walk.size() - 1) % walk.size()], walk[i]);
        unsigned best = 1;
        const auto sine = [&](unsigned quads) { return quadline::sine(std::min(angle / quads, std::numbers::pi)); };
        for (unsigned k = 2; k <= kMostQuads; ++k)
          if (sine(k) > sine(best) + kRoundOff) best = k;
        if (sine(best) > 1 - kRoundOff) continue;
        const CurvePiece ahead = leaving(domain, walk[i]);
        const double degrees = angle * 180 / std::numbers::pi;
        corners.push_back({ahead.a, tangent_at(ahead, 0), degrees, best, degrees / best, std::max(0.0, sine(best))});
      }
    }
  }
  return corners;
}

}  // namespace quadline
