#include "domain/symmetry/symmetries.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "base/constants.hpp"
#include "domain/whole_circle.hpp"
#include "search/place_index.hpp"

namespace quadline {

namespace {

// Mirror images in the axes and the half turn come first: what can be copied by these is.
struct SquareMove {
  Point turn;
  bool is_mirrored;
};
constexpr std::array<SquareMove, 7> kSquareMoves{{{{1, 0}, true},
                                                  {{-1, 0}, true},
                                                  {{-1, 0}, false},
                                                  {{0, 1}, false},
                                                  {{0, -1}, false},
                                                  {{0, 1}, true},
                                                  {{0, -1}, true}}};

constexpr double kSameSize = 1e-9;  // relative

bool is_same(double a, double b) { return a == b || std::abs(a - b) <= kSameSize * std::min(a, b); }

std::vector<Point> vertex_places(const Domain& domain) {
  std::vector<Point> places;
  for (const Domain::Vertex& vertex : domain.vertices) places.push_back(vertex.at);
  return places;
}

// The two arcs of a whole circle.
struct Circle {
  CurveId first, second;
};

std::vector<Circle> circles_of(const Domain& domain) {
  const WholeCircles whole(domain);
  std::vector<Circle> circles;
  IdVector<CurveId, bool> is_seen(domain.curves.count(), false);
  for (const Domain::Cell& cell : domain.cells)
    for (const auto& walk : cell.walks) {
      if (!whole.find(domain, walk) || is_seen[walk[0].curve]) continue;
      for (const DirectedCurve& d : walk) is_seen[d.curve] = true;
      circles.push_back({walk[0].curve, walk[1].curve});
    }
  return circles;
}

// A circle as a point, whatever its arcs: the same for all that have its centre and radius.
Point place_of(const Domain& domain, const Circle& circle, const Isometry& move) {
  const CurvePiece& piece = domain.curves[circle.first].piece;
  return move(piece.center) + Point{piece.radius, 0};
}

std::vector<Point> circle_places(const Domain& domain, const std::vector<Circle>& circles) {
  std::vector<Point> places;
  for (const Circle& circle : circles) places.push_back(place_of(domain, circle, {}));
  return places;
}

std::vector<Point> curve_middles(const Domain& domain) {
  std::vector<Point> places;
  for (const Domain::Curve& curve : domain.curves) places.push_back(point_at(curve.piece, 0.5 * length(curve.piece)));
  return places;
}

class Finder {
 public:
  explicit Finder(const Domain& domain)
      : domain_(domain),
        vertices_(vertex_places(domain)),
        middles_(curve_middles(domain)),
        circles_(circles_of(domain)),
        circle_places_(circle_places(domain, circles_)),
        vertex_at_(vertices_, 2 * domain.tolerance),
        curve_at_(middles_, 2 * domain.tolerance),
        circle_at_(circle_places_, 2 * domain.tolerance),
        is_on_circle_(domain.curves.count(), false),
        is_seam_(domain.vertices.count(), false),
        point_size_(domain.vertices.count(), kInfinity),
        lone_in_(domain.vertices.count()) {
    for (const Circle& circle : circles_) {
      is_on_circle_[circle.first] = is_on_circle_[circle.second] = true;
      is_seam_[domain.curves[circle.first].tail] = is_seam_[domain.curves[circle.first].head] = true;
    }
    for (const Domain::PointUse& point : domain.points)
      point_size_[point.vertex] = std::min(point_size_[point.vertex], point.size);
    for (std::size_t i = 0; i < domain.cells.count(); ++i)
      for (const VertexId v : domain.cells[CellId(i)].lone_points) lone_in_[v] = CellId(i);
  }

  std::optional<Symmetry> try_move(const Isometry& move) const {
    Symmetry found{move, IdVector<VertexId, VertexId>(vertices_.size()),
                   IdVector<CurveId, DirectedCurve>(middles_.size()), IdVector<CellId, CellId>(domain_.cells.count()),
                   is_on_circle_};
    if (!map_vertices(found) || !map_circles(found) || !map_curves(found) || !map_cells(found)) return std::nullopt;
    return found;
  }

 private:
  bool map_vertices(Symmetry& found) const {
    IdVector<VertexId, bool> is_taken(vertices_.size(), false);
    for (std::size_t i = 0; i < vertices_.size(); ++i) {
      if (is_seam_[VertexId(i)]) continue;
      const std::size_t image = vertex_at_.find(found.move(vertices_[i]));
      if (image == PlaceIndex::kNone || is_taken[VertexId(image)] || is_seam_[VertexId(image)]) return false;
      is_taken[VertexId(image)] = true;
      if (!is_same(point_size_[VertexId(i)], point_size_[VertexId(image)])) return false;
      found.vertices[VertexId(i)] = VertexId(image);
    }
    return true;
  }

