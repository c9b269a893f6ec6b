#include "stages/discretize/arc_chains.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "base/csr.hpp"

namespace quadline {
namespace {

constexpr double kSmooth = -0.995;        // cosine between two arcs that leave a vertex: a bend of less than 6 degrees
constexpr std::size_t kMostAtVertex = 8;  // where more arcs meet none is the continuation of another
constexpr double kOffHalf = 1e-6;         // radians: what the halves of a circle may differ by
constexpr double kMostUneven = 1.1;       // ratio of what the halves want beyond which each gets its own count
constexpr double kRoundsAway = 1;         // edges: a lesser difference is rounding

struct ArcEnd {
  CurveId curve;
  bool is_head;
  Point away;  ///< unit tangent that leaves the vertex
};

bool are_close(double a, double b) {
  return std::max(a, b) < kMostUneven * std::min(a, b) || std::abs(a - b) < kRoundsAway;
}

}  // namespace

ArcChains arc_chains(const Domain& domain) {
  const Rows<ArcEnd> ends_at(domain.vertices.count(), [&](const auto& visit) {
    for (std::size_t i = 0; i < domain.curves.count(); ++i) {
      const Domain::Curve& c = domain.curves[CurveId(i)];
      if (!c.piece.is_arc()) continue;
      visit(c.tail.value, ArcEnd{CurveId(i), false, tangent_at(c.piece, 0)});
      visit(c.head.value, ArcEnd{CurveId(i), true, -1.0 * tangent_at(c.piece, length(c.piece))});
    }
  });
  ArcChains beyond(domain.curves.count());
  for (std::size_t v = 0; v < ends_at.count(); ++v) {
    if (ends_at[v].size() > kMostAtVertex) continue;
    for (const ArcEnd& a : ends_at[v])
      for (const ArcEnd& b : ends_at[v])
        if (a.curve != b.curve && dot(a.away, b.away) < kSmooth) beyond[a.curve][a.is_head] = b.curve;
  }
  return beyond;
}

IdVector<CurveId, CurveId> circle_twins(const Domain& domain, const ArcChains& chains,
                                        const IdVector<CurveId, double>& lengths) {
  IdVector<CurveId, CurveId> twins(domain.curves.count());
  for (std::size_t i = 0; i < domain.curves.count(); ++i) {
    const CurveId c(i), other = chains[c][0];
    if (!other.valid() || other != chains[c][1] || chains[other][0] != c || chains[other][1] != c) continue;
    const double turn = std::abs(domain.curves[c].piece.sweep), other_turn = std::abs(domain.curves[other].piece.sweep);
    if (std::abs(turn - other_turn) < kOffHalf && are_close(lengths[c], lengths[other])) twins[c] = other;
  }
  return twins;
}

}  // namespace quadline
