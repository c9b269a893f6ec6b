// First step of `arrange`: checks the model and lays out its paths as vertices and pieces.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/constants.hpp"
#include "domain/arrange/unique_names.hpp"
#include "domain/arrange/work.hpp"

namespace quadline::arrangement {

namespace {

// Fourth powers of lengths have to stay finite and normal.
constexpr double kLargest = 1e60;
constexpr double kSmallest = 1e-60;

// Model data are rounded to about 1e-9 of the coordinates, and an arc through three rounded points is off by some times
// that: nobody wants to hear of it. A micrometre on a plate of a metre is well above it and below any detail meant.
constexpr double kRelativeRounding = 1e-8;
constexpr double kRelativeTolerance = 8e-7;
// Of the least size: elements keep their shape whatever the tolerance moves; a tolerance asked for may be larger.
constexpr double kToleranceInSize = 1e-3, kMostInSize = 0.25;
// Far from the origin the spacing of the numbers themselves counts.
constexpr double kUnitsInTolerance = 0x1p-48;
// So it does for the nodes round a tiny element.
constexpr double kUnitsInSize = 0x1p-40;
// An arc this much flatter than the tolerance is straight; its centre could not be computed.
constexpr double kFlatArc = 1.0 / 16;
// An arc of more than half a turn that is so many times larger than the domain is a mistake.
constexpr double kFarArc = 100;
constexpr double kFarPoint = 1e4;
// Arcs of more than this turn are halved; some way from a half turn, so that rounding does not matter.
constexpr double kHalfTurn = 3.0;

/// A piece of the last step.
void add_piece(Work& work, Route& route, VertexId tail, VertexId head, const CurvePiece& curve) {
  const std::uint32_t origin = static_cast<std::uint32_t>(work.steps.size() - 1);
  const CurveId id = work.pieces.push_back({.tail = tail, .head = head, .curve = curve, .origin = origin});
  route.uses.push_back({.curve = id});
}

class Reader {
 public:
  explicit Reader(const Model& model) : work_{.model = model} {}

  Work read(const Options& options) {
    read_sizes(options);
    find_tolerance(options);
    for (std::size_t i = 0; i < work_.model.outer.size(); ++i) add_loop(work_.model.outer[i], CurveKind::Outer, i);
    for (std::size_t i = 0; i < work_.model.holes.size(); ++i) add_loop(work_.model.holes[i], CurveKind::Hole, i);
    for (std::size_t i = 0; i < work_.model.lines.size(); ++i) add_line(work_.model.lines[i], i);
    for (const NamedPoint& point : work_.model.points) {
      check_point(point.at, point.where);
      work_.point_vertex.push_back(work_.vertices.push_back({.at = point.at, .rank = Rank::Point}));
    }
    for (const Region& region : work_.model.regions) check_point(region.at, region.where);
    return std::move(work_);
  }

 private:
  [[noreturn]] void fail(const std::string& message, const std::string& place) const {
    throw InputError(message, {.file = work_.model.file, .place = place, .point = {}});
  }
  [[noreturn]] void fail(const std::string& message, const std::string& place, Point at) const {
    throw InputError(message, work_.where(place, at));
  }

  void read_sizes(const Options& options) {
    work_.size = options.size.value_or(work_.model.size);
    for_each_size([&](double size, const std::string& what, const std::string& place) {
      if (!(std::isfinite(size) && size > 0))
        fail("the size of " + what + " is not a positive number: give the edge length wanted", place);
    });
  }

  void check_sizes_beside(double farthest) const {
    const double least = kUnitsInSize * farthest;
    for_each_size([&](double size, const std::string& what, const std::string& place) {
      if (size < least)
        fail("the size of " + what + " is too small beside the coordinates: give " + digits(least) + " at least",
             place);
    });
  }

  // Calls visit(size, whose, place) for every size that is given.
  template <class Visit>
  void for_each_size(Visit visit) const {
    const Model& model = work_.model;
    visit(work_.size, std::string("the model"), std::string("/size"));
    const auto see = [&](const char* kind, const std::string& name, std::optional<double> size, const std::string& at) {
      if (size) visit(*size, name.empty() ? std::string("a ") + kind : kind + (" '" + name + "'"), at);
    };
    for (const Line& line : model.lines) see("line", line.name, line.size, line.path.where);
    for (const NamedPoint& point : model.points) see("point", point.name, point.size, point.where);
    for (const Region& region : model.regions) see("region", region.name, region.size, region.where);
  }

  void check_point(Point p, const std::string& place) const {
    if (!std::isfinite(p.x) || !std::isfinite(p.y)) fail("a coordinate is not a finite number", place);
    if (std::max(std::abs(p.x), std::abs(p.y)) > kLargest) {
      fail("a coordinate is larger than 1e60: use other units", place, p);
    }
    const Point off{std::max(work_.box.lo.x - p.x, p.x - work_.box.hi.x),
                    std::max(work_.box.lo.y - p.y, p.y - work_.box.hi.y)};
    if (std::max(off.x, off.y) > kFarPoint * diagonal_) {
      fail("a point lies ten thousand times farther off than the domain is large: check its coordinates", place, p);
    }
  }

