#include "stages/discretize/chords.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "domain/walk_places.hpp"
#include "geom/predicates.hpp"
#include "search/box_tree.hpp"

namespace quadline {
namespace {

constexpr double kClearance = 4;  // of a node from an arc whose chord is halved, in bulges; 2 keep triangles sound

/// A chord of a curve, or a lone point (a == b, no curve).
struct Chord {
  Point a, b;
  CurveId curve;
  double bulge = 0;  ///< distance of the arc from the chord, at most
};

Box box_of(const Chord& c) {
  return {{std::min(c.a.x, c.b.x), std::min(c.a.y, c.b.y)}, {std::max(c.a.x, c.b.x), std::max(c.a.y, c.b.y)}};
}

bool is_inside_box(Point p, const Box& b) { return p.x >= b.lo.x && p.x <= b.hi.x && p.y >= b.lo.y && p.y <= b.hi.y; }

/// The chords have a point in common that is no end of both, or run the same way from a common end.
bool conflict(const Chord& c, const Chord& d) {
  if (c.a == d.a || c.a == d.b || c.b == d.a || c.b == d.b) {
    const bool at_tail = c.a == d.a || c.a == d.b;
    const Point common = at_tail ? c.a : c.b, p = at_tail ? c.b : c.a, q = d.a == common ? d.b : d.a;
    return q == p || (orientation(common, p, q) == 0 && dot(p - common, q - common) > 0);
  }
  const int c1 = orientation(c.a, c.b, d.a), c2 = orientation(c.a, c.b, d.b);
  const int d1 = orientation(d.a, d.b, c.a), d2 = orientation(d.a, d.b, c.b);
  if (c1 * c2 < 0 && d1 * d2 < 0) return true;
  return (c1 == 0 && is_inside_box(d.a, box_of(c))) || (c2 == 0 && is_inside_box(d.b, box_of(c))) ||
         (d1 == 0 && is_inside_box(c.a, box_of(d))) || (d2 == 0 && is_inside_box(c.b, box_of(d)));
}

/// p lies between the chord of an arc and the arc.
bool is_in_bulge(const Chord& c, const CurvePiece& arc, Point p) {
  if (p == c.a || p == c.b) return false;
  const int side = arc.sweep > 0 ? -1 : 1;  // the arc passes on the right of its chord where it turns left
  return orientation(c.a, c.b, p) == side && norm2(p - arc.center) <= arc.radius * arc.radius;
}

/// p lies outside an arc, over the chord and nearer than a few of its bulges: the middle of the arc may lie behind p.
bool is_close_outside(const Chord& c, const CurvePiece& arc, Point p) {
  const double gap = distance(p, arc.center) - arc.radius;
  if (gap < 0 || gap >= kClearance * c.bulge) return false;
  const Point foot = arc.center + (arc.radius / (arc.radius + gap)) * (p - arc.center);
  return dot(foot - c.a, foot - c.b) < 0;  // in the circle over the chord: not on the far side of the arc's own
}

std::vector<Chord> chords_of(const Domain& domain, const Polylines& lines) {
  std::vector<Chord> chords;
  for (std::size_t i = 0; i < lines.count(); ++i) {
    const std::vector<Point>& line = lines[CurveId(i)];
    const CurvePiece& piece = domain.curves[CurveId(i)].piece;
    for (std::size_t k = 0; k + 1 < line.size(); ++k) {
      Chord c{line[k], line[k + 1], CurveId(i), 0};
      if (piece.is_arc()) c.bulge = piece.radius - distance(piece.center, midpoint(c.a, c.b));
      chords.push_back(c);
    }
  }
  for (const Domain::Cell& cell : domain.cells)
    for (VertexId v : cell.lone_points) chords.push_back({domain.vertices[v].at, domain.vertices[v].at, CurveId(), 0});
  return chords;
}

/// Tells which arcs are too coarse, by pairs of chords.
class ChordJudge {
 public:
  ChordJudge(const Domain& domain, const IdVector<CurveId, EdgeUse>& uses) : domain_(domain), uses_(uses) {}

  /// How far from a chord others matter to it.
  double reach(const Chord& c) const { return (is_halved(c) ? 1 + kClearance : 1) * std::max(c.bulge, 0.0); }

  /// The arc that needs more nodes because of these two; invalid: none, or it is found from d.
  CurveId guilty(const Chord& c, const Chord& d) const {
    if (cuts_off_a_node(c, d)) return c.curve;
    // Not both at once: where arcs touch, that may never end.
    if (cuts_off_a_node(d, c)) return CurveId();
    if (conflict(c, d)) return is_arc(d.curve) && d.bulge > c.bulge ? d.curve : c.curve;
    return is_halved(c) && comes_close(c, d) ? c.curve : CurveId();
  }

  bool is_arc(CurveId c) const { return c.valid() && domain_.curves[c].piece.is_arc(); }

 private:
  bool cuts_off_a_node(const Chord& c, const Chord& d) const {
    if (!is_arc(c.curve)) return false;
    const CurvePiece& arc = domain_.curves[c.curve].piece;
    return is_in_bulge(c, arc, d.a) || is_in_bulge(c, arc, d.b);
  }

  /// Arcs that leave a vertex are always close there, however short their chords.
  bool comes_close(const Chord& c, const Chord& d) const {
    if (is_arc(d.curve) && share_vertex(domain_.curves[c.curve], domain_.curves[d.curve])) return false;
    const CurvePiece& arc = domain_.curves[c.curve].piece;
    const auto is_close = [&](Point p) { return p != c.a && p != c.b && is_close_outside(c, arc, p); };
    return is_close(d.a) || is_close(d.b);
  }

  bool is_halved(const Chord& c) const { return uses_[c.curve] == EdgeUse::Halved; }

  const Domain& domain_;
  const IdVector<CurveId, EdgeUse>& uses_;
};

}  // namespace

std::vector<CurveId> too_coarse_arcs(const Domain& domain, const Polylines& lines,
                                     const IdVector<CurveId, EdgeUse>& uses) {
  std::vector<CurveId> found;
  if (std::none_of(domain.curves.begin(), domain.curves.end(), [](const auto& c) { return c.piece.is_arc(); }))
    return found;
  const ChordJudge judge(domain, uses);
  const std::vector<Chord> chords = chords_of(domain, lines);
  std::vector<Box> boxes;
  boxes.reserve(chords.size());
  for (const Chord& c : chords) boxes.push_back(box_of(c));
  const BoxTree tree(boxes);
  for (std::size_t i = 0; i < chords.size(); ++i) {
    if (!judge.is_arc(chords[i].curve)) continue;
    tree.query(inflated(boxes[i], judge.reach(chords[i])), [&](std::uint32_t other) {
      if (other == i) return;
      if (const CurveId c = judge.guilty(chords[i], chords[other]); c.valid()) found.push_back(c);
    });
  }
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

}  // namespace quadline
