// Third step of `arrange`, first half: the order of the pieces round every vertex.
#include <algorithm>
#include <cmath>

#include "base/csr.hpp"
#include "domain/arrange/work.hpp"
#include "geom/predicates.hpp"

namespace quadline::arrangement {

namespace {

// Pieces that leave a vertex at less than this angle, in radians, may change places within the tolerance.
constexpr double kNarrow = 0.5;

CurvePiece directed(const Work& work, Half half) {
  const CurvePiece& curve = work.pieces[piece_of(half)].curve;
  return is_reversed(half) ? reversed(curve) : curve;
}

/// Grows with the angle of v; 0 to 4 round a full turn.
double pseudo_angle(Point v) {
  const double x = v.x / (std::abs(v.x) + std::abs(v.y));
  return v.y < 0 ? 3 + x : 1 - x;
}

struct Spoke {
  Half half = 0;
  CurvePiece curve{};  ///< away from the vertex
  Point tangent{};
  double angle = 0;
};

bool is_narrow(const Spoke& a, const Spoke& b) {
  return std::abs(cross(a.tangent, b.tangent)) < kNarrow && dot(a.tangent, b.tangent) > 0;
}

/// Signed distance of p from the line or circle of a piece, positive on the left.
double offset(const CurvePiece& piece, Point p) {
  if (!piece.is_arc()) return cross(piece.b - piece.a, p - piece.a) / norm(piece.b - piece.a);
  return std::copysign(1.0, piece.sweep) * (piece.radius - distance(p, piece.center));
}

/// Does b leave the vertex clockwise of a, where the two are narrow? Where they are farthest apart tells: near the
/// vertex they may touch, on either side.
bool is_clockwise(const CurvePiece& a, const CurvePiece& b) {
  if (!a.is_arc() && !b.is_arc()) return orientation(a.a, a.b, b.b) < 0;
  const double reach = std::min(length(a), length(b));
  double farthest = 0;
  for (const double f : {0.125, 0.25, 0.5, 0.75, 1.0}) {
    for (const double apart : {offset(a, point_at(b, f * reach)), -offset(b, point_at(a, f * reach))}) {
      if (std::abs(apart) > std::abs(farthest)) farthest = apart;
    }
  }
  return farthest < 0;
}

void sort_counter_clockwise(std::vector<Spoke>& spokes) {
  std::sort(spokes.begin(), spokes.end(),
            [](const Spoke& a, const Spoke& b) { return a.angle != b.angle ? a.angle < b.angle : a.half < b.half; });
  const std::size_t n = spokes.size();
  if (n < 3) return;
  // Cut the circle at its widest gap, where no two spokes are narrow, and mend the order of the narrow ones.
  std::size_t widest = 0;
  double gap = 4 + spokes[0].angle - spokes[n - 1].angle;
  for (std::size_t i = 1; i < n; ++i) {
    if (spokes[i].angle - spokes[i - 1].angle > gap) gap = spokes[i].angle - spokes[i - 1].angle, widest = i;
  }
  std::rotate(spokes.begin(), spokes.begin() + static_cast<std::ptrdiff_t>(widest), spokes.end());
  for (std::size_t i = 1; i < n; ++i) {
    for (std::size_t j = i; j > 0; --j) {
      if (!is_narrow(spokes[j - 1], spokes[j]) || !is_clockwise(spokes[j - 1].curve, spokes[j].curve)) break;
      std::swap(spokes[j - 1], spokes[j]);
    }
  }
}

}  // namespace

std::vector<Half> next_halves(const Work& work) {
  const std::size_t n_halves = 2 * work.pieces.count();
  const Rows<Half> leaving(work.vertices.count(), [&](const auto& visit) {
    for (Half h = 0; h < n_halves; ++h) visit(tail_of(work, h).value, h);
  });
  std::vector<Half> next(n_halves);
  std::vector<Spoke> spokes;
  for (std::size_t v = 0; v < work.vertices.count(); ++v) {
    spokes.clear();
    for (const Half h : leaving[v]) {
      Spoke spoke{.half = h, .curve = directed(work, h)};
      spoke.tangent = tangent_at(spoke.curve, 0);
      spoke.angle = pseudo_angle(spoke.tangent);
      spokes.push_back(spoke);
    }
    sort_counter_clockwise(spokes);
    // Who arrives along a spoke goes on along the next one clockwise, so that nothing lies between on the left.
    for (std::size_t i = 0; i < spokes.size(); ++i) {
      next[spokes[(i + 1) % spokes.size()].half ^ 1u] = spokes[i].half;
    }
  }
  return next;
}

}  // namespace quadline::arrangement
