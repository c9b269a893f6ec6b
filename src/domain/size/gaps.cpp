#include <algorithm>
#include <cmath>
#include <limits>

#include "domain/cell_locator.hpp"
#include "domain/size/size_sources.hpp"
#include "domain/walk_places.hpp"
#include "search/box_tree.hpp"

// Gaps by looking along the normals of the curves, and from the vertices to the nearest curve. A wedge between two
// curves that meet is no gap: it closes however small the edges are. Source: the local feature size of
// [Persson2006], here without a medial axis.

namespace quadline {
namespace {

constexpr double kNone = std::numeric_limits<double>::infinity();
constexpr double kGapStretch = 2;       // size in a gap, over its width: one row of quads twice as long as wide
constexpr double kLeastGapShare = 0.4;  // least size that a gap asks for, over the base size

class GapFinder {
 public:
  GapFinder(const Domain& domain, const IdVector<CurveId, double>& sizes, std::vector<SizeSource>& sources)
      : domain_(domain),
        sizes_(sizes),
        sources_(sources),
        walks_(domain),
        tree_(boxes_of_curves(domain)),
        points_(boxes_of_points()) {
    collect_stars();
  }

  void find() {
    for (std::size_t i = 0; i < domain_.curves.count(); ++i)
      for (bool is_left : {true, false}) look_along_normals(CurveId(i), is_left);
    for (std::size_t i = 0; i < domain_.vertices.count(); ++i) look_around(VertexId(i));
    for (std::size_t i = 0; i < lone_.size(); ++i) look_around_lone(i);
  }

 private:
  struct LonePoint {
    VertexId vertex;
    double base;
  };
  struct Hit {
    CurveId curve;
    double distance = kNone;
  };

  std::vector<Box> boxes_of_points() {
    std::vector<Box> boxes;
    for (const Domain::Cell& cell : domain_.cells)
      for (VertexId v : cell.lone_points) {
        lone_.push_back({v, cell.size});
        boxes.push_back({domain_.vertices[v].at, domain_.vertices[v].at});
      }
    return boxes;
  }

  void collect_stars() {
    star_start_.assign(domain_.vertices.count() + 1, 0);
    for (const Domain::Curve& c : domain_.curves)
      for (VertexId v : {c.tail, c.head}) ++star_start_[v.value + 1];
    for (std::size_t i = 1; i < star_start_.size(); ++i) star_start_[i] += star_start_[i - 1];
    star_.resize(star_start_.back());
    std::vector<std::uint32_t> next(star_start_.begin(), star_start_.end() - 1);
    for (std::size_t i = 0; i < domain_.curves.count(); ++i) {
      const Domain::Curve& c = domain_.curves[CurveId(i)];
      star_[next[c.tail.value]++] = {CurveId(i), false};
      star_[next[c.head.value]++] = {CurveId(i), true};
    }
  }

  /// The curve seen first from p in direction d.
  Hit first_hit(Point p, Point d, double reach, CurveId but) const {
    const Point q = p + reach * d;
    Hit best;
    tree_.query({{std::min(p.x, q.x), std::min(p.y, q.y)}, {std::max(p.x, q.x), std::max(p.y, q.y)}},
                [&](std::uint32_t item) {
                  const CurveId c(item);
                  if (c == but) return;
                  const double t = ray_distance(p, d, reach, domain_.curves[c].piece);
                  if (t < best.distance || (t == best.distance && best.curve.valid() && c < best.curve)) best = {c, t};
                });
    return best;
  }

  double gap_size(double gap, double base) const { return std::max(kLeastGapShare * base, kGapStretch * gap); }

  void look_along_normals(CurveId id, bool is_left) {
    const CellId cell = cell_on(domain_.curves[id], is_left);
    if (!cell.valid() || domain_.cells[cell].rings > 0) return;
    const CurvePiece& piece = domain_.curves[id].piece;
    const double base = domain_.cells[cell].size, whole = length(piece),
                 reach = std::min(base, sizes_[id]) / kGapStretch;
    const double n = std::ceil(std::max(whole / (0.5 * base), piece.is_arc() ? 4 * std::abs(piece.sweep) / 3 : 1.0));
    for (double i = 0; i < n; ++i) {
      const double s = whole * ((i + 0.5) / n);
      const Point p = point_at(piece, s), normal = left_normal(tangent_at(piece, s));
      const Hit hit = first_hit(p, is_left ? normal : -1.0 * normal, reach, id);
      if (!hit.curve.valid() || share_vertex(domain_.curves[id], domain_.curves[hit.curve])) continue;
      if (domain_.curves[id].has_rings || domain_.curves[hit.curve].has_rings) continue;
      const CurvePiece& other = domain_.curves[hit.curve].piece;
      const double at = project(other, p + hit.distance * (is_left ? normal : -1.0 * normal));
      if (walks_.is_wedge(id, is_left, s, hit.curve, is_left_of(other, at, p), at, base)) continue;
      const double size = gap_size(hit.distance, base);
      if (size >= base) continue;
      append_sources(piece, whole * (i / n), whole * ((i + 1) / n), size, false, sources_);
      const Point q = point_at(other, at);
      sources_.push_back({q, q, size});
    }
  }

