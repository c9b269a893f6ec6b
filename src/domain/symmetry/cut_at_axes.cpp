#include "domain/symmetry/cut_at_axes.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <set>
#include <utility>
#include <vector>

#include "domain/cell_locator.hpp"
#include "domain/symmetry/split_cells.hpp"
#include "domain/symmetry/symmetries.hpp"
#include "domain/walk_places.hpp"

namespace quadline {

namespace {

constexpr double kLeastLength = 1;  // of a cut, in sizes of its cell
constexpr double kLeastHalf = 0.6;  // of a curve that it halves
constexpr double kFlat = 0.2;       // radians: on an arc that turns less nobody sees uneven chords
constexpr double kBeside = 1.2;     // nothing of the boundary may be as near, but at the ends
constexpr double kStep = 0.5;       // between the places where that is looked at

// A place of the axis where curves are: at the distance `along` from the middle of the box.
struct Stop {
  double along;
  CutEnd end;
};

class AxisCutter {
 public:
  AxisCutter(const Domain& domain, const Symmetry& symmetry)
      : domain_(domain),
        symmetry_(symmetry),
        centre_(midpoint(domain.box.lo, domain.box.hi)),
        locator_(domain),
        tree_(boxes_of_curves(domain)) {
    constexpr Point kAside{1, 0.3};
    const Point fixed = kAside + symmetry.move.turned(kAside);
    axis_ = (1 / norm(fixed)) * fixed;
  }

  // The cuts through all cells that stand them.
  std::vector<Cut> run(const CellSet& given) const {
    const std::vector<Stop> stops = sorted_stops();
    std::vector<Cut> cuts;
    std::set<CellId> whole = beside_turned_circles();  // cells that are not cut
    for (std::size_t i = 1; i < stops.size(); ++i) {
      const Stop &from = stops[i - 1], &to = stops[i];
      if (is_on_curve(from.end.vertex, to.end.vertex)) continue;
      const CellId cell = locator_.at(centre_ + 0.5 * (from.along + to.along) * axis_);
      if (!cell.valid()) continue;
      cuts.push_back({cell, from.end, to.end});
      if (given.contains(cell) || has_plain_rows(domain_, cell) || !is_harmless(cell, from, to)) whole.insert(cell);
    }
    std::erase_if(cuts, [&](const Cut& cut) { return whole.contains(cut.cell); });
    return cuts;
  }

 private:
  Stop stop(Point at, CutEnd end) const { return {dot(at - centre_, axis_), end}; }

  std::vector<Stop> sorted_stops() const {
    std::vector<Stop> stops;
    for (std::size_t i = 0; i < domain_.vertices.count(); ++i)
      if (const VertexId v(i); symmetry_.vertices[v] == v && is_on_axis(domain_.vertices[v].at))
        stops.push_back(stop(domain_.vertices[v].at, {v, {}}));
    for (std::size_t i = 0; i < domain_.curves.count(); ++i) {
      const CurveId c(i);
      if (symmetry_.curves[c].curve != c || !symmetry_.curves[c].reversed) continue;
      const CurvePiece& piece = domain_.curves[c].piece;
      const Point middle = point_at(piece, 0.5 * length(piece));
      if (is_on_axis(middle)) stops.push_back(stop(middle, {{}, c}));
    }
    std::sort(stops.begin(), stops.end(), [](const Stop& a, const Stop& b) {
      return a.along != b.along ? a.along < b.along : a.end.vertex < b.end.vertex;
    });
    return stops;
  }

  bool is_on_axis(Point p) const { return std::abs(cross(axis_, p - centre_)) <= 2 * domain_.tolerance; }

  // Whole circles that the axis meets neither at the ends nor at the middles of their arcs.
  std::set<CellId> beside_turned_circles() const {
    std::set<CellId> cells;
    for (std::size_t i = 0; i < domain_.curves.count(); ++i) {
      const Domain::Curve& c = domain_.curves[CurveId(i)];
      if (!symmetry_.is_whole_circle[CurveId(i)]) continue;
      if (std::abs(cross(axis_, c.piece.center - centre_)) > c.piece.radius) continue;
      if (is_on_axis(c.piece.a) || is_on_axis(point_at(c.piece, 0.5 * length(c.piece)))) continue;
      cells.insert(c.left);
      cells.insert(c.right);
    }
    return cells;
  }

  // Curves along the axis end at vertices that follow each other.
  bool is_on_curve(VertexId a, VertexId b) const {
    if (!a.valid() || !b.valid()) return false;
    bool is_on = false;
    const Point middle = midpoint(domain_.vertices[a].at, domain_.vertices[b].at);
    tree_.query({middle, middle}, [&](std::uint32_t item) {
      const Domain::Curve& c = domain_.curves[CurveId(item)];
      is_on |= (c.tail == a && c.head == b) || (c.tail == b && c.head == a);
    });
    return is_on;
  }

  bool is_harmless(CellId cell, const Stop& from, const Stop& to) const {
    const double size = domain_.cells[cell].size;
    if (to.along - from.along < kLeastLength * size) return false;
    for (const CutEnd& end : {from.end, to.end}) {
      if (!end.curve.valid()) continue;
      const CurvePiece& piece = domain_.curves[end.curve].piece;
      if (0.5 * length(piece) < kLeastHalf * size || domain_.curves[end.curve].edges % 2 != 0) return false;
      // It would need an even number of edges, and those beside it on the circle would not.
      if (!symmetry_.is_whole_circle[end.curve] && goes_on(end.curve)) return false;
    }
    return is_wide(cell, from.end, axis_) && is_wide(cell, to.end, -1.0 * axis_) && has_room(cell, from, to);
  }

