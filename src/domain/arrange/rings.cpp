// Second step of `arrange`: the rings that circles ask for are marked off by a circle round them, where there is room.
#include <algorithm>
#include <cmath>
#include <utility>

#include "base/constants.hpp"
#include "domain/arrange/work.hpp"
#include "domain/size/size_sources.hpp"
#include "quadline/errors.hpp"

namespace quadline::arrangement {

namespace {

constexpr double kFree = 1.0 / 3;        // of a ring's width: what stays free beyond the last one, for a row of quads
constexpr double kTolerancesInRing = 8;  // a ring that is thinner would hardly stand apart from the circle
constexpr double kLeastQuadsInRing = 8;  // of a ring whose number of edges is free

/// What a circle of the model asks for, and how much of it there is room for.
struct Request {
  std::uint32_t route;
  Circle circle;
  std::uint32_t asked;        ///< rings
  double width;               ///< of each
  std::uint32_t n;            ///< rings that have room
  std::string obstacle;       ///< what is in the way of the others
  Point at;                   ///< where
  std::vector<Point> ends{};  ///< vertices on the circle

  double clearance() const { return kFree * width; }
  double reach() const { return circle.radius + n * width + clearance(); }
  Box box() const { return inflated({circle.center, circle.center}, reach()); }
};

/// How far the piece gets from a point.
double farthest(const CurvePiece& piece, Point from) {
  double most = std::max(distance(from, piece.a), distance(from, piece.b));
  if (!piece.is_arc()) return most;
  const Point opposite = piece.center + (piece.center - from);
  if (from == piece.center || is_beside(piece, opposite)) most = distance(from, piece.center) + piece.radius;
  return most;
}

class RingMaker {
 public:
  RingMaker(Work& work, const Options& options) : work_(work), options_(options) {}

  void run() {
    collect();
    refuse_too_many();
    keep_off_curves();
    keep_off_vertices();
    keep_off_each_other();
    for (const Request& request : requests_) make(request);
  }

 private:
  void collect() {
    const Model& model = work_.model;
    std::uint32_t route = static_cast<std::uint32_t>(model.outer.size());
    for (std::size_t i = 0; i < model.outer.size(); ++i) consider(static_cast<std::uint32_t>(i), model.outer[i]);
    for (const Path& hole : model.holes) consider(route++, hole);
    for (const Line& line : model.lines) consider(route++, line.path);
  }

  void consider(std::uint32_t route, const Path& path) {
    if (!path.circle) return;
    const Circle& circle = *path.circle;
    const std::uint32_t asked = circle.rings.value_or(circle.ring_width ? 1 : 0);
    if (asked == 0 && !circle.edges) return;
    requests_.push_back({route, circle, asked, circle.ring_width.value_or(edge_length(circle)), asked, {}, {}});
  }

  /// About the length of an edge on a circle.
  double edge_length(const Circle& circle) const {
    const double around = kFullTurn * circle.radius;
    if (circle.edges) return around / *circle.edges;
    return std::min(work_.size, around / circle_edges(circle.radius, work_.size, options_.edges_per_circle));
  }

  /// Before a circle is made for each of them.
  void refuse_too_many() const {
    double quads = 0;
    for (const Request& r : requests_)
      quads += r.asked * std::max<double>(r.circle.edges.value_or(0), kLeastQuadsInRing);
    if (quads > options_.max_quads)
      throw InputError(ErrorCode::TooManyQuads,
                       "the rings alone need more quads than allowed: ask for fewer, or raise --max-quads",
                       work_.where(where(requests_.front()), requests_.front().circle.center));
  }

  const std::string& where(const Request& r) const { return work_.routes[r.route].where; }
  std::string name(std::uint32_t route) const { return "'" + work_.routes[route].name + "'"; }

  /// Leaves out the rings that come too near to what is so far from the center.
  static void limit(Request& r, double room, const std::string& obstacle, Point at) {
    const double fit = std::floor(std::max(0.0, (room - r.circle.radius) / r.width - kFree));
    if (!(fit < r.n)) return;
    r.n = static_cast<std::uint32_t>(fit);
    r.obstacle = obstacle;
    r.at = at;
  }