  /// The outgoing side at v whose sector holds the direction d.
  DirectedCurve sector(VertexId v, Point d) const {
    const auto turn = [](Point from, Point to) {  // counter-clockwise from..to as 0..4, monotone in the angle
      const double c = dot(from, to), s = cross(from, to), sum = std::abs(c) + std::abs(s);
      if (sum == 0) return 0.0;
      return s >= 0 ? 1 - c / sum : 3 + c / sum;
    };
    DirectedCurve best;
    double least = kNone;
    for (std::uint32_t k = star_start_[v.value]; k < star_start_[v.value + 1]; ++k) {
      const CurvePiece& piece = domain_.curves[star_[k].curve].piece;
      const Point out = star_[k].reversed ? -1.0 * tangent_at(piece, length(piece)) : tangent_at(piece, 0);
      const double angle = turn(out, d);
      if (angle < least) {
        least = angle;
        best = star_[k];
      }
    }
    return best;
  }

  bool is_at(CurveId c, VertexId v) const { return domain_.curves[c].tail == v || domain_.curves[c].head == v; }

  Hit nearest(VertexId v, double reach) const {
    const Point p = domain_.vertices[v].at;
    Hit best;
    tree_.query(inflated({p, p}, reach), [&](std::uint32_t item) {
      const CurveId c(item);
      if (is_at(c, v)) return;
      const CurvePiece& piece = domain_.curves[c].piece;
      const double d = distance(p, point_at(piece, project(piece, p)));
      if (d > reach) return;
      if (d < best.distance || (d == best.distance && c < best.curve)) best = {c, d};
    });
    return best;
  }

  void look_around(VertexId v) {
    if (star_start_[v.value] == star_start_[v.value + 1]) return;
    double reach = 0;
    for (std::uint32_t k = star_start_[v.value]; k < star_start_[v.value + 1]; ++k)
      reach = std::max(reach, base_size(domain_, domain_.curves[star_[k].curve]));
    const Hit hit = nearest(v, reach / kGapStretch);
    if (!hit.curve.valid() || domain_.curves[hit.curve].has_rings) return;
    if (domain_.curves[star_[star_start_[v.value]].curve].has_rings) return;
    const Point p = domain_.vertices[v].at;
    const CurvePiece& other = domain_.curves[hit.curve].piece;
    const double at = project(other, p);
    const Point q = point_at(other, at);
    const DirectedCurve out = sector(v, q - p);
    const CellId cell = cell_on(domain_.curves[out.curve], !out.reversed);
    if (!cell.valid() || domain_.cells[cell].rings > 0) return;
    const double base = domain_.cells[cell].size;
    for (std::uint32_t k = star_start_[v.value]; k < star_start_[v.value + 1]; ++k)
      if (share_vertex(domain_.curves[star_[k].curve], domain_.curves[hit.curve])) return;
    const double start = out.reversed ? length(domain_.curves[out.curve].piece) : 0;
    if (walks_.is_wedge(out.curve, !out.reversed, start, hit.curve, is_left_of(other, at, p), at, base)) return;
    add_gap_sources(p, q, hit.distance, base);
  }

  void look_around_lone(std::size_t i) {
    const VertexId v = lone_[i].vertex;
    const double base = lone_[i].base;
    const Point p = domain_.vertices[v].at;
    const Hit hit = nearest(v, base / kGapStretch);
    if (hit.curve.valid()) add_gap_sources(p, point_on(hit.curve, p), hit.distance, base);
    points_.query(inflated({p, p}, base / kGapStretch), [&](std::uint32_t other) {
      const Point q = domain_.vertices[lone_[other].vertex].at;
      if (other > i) add_gap_sources(p, q, distance(p, q), base);
    });
  }

  Point point_on(CurveId c, Point p) const {
    const CurvePiece& piece = domain_.curves[c].piece;
    return point_at(piece, project(piece, p));
  }

  void add_gap_sources(Point p, Point q, double gap, double base) {
    const double size = gap_size(gap, base);
    if (size >= base) return;
    sources_.push_back({p, p, size});
    sources_.push_back({q, q, size});
  }

  const Domain& domain_;
  const IdVector<CurveId, double>& sizes_;
  std::vector<SizeSource>& sources_;
  WalkPlaces walks_;
  BoxTree tree_;  ///< of the curves
  std::vector<LonePoint> lone_;
  BoxTree points_;  ///< of `lone_`
  std::vector<std::uint32_t> star_start_;
  std::vector<DirectedCurve> star_;  ///< curves leaving each vertex
};

}  // namespace

void append_gaps(const Domain& domain, const IdVector<CurveId, double>& sizes, std::vector<SizeSource>& sources) {
  if (domain.curves.count() > 0) GapFinder(domain, sizes, sources).find();
}

}  // namespace quadline
