// Last step of `arrange`: what lies inside, with names and sizes.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "base/constants.hpp"
#include "domain/arrange/unique_names.hpp"
#include "domain/arrange/work.hpp"
#include "domain/circle_parts.hpp"

namespace quadline::arrangement {

namespace {

constexpr double kOffCircle = 1.0 / 16;  // in tolerances
constexpr double kNearlyClosed = 0.25;   // gap between the ends of an arc, in radii

class Builder {
 public:
  Builder(Work& work, const Subdivision& parts)
      : work_(work), parts_(parts), joints_(find_joints(work, parts)), rays_(work, parts.component_of) {}

  Domain run() {
    out_.size = work_.size;
    out_.tolerance = work_.tolerance;
    add_cells();
    add_curves();
    add_walks();
    add_paths();
    add_washers();
    add_points();
    name_regions();
    name_rings();
    add_box();
    out_.findings = std::move(work_.findings);
    return std::move(out_);
  }

 private:
  void find(const std::string& text, const std::string& place, Point at) {
    work_.findings.push_back({text, place, at});
  }

  void lose(const std::string& text, const std::string& place, Point at) {
    work_.findings.push_back({text, place, at, true});
  }

  void add_cells() {
    cell_of_.assign(parts_.faces.size(), CellId());
    for (std::size_t f = 0; f < parts_.faces.size(); ++f) {
      if (!parts_.faces[f].is_inside()) continue;
      cell_of_[f] = out_.cells.push_back({.walks = {}, .lone_points = {}, .region = 0, .size = work_.size});
    }
  }

  VertexId vertex(VertexId v) {
    if (!vertex_of_[v].valid()) vertex_of_[v] = out_.vertices.push_back({work_.vertices[v].at});
    return vertex_of_[v];
  }

  /// Arcs lie on the circle that the model gives, unless the tolerance moved their ends far off it.
  CurvePiece on_given_circle(const CurvePiece& step, double sweep, Point a, Point b) const {
    if (sweep == 0) return {.a = a, .b = b};
    const CurvePiece arc = sub_piece(step, 0, std::abs(sweep) * step.radius, a, b);
    const bool is_nearly_closed = distance(a, b) < kNearlyClosed * step.radius;
    return is_nearly_closed && std::abs(sweep) > 1 ? arc : moved_to_ends(arc, kOffCircle * work_.tolerance);
  }

  void add_curves() {
    vertex_of_.assign(work_.vertices.count(), VertexId());
    curve_of_.assign(work_.pieces.count(), CurveId());
    for (std::size_t i = 0; i < work_.pieces.count(); ++i) {
      const Piece& first = work_.pieces[CurveId(i)];
      if (!parts_.is_kept(CurveId(i)) || joints_.is_joint[first.tail]) continue;
      double sweep = 0;
      VertexId head;
      for (CurveId piece(i);; piece = joints_.out_of[head]) {
        curve_of_[piece.value] = out_.curves.end_id();
        sweep += work_.pieces[piece].curve.sweep;
        head = work_.pieces[piece].head;
        if (!joints_.is_joint[head]) break;
      }
      if (joints_.moved.count(first.tail) || joints_.moved.count(head)) sweep = std::copysign(std::numbers::pi, sweep);
      Domain::Curve curve{.tail = vertex(first.tail), .head = vertex(head)};
      const Point a = work_.vertices[first.tail].at, b = work_.vertices[head].at;
      curve.piece = on_given_circle(work_.steps[first.origin], sweep, a, b);
      curve.left = cell_of_[parts_.face_at(static_cast<Half>(2 * i))];
      curve.right = cell_of_[parts_.face_at(static_cast<Half>(2 * i + 1))];
      curve.size = kInfinity;
      for (const std::uint32_t r : joints_.routes[CurveId(i)]) curve.size = std::min(curve.size, work_.routes[r].size);
      out_.curves.push_back(curve);
    }
  }

  /// Appends a piece's curve, unless the piece goes on along the curve before.
  void append(std::vector<DirectedCurve>& chain, CurveId piece, bool reversed) const {
    const CurveId curve = curve_of_[piece.value];
    const bool goes_on = !chain.empty() && chain.back().curve == curve && chain.back().reversed == reversed;
    if (!goes_on) chain.push_back({curve, reversed});
  }