  // The arc is a part of a longer one, of which other cells have a part.
  bool goes_on(CurveId arc) const {
    const CurvePiece& piece = domain_.curves[arc].piece;
    bool goes_on = false;
    for (const VertexId end : {domain_.curves[arc].tail, domain_.curves[arc].head}) {
      int n_there = 0;
      bool is_same = false;
      const Point at = domain_.vertices[end].at;
      tree_.query({at, at}, [&](std::uint32_t item) {
        const Domain::Curve& other = domain_.curves[CurveId(item)];
        if (other.tail != end && other.head != end) return;
        ++n_there;
        is_same |= CurveId(item) != arc && other.piece.is_arc() && other.piece.center == piece.center;
      });
      goes_on |= std::abs(piece.sweep) > kFlat && is_same && n_there > 2;
    }
    return goes_on;
  }

  // The half of the corner that the cut leaves is 67.5 degrees or more.
  bool is_wide(CellId cell, const CutEnd& end, Point direction) const {
    constexpr double kCosine = 0.38268343236508984;
    if (!end.vertex.valid()) return true;
    bool is_wide = true;
    const Point at = domain_.vertices[end.vertex].at;
    tree_.query({at, at}, [&](std::uint32_t item) {
      const Domain::Curve& c = domain_.curves[CurveId(item)];
      if (c.left != cell && c.right != cell) return;
      if (c.tail == end.vertex) is_wide &= dot(tangent_at(c.piece, 0), direction) < kCosine;
      if (c.head == end.vertex) is_wide &= -dot(tangent_at(c.piece, length(c.piece)), direction) < kCosine;
    });
    return is_wide;
  }

  bool has_room(CellId cell, const Stop& from, const Stop& to) const {
    const double size = domain_.cells[cell].size, near = kBeside * size;
    bool has_room = true;
    for (double t = from.along + near + 0.1 * size; t < to.along - near && has_room; t += kStep * size) {
      const Point p = centre_ + t * axis_;
      tree_.query(inflated({p, p}, near), [&](std::uint32_t item) {
        const Domain::Curve& c = domain_.curves[CurveId(item)];
        if (c.left != cell && c.right != cell) return;
        has_room &= distance(p, point_at(c.piece, project(c.piece, p))) >= near;
      });
    }
    return has_room;
  }

  const Domain& domain_;
  const Symmetry& symmetry_;
  Point centre_, axis_;
  const CellLocator locator_;
  const BoxTree tree_;
};

// Lengths of the sides between the corners of a walk, which turn left by about a right angle; of one side where there
// is no corner, of none where a corner is neither right nor nearly straight.
std::vector<double> side_lengths(const Domain& domain, const std::vector<DirectedCurve>& walk) {
  constexpr double kStraight = 0.9, kRight = 0.5;  // cosines of the turn
  std::vector<double> sides{0};
  double before_first = 0;
  for (std::size_t i = 0; i < walk.size(); ++i) {
    const DirectedCurve in = walk[(i + walk.size() - 1) % walk.size()], out = walk[i];
    const CurvePiece &a = domain.curves[in.curve].piece, &b = domain.curves[out.curve].piece;
    const Point u = in.reversed ? -1.0 * tangent_at(a, 0) : tangent_at(a, length(a));
    const Point v = out.reversed ? -1.0 * tangent_at(b, length(b)) : tangent_at(b, 0);
    if (dot(u, v) <= kStraight) {
      if (std::abs(dot(u, v)) > kRight || cross(u, v) < 0) return {};
      if (sides.size() == 1) before_first = sides[0];
      sides.push_back(0);
    }
    sides.back() += length(b);
  }
  if (sides.size() > 1) {
    sides.erase(sides.begin());
    sides.back() += before_first;
  }
  return sides;
}

bool are_near(double a, double b, double ratio) { return a <= ratio * b && b <= ratio * a; }

}  // namespace

bool has_plain_rows(const Domain& domain, CellId cell) {
  constexpr double kMostRound = 1.75, kMostAcross = 1.1;  // ratios of lengths that equal numbers of edges suit
  const Domain::Cell& c = domain.cells[cell];
  if (!c.lone_points.empty() || c.walks.size() > 2) return false;
  const std::vector<double> outer = side_lengths(domain, c.walks[0]);
  if (c.walks.size() == 1)
    return outer.size() == 4 && are_near(outer[0], outer[2], kMostAcross) && are_near(outer[1], outer[3], kMostAcross);
  const std::vector<double> inner = side_lengths(domain, c.walks[1]);
  return outer.size() == 1 && inner.size() == 1 && are_near(outer[0], inner[0], kMostRound);
}

Domain cut_at_axes(Domain domain, const CellSet& whole) {
  constexpr std::size_t kAxes = 4;
  for (std::size_t pass = 0; pass < kAxes; ++pass) {
    std::vector<Cut> cuts;
    for (const Symmetry& symmetry : find_symmetries(domain)) {
      if (!symmetry.move.is_mirrored) continue;
      cuts = AxisCutter(domain, symmetry).run(whole);
      if (!cuts.empty()) break;
    }
    if (cuts.empty()) break;
    domain = split_cells(std::move(domain), cuts);
  }
  return domain;
}

}  // namespace quadline