  // Arc to arc, the nearer one, and in the right direction.
  bool map_circles(Symmetry& found) const {
    for (const Circle& circle : circles_) {
      const std::size_t image = circle_at_.find(place_of(domain_, circle, found.move));
      if (image == PlaceIndex::kNone) return false;
      Circle to = circles_[image];
      const Point middle = found.move(middles_[circle.first.value]);
      if (distance(middle, middles_[to.second.value]) < distance(middle, middles_[to.first.value]))
        std::swap(to.first, to.second);
      for (const auto& [a, b] : {std::pair(circle.first, to.first), std::pair(circle.second, to.second)}) {
        const Domain::Curve &from = domain_.curves[a], &into = domain_.curves[b];
        if (!is_same(from.size, into.size) || from.edges != into.edges) return false;
        const bool is_back =
            (from.piece.sweep > 0) == (into.piece.sweep > 0) ? found.move.is_mirrored : !found.move.is_mirrored;
        found.curves[a] = {b, is_back};
        found.vertices[from.tail] = is_back ? into.head : into.tail;
        found.vertices[from.head] = is_back ? into.tail : into.head;
      }
    }
    return true;
  }

  bool map_curves(Symmetry& found) const {
    for (std::size_t i = 0; i < middles_.size(); ++i) {
      if (is_on_circle_[CurveId(i)]) continue;
      const std::size_t image = curve_at_.find(found.move(middles_[i]));
      if (image == PlaceIndex::kNone) return false;
      const Domain::Curve &from = domain_.curves[CurveId(i)], &to = domain_.curves[CurveId(image)];
      const VertexId tail = found.vertices[from.tail], head = found.vertices[from.head];
      const bool is_along = tail == to.tail && head == to.head, is_back = tail == to.head && head == to.tail;
      if (!(is_along || is_back) || !is_same(from.size, to.size) || from.edges != to.edges) return false;
      found.curves[CurveId(i)] = {CurveId(image), is_back};
    }
    return true;
  }

  // What is on the left of a curve comes to lie on the left of its image, unless one of the two is turned round.
  bool map_cells(Symmetry& found) const {
    for (std::size_t i = 0; i < domain_.curves.count(); ++i) {
      const Domain::Curve& from = domain_.curves[CurveId(i)];
      const DirectedCurve image = found.curves[CurveId(i)];
      CellId left = domain_.curves[image.curve].left, right = domain_.curves[image.curve].right;
      if (image.reversed != found.move.is_mirrored) std::swap(left, right);
      if (!map_cell(found, from.left, left) || !map_cell(found, from.right, right)) return false;
    }
    for (std::size_t i = 0; i < domain_.vertices.count(); ++i) {
      const VertexId v(i);
      const CellId to = lone_in_[found.vertices[v]];
      if (lone_in_[v].valid() ? found.cells[lone_in_[v]] != to : to.valid()) return false;
    }
    return true;
  }

  bool map_cell(Symmetry& found, CellId from, CellId to) const {
    if (!from.valid() || !to.valid()) return from == to;
    if (!found.cells[from].valid()) {
      found.cells[from] = to;
      return is_same(domain_.cells[from].size, domain_.cells[to].size) &&
             domain_.cells[from].rings == domain_.cells[to].rings;
    }
    return found.cells[from] == to;
  }

  const Domain& domain_;
  const std::vector<Point> vertices_, middles_;  // of the curves
  const std::vector<Circle> circles_;
  const std::vector<Point> circle_places_;
  const PlaceIndex vertex_at_, curve_at_, circle_at_;
  IdVector<CurveId, bool> is_on_circle_;
  IdVector<VertexId, bool> is_seam_;
  IdVector<VertexId, double> point_size_;  // infinity: none
  IdVector<VertexId, CellId> lone_in_;
};

}  // namespace

std::vector<std::vector<std::size_t>> subgroups_of(const std::vector<Symmetry>& symmetries) {
  // Places in kSquareMoves.
  const std::vector<std::vector<std::size_t>> subgroups{
      {0, 1, 2, 3, 4, 5, 6}, {0, 1, 2}, {2, 3, 4}, {2, 5, 6}, {0}, {1}, {2}, {5}, {6}};
  std::array<std::size_t, kSquareMoves.size()> place{};
  place.fill(symmetries.size());
  for (std::size_t i = 0; i < symmetries.size(); ++i) {
    const Isometry& move = symmetries[i].move;
    for (std::size_t k = 0; k < kSquareMoves.size(); ++k)
      if (kSquareMoves[k].turn == Point{move.cos, move.sin} && kSquareMoves[k].is_mirrored == move.is_mirrored)
        place[k] = i;
  }
  std::vector<std::vector<std::size_t>> found;
  for (std::vector<std::size_t> subgroup : subgroups) {
    for (std::size_t& i : subgroup) i = place[i];
    if (std::find(subgroup.begin(), subgroup.end(), symmetries.size()) == subgroup.end()) found.push_back(subgroup);
  }
  return found;
}

std::vector<Symmetry> find_symmetries(const Domain& domain) {
  const Finder finder(domain);
  const Point centre = midpoint(domain.box.lo, domain.box.hi);
  std::vector<Symmetry> found;
  for (const SquareMove& move : kSquareMoves) {
    std::optional<Symmetry> symmetry = finder.try_move({centre, centre, move.turn.x, move.turn.y, move.is_mirrored});
    if (symmetry) found.push_back(std::move(*symmetry));
  }
  return found;
}

}  // namespace quadline