  void keep_off_curves() {
    std::vector<Box> boxes;
    for (const Piece& piece : work_.pieces) boxes.push_back(box(piece.curve));
    const BoxTree tree(boxes);
    std::vector<std::uint32_t> route_of(work_.pieces.count());
    for (std::uint32_t i = 0; i < work_.routes.size(); ++i)
      for (const DirectedCurve& use : work_.routes[i].uses) route_of[use.curve.value] = i;
    for (Request& r : requests_) {
      const Point center = r.circle.center;
      if (r.width < kTolerancesInRing * work_.tolerance)
        limit(r, 0, "they are hardly wider than the tolerance", center);
      if (r.n == 0) continue;
      tree.query(r.box(), [&](std::uint32_t i) {
        const CurvePiece& piece = work_.pieces[CurveId(i)].curve;
        if (farthest(piece, center) > edge_of(r))
          limit(r, distance_to(piece, center), name(route_of[i]) + " is in the way",
                point_at(piece, project(piece, center)));
      });
      const Box& b = work_.box;
      const double inside = std::min({center.x - b.lo.x, b.hi.x - center.x, center.y - b.lo.y, b.hi.y - center.y});
      limit(r, inside, "the domain ends there", center);
    }
  }

  /// Up to here from the center things touch the circle, or lie in it.
  double edge_of(const Request& r) const { return r.circle.radius + kTouch * work_.tolerance; }

  /// What ends on the circle is not in the way: the rings get vertices on the same rays.
  void keep_off_vertices() {
    std::vector<Box> boxes;
    for (const Vertex& v : work_.vertices) boxes.push_back({v.at, v.at});
    const BoxTree tree(boxes);
    for (Request& r : requests_) {
      if (r.n == 0) continue;
      tree.query(r.box(), [&](std::uint32_t i) {
        const Vertex& v = work_.vertices[VertexId(i)];
        const double off = distance(v.at, r.circle.center);
        if (v.rank == Rank::Helper || off < r.circle.radius - kTouch * work_.tolerance) return;
        if (off <= edge_of(r)) {
          r.ends.push_back(v.at);
        } else {
          limit(r, off, "a point is in the way", v.at);
        }
      });
    }
  }

  /// Where the rings of two circles do not fit beside each other, both get the half of the gap.
  void keep_off_each_other() {
    std::vector<Box> boxes;
    for (const Request& r : requests_) boxes.push_back(r.box());
    const BoxTree tree(boxes);
    const std::vector<Request> alone = requests_;
    for (std::uint32_t i = 0; i < requests_.size(); ++i) {
      if (alone[i].n == 0) continue;
      tree.query(boxes[i], [&](std::uint32_t k) {
        if (k != i && alone[k].n > 0) keep_apart(requests_[i], alone[i], alone[k]);
      });
    }
  }

  void keep_apart(Request& r, const Request& own, const Request& other) const {
    const double apart = distance(own.circle.center, other.circle.center);
    const double gap = apart - own.circle.radius - other.circle.radius;
    const bool is_twin = std::max(apart, std::abs(own.circle.radius - other.circle.radius)) <= 2 * work_.tolerance;
    if (is_twin && other.route < own.route)
      return limit(r, 0, name(other.route) + " is the same circle and has its rings", own.circle.center);
    const double clearance = std::max(own.clearance(), other.clearance());
    if (gap <= 0 || own.n * own.width + other.n * other.width + clearance <= gap) return;
    const Point way = (1 / apart) * (other.circle.center - own.circle.center);
    const double half = own.circle.radius + 0.5 * gap;
    limit(r, half - 0.5 * clearance + own.clearance(), "the rings of " + name(other.route) + " are in the way",
          own.circle.center + half * way);
  }

  void make(const Request& r) {
    if (r.n < r.asked) tell(r);
    work_.washers.push_back(
        {r.route, r.circle.edges.value_or(0), r.n, static_cast<std::uint32_t>(work_.routes.size())});
    if (r.n == 0) return;
    const Circle outer{r.circle.center, r.circle.radius + r.n * r.width};
    Route route{.where = where(r), .size = kInfinity};
    add_circle(work_, outer, route);
    work_.routes.push_back(std::move(route));
    for (const Point end : r.ends)
      work_.vertices.push_back(
          {.at = outer.center + (outer.radius / r.circle.radius) * (end - outer.center), .rank = Rank::Point});
  }

  void tell(const Request& r) {
    const std::string made =
        r.n == 0 ? " gets no rings" : " gets " + std::to_string(r.n) + " of " + std::to_string(r.asked) + " rings";
    work_.findings.push_back({name(r.route) + made + ": " + r.obstacle +
                                  "; ask for fewer or thinner rings, or move it; a third of their width stays free",
                              where(r), r.at, true});
  }

  Work& work_;
  const Options& options_;
  std::vector<Request> requests_;
};

}  // namespace

void add_rings(Work& work, const Options& options) { RingMaker(work, options).run(); }

}  // namespace quadline::arrangement