  void check_path(const Path& path) const {
    if (path.circle) {
      const Circle& circle = *path.circle;
      check_point(circle.center, path.where);
      if (circle.radius > kLargest && std::isfinite(circle.radius)) {
        fail("the radius of a circle is larger than 1e60: use other units", path.where, circle.center);
      }
      if (!(circle.radius > 0 && std::isfinite(circle.radius))) {
        fail("the radius of a circle is not a positive number", path.where, circle.center);
      }
      check_washer(circle, path.where);
      return;
    }
    for (std::size_t i = 0; i < path.items.size(); ++i) {
      check_point(path.items[i].to, place_of(path, i));
      if (path.items[i].via) check_point(*path.items[i].via, place_of(path, i));
    }
    if (!path.items.empty() && path.items[0].via)
      fail("a path starts with a point, not with an arc", place_of(path, 0));
  }

  void check_washer(const Circle& circle, const std::string& place) const {
    const std::uint32_t edges = circle.edges.value_or(kLeastCircleEdges), rings = circle.rings.value_or(1);
    if (edges < kLeastCircleEdges || edges > kMostCircleEdges || edges % 2 != 0) {
      fail("the number of edges round a circle is not an even number from " + std::to_string(kLeastCircleEdges) +
               " to " + std::to_string(kMostCircleEdges),
           place, circle.center);
    }
    if (rings < 1 || rings > kMostRings) {
      fail("the number of rings is not from 1 to " + std::to_string(kMostRings), place, circle.center);
    }
    if (const double width = circle.ring_width.value_or(1); !(width > 0 && width <= kLargest)) {
      fail("the width of a ring is not a positive number up to 1e60", place, circle.center);
    }
  }

  static std::string place_of(const Path& path, std::size_t item) {
    return path.where.starts_with('/') ? path.where + "/" + std::to_string(item) : path.where;
  }

  void find_tolerance(const Options& options) {
    if (work_.model.outer.empty()) fail("the model has no outer loop: give the boundary of the domain", "/outer");
    Box b{{kInfinity, kInfinity}, {-kInfinity, -kInfinity}};
    diagonal_ = kInfinity;  // until it is known
    const auto cover = [&b](Point p, double r) {
      b.lo = {std::min(b.lo.x, p.x - r), std::min(b.lo.y, p.y - r)};
      b.hi = {std::max(b.hi.x, p.x + r), std::max(b.hi.y, p.y + r)};
    };
    for (const Path& path : work_.model.outer) {
      check_path(path);
      if (path.circle) cover(path.circle->center, path.circle->radius);
      for (const PathItem& item : path.items) {
        cover(item.to, 0);
        if (item.via) cover(*item.via, 0);
      }
    }
    const double diagonal = distance(b.lo, b.hi);
    work_.box = b;
    diagonal_ = diagonal;
    const double farthest = std::max({std::abs(b.lo.x), std::abs(b.lo.y), std::abs(b.hi.x), std::abs(b.hi.y)});
    const double least = kUnitsInTolerance * farthest;
    work_.tolerance = std::max(std::min(kRelativeTolerance * diagonal, kToleranceInSize * least_size()), least);
    work_.rounding = std::max(kRelativeRounding * diagonal, least);
    if (options.tolerance) take_tolerance(*options.tolerance, least);
    if (!(diagonal > kSmallest)) {
      fail("the outer loop has no area: it needs three distinct points", work_.model.outer[0].where);
    }
    if (diagonal < 16 * work_.tolerance) {
      fail("the domain is too small for its distance from the origin: move it nearer", work_.model.outer[0].where,
           b.lo);
    }
    check_sizes_beside(farthest);
  }

  double least_size() const {
    double least = work_.size;
    for_each_size([&](double size, const std::string&, const std::string&) { least = std::min(least, size); });
    return least;
  }

  void take_tolerance(double tolerance, double least) {
    if (!(std::isfinite(tolerance) && tolerance > 0)) {
      fail("the tolerance is not a positive number: give the distance below which points are one", "tolerance");
    }
    if (tolerance > kMostInSize * least_size()) {
      fail("the tolerance is more than a quarter of the least size: choose a smaller one", "tolerance");
    }
    work_.tolerance = std::max(tolerance, least);
  }

  std::string unique_name(const std::string& name, const std::string& place, Point at) {
    const std::string own = names_.take(name);
    if (own != name)
      work_.findings.push_back(
          {"the name '" + name + "' is given twice: the second is called '" + own + "'", place, at});
    return own;
  }

  static Point first_point(const Path& path) {
    if (path.circle) return path.circle->center + Point{path.circle->radius, 0};
    return path.items.empty() ? Point{} : path.items[0].to;
  }