  /// A closed chain may have started in the middle of a curve.
  static void close(std::vector<DirectedCurve>& chain) {
    const bool is_cut = chain.size() > 1 && chain.front().curve == chain.back().curve &&
                        chain.front().reversed == chain.back().reversed;
    if (is_cut) chain.pop_back();
  }

  void add_walks() {
    for (std::size_t f = 0; f < parts_.faces.size(); ++f) {
      if (!cell_of_[f].valid()) continue;
      for (const std::uint32_t walk : parts_.faces[f].walks) {
        std::vector<DirectedCurve> chain;
        for (const Half half : parts_.walks[walk]) append(chain, piece_of(half), is_reversed(half));
        close(chain);
        out_.cells[cell_of_[f]].walks.push_back(std::move(chain));
      }
    }
  }

  /// The circles round rings are none of the model.
  std::uint32_t n_paths() const {
    const Model& model = work_.model;
    return static_cast<std::uint32_t>(model.outer.size() + model.holes.size() + model.lines.size());
  }

  void add_paths() {
    std::set<std::pair<std::uint32_t, std::uint32_t>> shared;
    for (std::uint32_t r = 0; r < n_paths(); ++r) {
      const Route& route = work_.routes[r];
      Domain::Path path{.name = route.name, .kind = route.kind, .curves = {}, .where = route.where};
      std::set<CurveId> used;
      bool is_outside = false, is_repeated = false;
      Point left_at, repeated_at;  // where the route crosses the boundary first; its start where it does not
      for (const DirectedCurve& use : route.uses) {
        const Piece& piece = work_.pieces[use.curve];
        const Point start = work_.vertices[use.reversed ? piece.head : piece.tail].at;
        if (is_outside && path.curves.empty() && parts_.is_kept(use.curve)) left_at = start;
        if (!parts_.is_kept(use.curve)) {
          if (!is_outside) left_at = start;
          is_outside = true;
        } else if (!used.insert(use.curve).second) {
          if (!is_repeated) repeated_at = piece.curve.a;
          is_repeated = true;
        } else {
          append(path.curves, use.curve, use.reversed);
          report_shared(r, use.curve, shared);
        }
      }
      close(path.curves);
      if (is_repeated) find("'" + route.name + "' runs over itself: taken once", route.where, repeated_at);
      if (is_outside && route.kind == CurveKind::Line) {
        const bool is_gone = path.curves.empty();
        lose("line '" + route.name + (is_gone ? "' lies outside the domain: dropped" : "' leaves the domain: trimmed"),
             route.where, left_at);
      }
      out_.paths.push_back(std::move(path));
    }
  }

  void report_shared(std::uint32_t route, CurveId piece, std::set<std::pair<std::uint32_t, std::uint32_t>>& shared) {
    const std::uint32_t first = joints_.routes[piece][0];
    if (first == route || !shared.insert({first, route}).second) return;
    find("'" + work_.routes[route].name + "' runs along '" + work_.routes[first].name + "': one curve for both",
         work_.routes[route].where, work_.pieces[piece].curve.a);
  }

  /// The curves of a circle, empty where it is not whole in the domain.
  std::vector<DirectedCurve> whole_circle(const Route& route) const {
    std::vector<DirectedCurve> chain;
    for (const DirectedCurve& use : route.uses) {
      if (!parts_.is_kept(use.curve)) return {};
      append(chain, use.curve, use.reversed);
    }
    close(chain);
    return chain;
  }

  void add_washers() {
    for (const Washer& washer : work_.washers) {
      const Route& route = work_.routes[washer.route];
      const std::vector<DirectedCurve> circle = whole_circle(route);
      if (circle.empty()) {
        lose("'" + route.name + "' gets no edges or rings of its own: it does not lie in the domain as a whole",
             route.where, route.start);
        continue;
      }
      if (washer.edges > 0) set_edges(washer, circle);
      if (washer.rings > 0) add_rings(washer);
    }
  }

  void set_edges(const Washer& washer, const std::vector<DirectedCurve>& circle) {
    const Route& route = work_.routes[washer.route];
    if (washer.edges >= circle.size()) return share_edges(out_, circle, washer.edges);
    lose("'" + route.name + "' does not get " + std::to_string(washer.edges) + " edges: it has more corners",
         route.where, route.start);
  }

