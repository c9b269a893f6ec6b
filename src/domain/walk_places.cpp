#include "domain/walk_places.hpp"

#include <algorithm>
#include <cmath>

namespace quadline {

namespace {

constexpr double kWedgeReach = 4;  // places so near along the boundary (in sizes) belong to a corner

}  // namespace

WalkPlaces::WalkPlaces(const Domain& domain) : domain_(domain), sides_(2 * domain.curves.count()) {
  for (const Domain::Cell& cell : domain_.cells)
    for (const auto& walk : cell.walks) {
      double sum = 0;
      for (const DirectedCurve& d : walk) {
        sides_[2 * d.curve.value + d.reversed] = {static_cast<std::uint32_t>(walk_length_.size()), sum};
        sum += length(domain_.curves[d.curve].piece);
      }
      walk_length_.push_back(sum);
    }
}

double WalkPlaces::place(CurveId c, bool is_left, double s) const {
  const Side& side = sides_[2 * c.value + !is_left];
  return side.start + (is_left ? s : length(domain_.curves[c].piece) - s);
}

bool WalkPlaces::is_wedge(CurveId a, bool a_left, double sa, CurveId b, bool b_left, double sb, double size) const {
  const std::uint32_t walk = sides_[2 * a.value + !a_left].walk;
  if (walk == UINT32_MAX || walk != sides_[2 * b.value + !b_left].walk) return false;
  const double way = std::abs(place(a, a_left, sa) - place(b, b_left, sb));
  return std::min(way, walk_length_[walk] - way) < kWedgeReach * size;
}

}  // namespace quadline