  void add_loop(const Path& path, CurveKind kind, std::size_t i) {
    const std::string what = kind == CurveKind::Outer ? "outer" : "hole";
    check_path(path);
    if (kind == CurveKind::Outer && path.circle && (path.circle->rings || path.circle->ring_width)) {
      fail("rings lie round holes and round lines, not round an outer loop", path.where, path.circle->center);
    }
    route_ = {.kind = kind, .where = path.where, .size = kInfinity};
    route_.name = unique_name(what + "-" + std::to_string(i + 1), path.where, first_point(path));
    if (path.circle) {
      add_circle(work_, *path.circle, route_);
    } else {
      add_chain(path, true);
    }
    route_.area = area(route_);
    double perimeter = 0;
    for (const DirectedCurve& use : route_.uses) perimeter += length(work_.pieces[use.curve].curve);
    route_.is_flat = !(std::abs(route_.area) > 0.5 * work_.tolerance * perimeter);
    route_.start = first_point(path);
    work_.routes.push_back(std::move(route_));
  }

  void add_line(const Line& line, std::size_t i) {
    check_path(line.path);
    route_ = {.kind = CurveKind::Line, .where = line.path.where, .size = line.size.value_or(kInfinity)};
    const std::string name = line.name.empty() ? "line-" + std::to_string(i + 1) : line.name;
    route_.name = unique_name(name, line.path.where, first_point(line.path));
    if (line.path.circle) {
      add_circle(work_, *line.path.circle, route_);
    } else {
      add_chain(line.path, false);
    }
    work_.routes.push_back(std::move(route_));
  }

  double area(const Route& route) const {
    if (route.uses.empty()) return 0;
    const Point origin = work_.pieces[route.uses[0].curve].curve.a;
    double twice = 0;
    for (const DirectedCurve& use : route.uses) twice += twice_area_under(work_.pieces[use.curve].curve, origin);
    return 0.5 * twice;
  }

  void add_chain(const Path& path, bool is_loop) {
    if (path.items.empty()) return;
    const VertexId first = work_.vertices.push_back({.at = path.items[0].to, .rank = Rank::Corner});
    VertexId tail = first;
    for (std::size_t i = 1; i < path.items.size(); ++i) {
      const PathItem& item = path.items[i];
      const bool closes = i + 1 == path.items.size() && item.to == path.items[0].to;
      const VertexId head = closes ? first : work_.vertices.push_back({.at = item.to, .rank = Rank::Corner});
      add_step(tail, head, item.via, place_of(path, i));
      tail = head;
    }
    if (is_loop && tail != first) add_step(tail, first, {}, path.where);
  }

  void add_step(VertexId tail, VertexId head, std::optional<Point> via, const std::string& place) {
    const Point a = work_.vertices[tail].at;
    const Point b = work_.vertices[head].at;
    const CurvePiece arc = via ? bent(a, *via, b, place) : CurvePiece{.a = a, .b = b};
    work_.steps.push_back(arc);
    if (std::abs(arc.sweep) > kHalfTurn) {
      const double middle = 0.5 * length(arc);
      const VertexId half = work_.vertices.push_back({.at = point_at(arc, middle), .rank = Rank::Helper});
      const Point m = work_.vertices[half].at;
      add_piece(work_, route_, tail, half, sub_piece(arc, 0, middle, a, m));
      add_piece(work_, route_, half, head, sub_piece(arc, middle, 2 * middle, m, b));
    } else {
      add_piece(work_, route_, tail, head, arc);
    }
  }

  CurvePiece bent(Point a, Point via, Point b, const std::string& place) {
    const CurvePiece chord{.a = a, .b = b};
    const double flat = kFlatArc * work_.tolerance;
    if (distance(a, b) <= work_.tolerance && distance_to(chord, via) > work_.tolerance) {
      fail("an arc ends where it starts: give a circle, or two arcs", place, a);
    }
    if (std::min(distance(a, via), distance(b, via)) <= work_.tolerance) {
      work_.findings.push_back({"an arc's middle point lies at its end: taken as straight", place, via});
      return chord;
    }
    if (distance_to(chord, via) <= flat) return chord;
    const CurvePiece arc = arc_through(a, via, b);
    if (!arc.is_arc() || (std::abs(arc.sweep) > kHalfTurn && arc.radius > kFarArc * diagonal_)) {
      fail("the middle point of an arc lies in line with its ends, but not between them", place, via);
    }
    return arc;
  }

  Work work_;
  double diagonal_ = 0;  ///< of the box of the outer loops
  Route route_;
  UniqueNames names_;
};

}  // namespace

void add_circle(Work& work, const Circle& circle, Route& route) {
  const Point east = circle.center + Point{circle.radius, 0};
  const Point west = circle.center - Point{circle.radius, 0};
  const VertexId e = work.vertices.push_back({.at = east, .rank = Rank::Helper});
  const VertexId w = work.vertices.push_back({.at = west, .rank = Rank::Helper});
  CurvePiece half{.a = east, .b = west, .center = circle.center, .radius = circle.radius};
  half.sweep = std::numbers::pi;
  work.steps.push_back(half);
  add_piece(work, route, e, w, half);
  std::swap(half.a, half.b);
  add_piece(work, route, w, e, half);
}

Work read_input(const Model& model, const Options& options) { return Reader(model).read(options); }

}  // namespace quadline::arrangement