  void add_rings(const Washer& washer) {
    const std::vector<DirectedCurve> outer = whole_circle(work_.routes[washer.outer]);
    QUADLINE_CHECK(!outer.empty());  // there is room for it
    for (const DirectedCurve& d : outer) out_.curves[d.curve].is_auxiliary = true;
    out_.cells[out_.curves[outer[0].curve].left].rings = washer.rings;
    if (washer.edges >= outer.size()) share_edges(out_, outer, washer.edges);
  }

  std::uint32_t face_at(Point p) const {
    RayCaster::Hit hit;
    for (unsigned k = 0; k < RayCaster::kDirections; ++k) {
      hit = rays_.cast(p, k);
      if (hit.is_clear) break;
    }
    return hit.half == kNoHalf ? 0 : parts_.face_at(hit.half);
  }

  void add_points() {
    std::vector<bool> has_piece(work_.vertices.count(), false);
    for (const Piece& piece : work_.pieces) has_piece[piece.tail.value] = has_piece[piece.head.value] = true;
    IdVector<VertexId, std::uint32_t> first_use(work_.vertices.count(), UINT32_MAX);
    UniqueNames names;
    for (std::uint32_t i = 0; i < work_.model.points.size(); ++i) {
      const NamedPoint& point = work_.model.points[i];
      const std::string given = point.name.empty() ? "point-" + std::to_string(i + 1) : point.name;
      const VertexId v = work_.point_vertex[i];
      const bool is_on_curve = vertex_of_[v].valid();
      if (!is_on_curve && first_use[v] == UINT32_MAX) {
        const CellId cell = has_piece[v.value] ? CellId() : cell_of_[face_at(work_.vertices[v].at)];
        if (!cell.valid()) {
          lose("point '" + given + "' lies outside the domain: dropped", point.where, point.at);
          continue;
        }
        out_.cells[cell].lone_points.push_back(vertex(v));
      }
      const std::string name = names.take(given);
      if (name != given) {
        find("the name '" + given + "' is given twice: the second is called '" + name + "'", point.where, point.at);
      }
      if (first_use[v] != UINT32_MAX) {
        find("points '" + work_.model.points[first_use[v]].name + "' and '" + name + "' are one", point.where,
             point.at);
      }
      first_use[v] = i;
      out_.points.push_back({.name = name, .vertex = vertex(v), .size = point.size.value_or(kInfinity)});
    }
  }

  /// Rings belong to the cell around them.
  CellId around_rings(CellId cell) const {
    while (cell.valid() && out_.cells[cell].rings > 0) cell = out_.curves[out_.cells[cell].walks[0][0].curve].right;
    return cell;
  }

  void name_rings() {
    for (std::size_t i = 0; i < out_.cells.count(); ++i) {
      Domain::Cell& cell = out_.cells[CellId(i)];
      if (cell.rings == 0) continue;
      const Domain::Cell& around = out_.cells[around_rings(CellId(i))];
      cell.region = around.region;
      cell.size = around.size;
    }
  }

  void name_regions() {
    out_.regions = {"domain"};
    std::vector<const Region*> holder(out_.cells.count(), nullptr);
    for (const Region& region : work_.model.regions) {
      const CellId cell = around_rings(cell_of_[face_at(region.at)]);
      if (!cell.valid()) {
        lose("region '" + region.name + "' lies outside the domain: ignored", region.where, region.at);
        continue;
      }
      if (const Region* first = holder[cell.value]) {
        lose("regions '" + first->name + "' and '" + region.name + "' lie in one cell: the first names it",
             region.where, region.at);
        continue;
      }
      holder[cell.value] = &region;
      const auto known = std::find(out_.regions.begin(), out_.regions.end(), region.name);
      out_.cells[cell].region = static_cast<std::uint32_t>(known - out_.regions.begin());
      if (known == out_.regions.end()) out_.regions.push_back(region.name);
      out_.cells[cell].size = region.size.value_or(work_.size);
    }
  }

  void add_box() {
    out_.box = {{kInfinity, kInfinity}, {-kInfinity, -kInfinity}};
    for (const Domain::Curve& curve : out_.curves) out_.box = join(out_.box, box(curve.piece));
  }

  Work& work_;
  const Subdivision& parts_;
  Joints joints_;
  RayCaster rays_;
  Domain out_;
  std::vector<CellId> cell_of_;    ///< of every face
  std::vector<CurveId> curve_of_;  ///< of every piece
  IdVector<VertexId, VertexId> vertex_of_;
};

}  // namespace

Domain to_domain(Work& work, const Subdivision& parts) { return Builder(work, parts).run(); }

}  // namespace quadline::arrangement
