#include "domain/size/size_sources.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "base/elementary.hpp"

namespace quadline {
namespace {

constexpr double kNone = std::numeric_limits<double>::infinity();
constexpr double kLeastEdgesPerCircle = 8;
constexpr double kShortStretch = 2;        // size beside a short curve, over its length
constexpr double kWorthwhile = 0.95;       // of the base size: what asks for hardly less is left out
constexpr double kCountSlack = 0.25;       // of an edge: a part of a circle may turn a little more per edge
constexpr double kLeastShortShare = 0.15;  // a lone curve shorter than that part of the size is a nick

/// Length of the one curve that continues another at its end; infinity where it ends, branches or crosses there.
class Continuations {
 public:
  explicit Continuations(const Domain& domain) : ends_(domain.vertices.count()) {
    for (const Domain::Curve& c : domain.curves)
      for (VertexId v : {c.tail, c.head}) {
        ++ends_[v].count;
        ends_[v].sum += length(c.piece);
      }
  }
  double beyond(VertexId v, double own) const { return ends_[v].count == 2 ? ends_[v].sum - own : kNone; }

 private:
  struct End {
    int count = 0;
    double sum = 0;
  };
  IdVector<VertexId, End> ends_;
};

}  // namespace

double circle_edges(double radius, double size_around, double edges_per_circle) {
  constexpr double kUsual = 16;
  // Who asks for more gets more on every circle, in proportion.
  if (edges_per_circle > kUsual) return circle_edges(radius, size_around, kUsual) * edges_per_circle / kUsual;
  const double natural = 2 * std::numbers::pi * radius / size_around;
  if (natural >= edges_per_circle) return edges_per_circle;
  const double least = std::min(kLeastEdgesPerCircle, edges_per_circle), small = 0.25 * edges_per_circle;
  const double share = std::max(0.0, natural - small) / (edges_per_circle - small);
  const double edges = least + (edges_per_circle - least) * share;
  return std::clamp(4 * std::ceil(0.25 * edges - 0.4), least, edges_per_circle);
}

double curvature_size(double radius, double edges) {
  // The row of squares round a circle has edges from the chord to (1 + 2 pi / edges) chords long; the size is their
  // mean. The chord itself would add edges to each ring that the next one has to lose again.
  const double step = std::numbers::pi / edges;
  return 2 * radius * sine(step) * (1 + step);
}

double base_size(const Domain& domain, const Domain::Curve& curve) {
  double base = kNone;
  for (CellId cell : {curve.left, curve.right})
    if (cell.valid()) base = std::min(base, domain.cells[cell].size);
  return base;
}

CurveSizes curve_sizes(const Domain& domain, const Options& options) {
  const Continuations ends(domain);
  CurveSizes curves;
  for (const Domain::Curve& curve : domain.curves) {
    const CurvePiece& piece = curve.piece;
    const double base = base_size(domain, curve), own = length(piece);
    double size = std::min(base, curve.size), least = 1;
    if (piece.is_arc()) {
      const double turn = std::abs(piece.sweep);
      const double edges = curve.edges > 0 ? curve.edges * (2 * std::numbers::pi) / turn
                                           : circle_edges(piece.radius, base, options.edges_per_circle);
      if (!curve.has_rings) size = std::min(size, curvature_size(piece.radius, edges));
      least =
          curve.edges > 0 ? curve.edges : std::max(1.0, std::ceil(edges * turn / (2 * std::numbers::pi) - kCountSlack));
    }
    // A chain of short curves is a small feature and gets its size; a lone short one is a nick.
    const double beside = std::max(ends.beyond(curve.tail, own), ends.beyond(curve.head, own));
    if (!curve.has_rings)
      size = std::min(size, kShortStretch * std::max(own, std::min(beside, kLeastShortShare * base)));
    const bool is_asked = curve.size < base || size < kWorthwhile * base;
    curves.sizes.push_back(is_asked ? size : base);
    curves.least_edges.push_back(static_cast<std::uint32_t>(least));
  }
  return curves;
}

void append_sources(const CurvePiece& piece, double s0, double s1, double size, bool is_border,
                    std::vector<SizeSource>& sources) {
  double n = 1;
  if (piece.is_arc()) {
    // Chords no longer than the size, and no more than an eighth of a turn.
    const double turn = (s1 - s0) / piece.radius;
    n = std::ceil(std::max((s1 - s0) / size, turn / (0.25 * std::numbers::pi)));
  }
  Point from = point_at(piece, s0);
  for (double i = 1; i <= n; ++i) {
    const Point to = point_at(piece, i == n ? s1 : s0 + (s1 - s0) * (i / n));
    sources.push_back({from, to, size, is_border});
    from = to;
  }
}

}  // namespace quadline
