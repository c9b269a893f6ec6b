// What the tolerance joins, and what it nearly joins.
#include <algorithm>
#include <charconv>
#include <cmath>

#include "domain/arrange/work.hpp"
#include "domain/cell_locator.hpp"

namespace quadline::arrangement {

namespace {

constexpr double kFirstReach = 16;  // in tolerances
constexpr double kWiden = 4;

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
      if (CurveId(i) == end.curve || domain.curves[CurveId(i)].is_auxiliary) return;
      const CurvePiece& piece = domain.curves[CurveId(i)].piece;
      const double d = distance(at, point_at(piece, project(piece, at)));
      if (d < nearest.gap) nearest = {CurveId(i), d};
    });
    if (nearest.curve.valid() || reach >= most) return nearest;
  }
}

}  // namespace

std::string digits(double length) {
  char text[32];
  return {text, std::to_chars(text, text + sizeof text, length, std::chars_format::general, 2).ptr};
}

IdVector<CurveId, std::uint32_t> first_paths(const Domain& domain) {
  IdVector<CurveId, std::uint32_t> first(domain.curves.count(), UINT32_MAX);
  for (std::size_t i = 0; i < domain.paths.size(); ++i)
    for (const DirectedCurve& use : domain.paths[i].curves)
      first[use.curve] = std::min(first[use.curve], static_cast<std::uint32_t>(i));
  return first;
}

void Work::report_joined(const char* what, double gap, Point at) {
  if (gap > rounding) findings.push_back({std::string(what) + ", " + digits(gap) + " apart", "", at});
}

void report_near_misses(const Domain& domain, const Options& options, std::vector<Finding>& findings) {
  const std::vector<LooseEnd> ends = loose_ends(domain);
  const BoxTree tree(boxes_of_curves(domain));
  const double diagonal = distance(domain.box.lo, domain.box.hi);
  const IdVector<CurveId, std::uint32_t> path_of = first_paths(domain);
  const auto name = [&](CurveId c) { return "'" + domain.paths[path_of[c]].name + "'"; };
  std::set<PathPair> told;
  for (const LooseEnd& end : ends) {
    const Point at = domain.vertices[end.vertex].at;
    const auto [other, gap] = nearest_curve(domain, tree, end, kNear * std::min(end.size, diagonal));
    if (!other.valid()) continue;
    findings.push_back({(end.curve.valid() ? name(end.curve) + " ends " : "a point lies ") + digits(gap) + " from " +
                            name(other) +
                            ": elements there become as small; join them (--tolerance), or move them apart",
                        "", at});
    if (end.curve.valid()) told.insert(std::minmax({path_of[end.curve], path_of[other]}));
  }
  report_curves_beside(domain, options, told, findings);
}

}  // namespace quadline::arrangement
