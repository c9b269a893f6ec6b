#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <tuple>

#include "geom/element.hpp"
#include "quadline/quality.hpp"
#include "quality/face_corners.hpp"

namespace quadline {

namespace {

constexpr std::size_t kWorst = 5;
constexpr double kLeastBound = 1e-3;  // a corner of less than 0.06 degrees excuses no more than this

bool is_before(Point p, Point q) { return std::tie(p.x, p.y) < std::tie(q.x, q.y); }

// Corners by their place.
class CornerMap {
 public:
  explicit CornerMap(std::span<const CellCorner> corners) : corners_(corners.begin(), corners.end()) {
    std::stable_sort(corners_.begin(), corners_.end(),
                     [](const CellCorner& a, const CellCorner& b) { return is_before(a.at, b.at); });
  }

  // The bound on a quad's corner between the directions `next` and `previous`, 1 where it is in no corner of a cell.
  double bound(Point at, Point next, Point previous) const {
    auto it = std::lower_bound(corners_.begin(), corners_.end(), at,
                               [](const CellCorner& a, Point p) { return is_before(a.at, p); });
    for (; it != corners_.end() && it->at == at; ++it) {
      const double half = 0.5 * corner_angle(previous, {0, 0}, next), from = corner_angle(next, {0, 0}, it->from);
      const double middle = (from + half) * 180 / std::numbers::pi;
      if ((middle < 360 ? middle : middle - 360) <= it->angle_deg) return std::max(it->sj_bound, kLeastBound);
    }
    return 1;
  }

 private:
  std::vector<CellCorner> corners_;
};

// The worst corner of a quad.
WorstQuad worst_corner(const CornerMap& map, const QuadPoints& p) {
  WorstQuad worst{0, 0.25 * (p[0] + p[1] + p[2] + p[3]), 2, 1, 1};
  for (std::size_t i = 0; i < 4; ++i) {
    const Point next = p[(i + 1) % 4] - p[i], previous = p[(i + 3) % 4] - p[i];
    const double lengths = std::sqrt(norm2(next) * norm2(previous));
    const double sine = lengths > 0 ? cross(next, previous) / lengths : 0;
    const double bound = map.bound(p[i], next, previous);
    const double value = sine > 0 ? sine / bound : sine;
    if (value < worst.value) worst.value = value, worst.scaled_jacobian = sine, worst.sj_bound = bound;
  }
  return worst;
}

}  // namespace

std::vector<WorstQuad> worst_quads(const Mesh& mesh, std::span<const CellCorner> corners) {
  const CornerMap map(corners);
  std::vector<WorstQuad> worst;
  for (std::size_t n = 0; n < mesh.quads.size(); ++n) {
    const QuadPoints p = quadline::corners(mesh, mesh.quads[n]);
    // Bounds only lift a value: what is no worse without them need not look for them.
    if (worst.size() == kWorst && scaled_jacobian(p) >= worst.back().value) continue;
    WorstQuad quad = worst_corner(map, p);
    quad.quad = n;
    worst.insert(std::upper_bound(worst.begin(), worst.end(), quad,
                                  [](const WorstQuad& a, const WorstQuad& b) { return a.value < b.value; }),
                 quad);
    if (worst.size() > kWorst) worst.pop_back();
  }
  return worst;
}

double jacobian_bound(std::span<const CellCorner> corners) {
  double least = 1;
  for (const CellCorner& corner : corners) least = std::min(least, corner.sj_bound);
  return least;
}

}  // namespace quadline
