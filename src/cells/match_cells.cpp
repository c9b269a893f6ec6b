// Congruent cells: the outer walks are laid over each other wherever their numbers of edges agree, as strings are
// sought in each other; two walks that lie over each other give the motion, and all else must follow it.
#include "cells/match_cells.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <utility>

#include "search/place_index.hpp"

namespace quadline {

namespace {

constexpr double kSamePlace = 0.01, kSameSize = 0.02;  // in sizes; relative
constexpr std::size_t kMostTries = 16;                 // of a regular polygon all are alike

using Walk = std::vector<DirectedCurve>;

Point start_of(const Domain& domain, const DirectedCurve& d) {
  const CurvePiece& piece = domain.curves[d.curve].piece;
  return d.reversed ? piece.b : piece.a;
}
VertexId tail_of(const Domain& domain, const DirectedCurve& d) {
  const Domain::Curve& curve = domain.curves[d.curve];
  return d.reversed ? curve.head : curve.tail;
}
Point middle_of(const Domain& domain, CurveId c) {
  const CurvePiece& piece = domain.curves[c].piece;
  return point_at(piece, 0.5 * length(piece));
}

// Number of edges of a curve of a walk, and which way it bends; a mirror image walked backwards bends the same way.
std::uint32_t code(const Domain& domain, const CurveNodes& nodes, const DirectedCurve& d) {
  const double sweep = domain.curves[d.curve].piece.sweep;
  const bool is_left = (sweep > 0) != d.reversed;
  return 3 * static_cast<std::uint32_t>(nodes.on(d.curve).size()) + (sweep == 0 ? 0 : is_left ? 1 : 2);
}

std::vector<std::uint32_t> codes(const Domain& domain, const CurveNodes& nodes, const Walk& walk) {
  std::vector<std::uint32_t> all;
  for (const DirectedCurve& d : walk) all.push_back(code(domain, nodes, d));
  return all;
}

// Where `word` stands in the ring `ring` of the same length.
std::vector<std::size_t> places_in_ring(const std::vector<std::uint32_t>& word,
                                        const std::vector<std::uint32_t>& ring) {
  const std::size_t n = word.size();
  std::vector<std::size_t> border(n + 1, 0), found;  // of each beginning: its longest proper beginning that is its end
  for (std::size_t i = 1, k = 0; i < n; ++i) {
    while (k > 0 && word[i] != word[k]) k = border[k];
    if (word[i] == word[k]) ++k;
    border[i + 1] = k;
  }
  for (std::size_t i = 0, k = 0; i + 1 < 2 * n; ++i) {
    while (k > 0 && (k == n || ring[i % n] != word[k])) k = border[k];
    if (ring[i % n] == word[k]) ++k;
    if (k == n) found.push_back(i + 1 - n);
  }
  return found;
}

// The turn, and shift, that lays points over others best, once mirrored where asked.
Isometry best_move(std::span<const Point> from, std::span<const Point> to, bool is_mirrored) {
  const double share = 1 / static_cast<double>(from.size());
  Isometry move{.is_mirrored = is_mirrored};
  for (const Point p : from) move.from += share * (p - from[0]);
  for (const Point p : to) move.to += share * (p - to[0]);
  move.from += from[0];
  move.to += to[0];
  double along = 0, across = 0;
  for (std::size_t i = 0; i < from.size(); ++i) {
    Point u = from[i] - move.from;
    const Point v = to[i] - move.to;
    if (is_mirrored) u.x = -u.x;
    along += dot(u, v);
    across += cross(u, v);
  }
  const double whole = norm({along, across});
  if (whole > 0) move.cos = along / whole, move.sin = across / whole;
  return move;
}

}  // namespace

void sort_maps(CellCopy& copy) {
  const auto tidy = [](auto& map) {
    std::sort(map.begin(), map.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    map.erase(std::unique(map.begin(), map.end(), [](const auto& a, const auto& b) { return a.first == b.first; }),
              map.end());
  };
  tidy(copy.vertices);
  tidy(copy.curves);
}

std::vector<std::uint32_t> kind_of(const Domain& domain, const CurveNodes& nodes, CellId c) {
  const Domain::Cell& cell = domain.cells[c];
  std::vector<std::uint32_t> kind = codes(domain, nodes, cell.walks[0]);
  std::sort(kind.begin(), kind.end());
  kind.push_back(static_cast<std::uint32_t>(cell.walks.size()));
  kind.push_back(static_cast<std::uint32_t>(nodes.count(c)));
  kind.push_back(static_cast<std::uint32_t>(cell.lone_points.size()));
  return kind;
}

/// Curve i of the original's outer walk lies on curve `start` + i of the copy's; mirrored: on `start` - i, backwards.
struct CellMatcher::Alignment {
  std::size_t start;
  bool is_mirrored;
};

bool CellMatcher::fits_node(const Isometry& move, NodeId from, NodeId to) const {
  const WorkMesh& all = nodes_.all();
  const double size = size_.at(all.point(to));
  return distance(move(all.point(from)), all.point(to)) <= kSamePlace * size &&
         std::abs(size_.at(all.point(from)) - size) <= kSameSize * size;
}

bool CellMatcher::fits_curve(const Isometry& move, CurveId from, DirectedCurve to) const {
  const std::span<const NodeId> a = nodes_.on(from), b = nodes_.on(to.curve);
  if (a.size() != b.size()) return false;
  for (std::size_t k = 0; k < a.size(); ++k)
    if (!fits_node(move, a[k], b[to.reversed ? b.size() - 1 - k : k])) return false;
  return true;
}

bool CellMatcher::fits(const CellCopy& copy) const {
  if (std::abs(domain_.cells[copy.original].size - domain_.cells[copy.copy].size) >
      kSameSize * domain_.cells[copy.copy].size)
    return false;
  return std::all_of(
             copy.vertices.begin(), copy.vertices.end(),
             [&](const auto& v) { return fits_node(copy.move, NodeId(v.first.value), NodeId(v.second.value)); }) &&
         std::all_of(copy.curves.begin(), copy.curves.end(),
                     [&](const auto& c) { return fits_curve(copy.move, c.first, c.second); });
}

// Curves of the inner walks by their middles, then all vertices.
bool CellMatcher::map_inside(CellCopy& copy) const {
  const Domain::Cell &from = domain_.cells[copy.original], &to = domain_.cells[copy.copy];
  std::vector<CurveId> curves;
  std::vector<Point> middles, lone;
  for_each_curve(to, [&](DirectedCurve d) {
    curves.push_back(d.curve);
    middles.push_back(middle_of(domain_, d.curve));
  });
  for (const VertexId v : to.lone_points) lone.push_back(domain_.vertices[v].at);
  const double near = kSamePlace * size_.at(middles[0]);
  const PlaceIndex curve_at(middles, near), lone_at(lone, near);
  bool is_found = true;
  const auto map_curve = [&](DirectedCurve d) {
    const std::size_t k = curve_at.find(copy.move(middle_of(domain_, d.curve)));
    if (k == PlaceIndex::kNone) return void(is_found = false);
    const CurvePiece &piece = domain_.curves[d.curve].piece, &image = domain_.curves[curves[k]].piece;
    const Point tail = copy.move(piece.a);
    copy.curves.emplace_back(d.curve, DirectedCurve{curves[k], distance(tail, image.b) < distance(tail, image.a)});
  };
  for (std::size_t w = 1; w < from.walks.size(); ++w)
    for (const DirectedCurve& d : from.walks[w]) map_curve(d);
  for (const VertexId v : from.lone_points) {
    const std::size_t k = lone_at.find(copy.move(domain_.vertices[v].at));
    if (k == PlaceIndex::kNone) return false;
    copy.vertices.emplace_back(v, to.lone_points[k]);
  }
  for (const auto& [curve, image] : copy.curves) {
    const Domain::Curve& a = domain_.curves[curve];
    copy.vertices.emplace_back(a.tail, tail_of(domain_, image));
    copy.vertices.emplace_back(a.head, tail_of(domain_, {image.curve, !image.reversed}));
  }
  return is_found;
}

std::optional<CellCopy> CellMatcher::try_alignment(CellId original, CellId copy, const Alignment& alignment) const {
  const Walk &from = domain_.cells[original].walks[0], &to = domain_.cells[copy].walks[0];
  std::vector<Point> a, b;
  CellCopy found{original, copy, {}, {}, {}};
  for (std::size_t i = 0; i < from.size(); ++i) {
    const std::size_t n = from.size(), k = alignment.start + (alignment.is_mirrored ? n - i : i);
    DirectedCurve image = to[k % n];
    if (alignment.is_mirrored) image.reversed = !image.reversed;
    a.push_back(start_of(domain_, from[i]));
    a.push_back(middle_of(domain_, from[i].curve));
    b.push_back(start_of(domain_, image));
    b.push_back(middle_of(domain_, image.curve));
    found.curves.emplace_back(from[i].curve, DirectedCurve{image.curve, image.reversed != from[i].reversed});
  }
  found.move = best_move(a, b, alignment.is_mirrored);
  for (std::size_t i = 0; i < a.size(); ++i)
    if (distance(found.move(a[i]), b[i]) > kSamePlace * size_.at(b[i])) return std::nullopt;
  if (!map_inside(found)) return std::nullopt;
  sort_maps(found);
  if (!fits(found)) return std::nullopt;
  return found;
}

std::optional<CellCopy> CellMatcher::find(CellId original, CellId copy) const {
  const std::vector<std::uint32_t> word = codes(domain_, nodes_, domain_.cells[original].walks[0]);
  std::vector<std::uint32_t> ring = codes(domain_, nodes_, domain_.cells[copy].walks[0]);
  std::optional<CellCopy> best;
  for (const bool is_mirrored : {false, true}) {
    if (is_mirrored) std::reverse(ring.begin(), ring.end());
    const std::vector<std::size_t> places = places_in_ring(word, ring);
    for (std::size_t k = 0; k < std::min(places.size(), kMostTries); ++k) {
      const std::size_t start = is_mirrored ? ring.size() - 1 - places[k] : places[k];
      std::optional<CellCopy> next = try_alignment(original, copy, {start, is_mirrored});
      if (next && (!best || next->move.cos > best->move.cos)) best = std::move(next);
    }
    if (best) return best;
  }
  return best;
}

}  // namespace quadline
