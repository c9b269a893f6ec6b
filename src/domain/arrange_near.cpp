// What the tolerance joins, and what it nearly joins.
#include <algorithm>
#include <charconv>
#include <cmath>

#include "domain/arrange_work.hpp"

namespace quadline::arrangement {

namespace {

constexpr double kNear = 0.1;       // in sizes
constexpr double kFirstReach = 16;  // in tolerances
constexpr double kWiden = 4;

std::string digits(double length) {
  char text[32];
  return {text, std::to_chars(text, text + sizeof text, length, std::chars_format::general, 2).ptr};
}

/// A vertex that ends one curve, or none, and so may have been meant to lie on another.
struct LooseEnd {
  VertexId vertex;
  CurveId curve;  ///< that it ends; invalid: a point
  double size;
};

std::vector<LooseEnd> loose_ends(const Domain& domain) {
  IdVector<VertexId, int> degree(domain.vertices.count(), 0);
  for (const Domain::Curve& curve : domain.curves) {
    ++degree[curve.tail];
    ++degree[curve.head];
  }
  std::vector<LooseEnd> ends;
  for (std::size_t i = 0; i < domain.curves.count(); ++i) {
    const Domain::Curve& curve = domain.curves[CurveId(i)];
    if (!curve.left.valid()) continue;
    for (const VertexId v : {curve.tail, curve.head})
      if (degree[v] == 1) ends.push_back({v, CurveId(i), std::min(domain.cells[curve.left].size, curve.size)});
  }
  for (std::size_t i = 0; i < domain.cells.count(); ++i)
    for (const VertexId v : domain.cells[CellId(i)].lone_points)
      ends.push_back({v, CurveId(), domain.cells[CellId(i)].size});
  return ends;
}

/// A name for every curve: of the first path along it.
IdVector<CurveId, std::string> names_of_curves(const Domain& domain) {
  IdVector<CurveId, std::string> names(domain.curves.count());
  for (const Domain::Path& path : domain.paths)
    for (const DirectedCurve& use : path.curves)
      if (names[use.curve].empty()) names[use.curve] = "'" + path.name + "'";
  return names;
}

struct Neighbour {
  CurveId curve;
  double gap;
};

/// The curve nearest to a loose end, of those nearer than `most`; invalid: none. The search widens until it meets one,
/// so that what it looks at does not grow with the size.
Neighbour nearest_curve(const Domain& domain, const BoxTree& tree, const LooseEnd& end, double most) {
  const Point at = domain.vertices[end.vertex].at;
  for (double reach = kFirstReach * domain.tolerance;; reach *= kWiden) {
    Neighbour nearest{CurveId(), std::min(reach, most)};
    tree.query(inflated({at, at}, nearest.gap), [&](std::uint32_t i) {
      if (CurveId(i) == end.curve) return;
      const CurvePiece& piece = domain.curves[CurveId(i)].piece;
      const double d = distance(at, point_at(piece, project(piece, at)));
      if (d < nearest.gap) nearest = {CurveId(i), d};
    });
    if (nearest.curve.valid() || reach >= most) return nearest;
  }
}

}  // namespace

void Work::report_joined(const char* what, double gap, Point at) {
  if (gap > rounding) findings.push_back({std::string(what) + ", " + digits(gap) + " apart", "", at});
}

void report_near_misses(const Domain& domain, std::vector<Finding>& findings) {
  const std::vector<LooseEnd> ends = loose_ends(domain);
  if (ends.empty()) return;
  std::vector<Box> boxes;
  for (const Domain::Curve& curve : domain.curves) boxes.push_back(box(curve.piece));
  const BoxTree tree(boxes);
  const double diagonal = distance(domain.box.lo, domain.box.hi);
  const IdVector<CurveId, std::string> names = names_of_curves(domain);
  for (const LooseEnd& end : ends) {
    const Point at = domain.vertices[end.vertex].at;
    const auto [other, gap] = nearest_curve(domain, tree, end, kNear * std::min(end.size, diagonal));
    if (other.valid())
      findings.push_back({(end.curve.valid() ? names[end.curve] + " ends " : "a point lies ") + digits(gap) + " from " +
                              names[other] +
                              ": elements there become as small; join them (--tolerance), or move them apart",
                          "", at});
  }
}

}  // namespace quadline::arrangement
