// Second step of `arrange`: vertices and pieces that are one.
#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "domain/arrange/work.hpp"

namespace quadline::arrangement {

namespace {

constexpr double kSquare = 8;  // width of a square, in tolerances

/// Finds vertices by place, through squares so wide that a place is mostly near one only, and so narrow that they hold
/// few vertices that are farther than the tolerance from each other.
class VertexGrid {
 public:
  explicit VertexGrid(const Work& work) : work_(work), width_(kSquare * work.tolerance) {
    first_.reserve(work.vertices.count());
    next_.assign(work.vertices.count(), VertexId());
  }

  /// The nearest vertex within the tolerance of p, invalid if there is none.
  VertexId find(Point p) const {
    VertexId best;
    double best_distance = work_.tolerance;
    const Point reach{work_.tolerance, work_.tolerance};
    const Square lo = square(p - reach), hi = square(p + reach);
    // The two corners lie in one square or in neighbours.
    find_in(lo, p, best, best_distance);
    if (lo.x != hi.x) find_in({hi.x, lo.y}, p, best, best_distance);
    if (lo.y != hi.y) find_in({lo.x, hi.y}, p, best, best_distance);
    if (lo.x != hi.x && lo.y != hi.y) find_in(hi, p, best, best_distance);
    return best;
  }

  void add(VertexId v) {
    const auto [it, is_new] = first_.emplace(square(work_.vertices[v].at), v);
    if (is_new) return;
    next_[v] = it->second;
    it->second = v;
  }

 private:
  struct Square {
    double x, y;
    bool operator==(const Square&) const = default;
  };
  struct Hash {
    std::size_t operator()(const Square& s) const {
      const std::uint64_t both = std::hash<double>()(s.x) * std::uint64_t{31} + std::hash<double>()(s.y);
      return static_cast<std::size_t>(both * 0x9e3779b97f4a7c15u >> 20);
    }
  };
  Square square(Point p) const { return {std::floor(p.x / width_), std::floor(p.y / width_)}; }

  void find_in(const Square& square, Point p, VertexId& best, double& best_distance) const {
    const auto it = first_.find(square);
    if (it == first_.end()) return;
    for (VertexId v = it->second; v.valid(); v = next_[v]) {
      const double d = distance(work_.vertices[v].at, p);
      if (d < best_distance || (d == best_distance && (!best.valid() || v < best))) best = v, best_distance = d;
    }
  }

  const Work& work_;
  double width_;
  std::unordered_map<Square, VertexId, Hash> first_;
  IdVector<VertexId, VertexId> next_;
};

class Merger {
 public:
  explicit Merger(Work& work) : work_(work) {}

  void run(bool report) {
    merge_vertices();
    drop_short(report);
    drop_repeated();
  }

 private:
  /// Merges vertices within the tolerance of each other, the better ranked and earlier first.
  void merge_vertices() {
    std::vector<VertexId> order;
    for (std::size_t i = 0; i < work_.vertices.count(); ++i) order.push_back(VertexId(i));
    std::stable_sort(order.begin(), order.end(),
                     [this](VertexId a, VertexId b) { return work_.vertices[a].rank < work_.vertices[b].rank; });
    IdVector<VertexId, VertexId> stays(work_.vertices.count());
    VertexGrid grid(work_);
    for (const VertexId v : order) {
      const VertexId near = grid.find(work_.vertices[v].at);
      stays[v] = near.valid() ? near : v;
      if (near.valid()) report_joined(v, near);
      if (!near.valid()) grid.add(v);
    }
    IdVector<VertexId, VertexId> renumbered(work_.vertices.count());
    IdVector<VertexId, Vertex> kept;
    for (std::size_t i = 0; i < stays.count(); ++i) {
      if (stays[VertexId(i)] == VertexId(i)) renumbered[VertexId(i)] = kept.push_back(work_.vertices[VertexId(i)]);
    }
    work_.vertices = std::move(kept);
    for (VertexId& v : work_.point_vertex) v = renumbered[stays[v]];
    for (Piece& piece : work_.pieces) {
      piece.tail = renumbered[stays[piece.tail]];
      piece.head = renumbered[stays[piece.head]];
      const Point a = work_.vertices[piece.tail].at;
      const Point b = work_.vertices[piece.head].at;
      if (a == piece.curve.a && b == piece.curve.b) continue;
      if (piece.tail != piece.head) piece.curve = cut_curve(work_, piece.curve, 0, length(piece.curve), a, b);
      piece.checked_near = piece.checked_across = false;
    }
  }

  void report_joined(VertexId v, VertexId near) {
    const Rank rank = work_.vertices[v].rank;
    if (rank == Rank::Crossing) return;
    const Point at = work_.vertices[near].at;
    const char* what = rank == Rank::Helper ? "a point and a curve are joined" : "two points are one";
    work_.report_joined(what, distance(work_.vertices[v].at, at), at);
  }

  /// Pieces whose ends have become one are shorter than the tolerance.
  void drop_short(bool report) {
    std::vector<DirectedCurve> becomes(work_.pieces.count());
    for (std::size_t i = 0; i < becomes.size(); ++i) {
      const Piece& piece = work_.pieces[CurveId(i)];
      if (piece.tail != piece.head) becomes[i] = {.curve = CurveId(i)};
    }
    if (report) report_short(becomes);
    keep(becomes);
  }

  void report_short(const std::vector<DirectedCurve>& becomes) {
    for (const Route& route : work_.routes) {
      std::size_t dropped = 0;
      Point at;
      for (const DirectedCurve& use : route.uses) {
        if (becomes[use.curve.value].curve.valid()) continue;
        if (dropped++ == 0) at = work_.pieces[use.curve].curve.a;
      }
      if (dropped == route.uses.size()) {
        work_.findings.push_back({"'" + route.name + "' has no length: dropped", route.where, at, true});
      } else if (dropped > 0) {
        const std::string what = std::to_string(dropped) + (dropped == 1 ? " repeated point" : " repeated points");
        work_.findings.push_back({"'" + route.name + "' has " + what + ": dropped", route.where, at});
      }
    }
  }

  /// Of pieces with the same ends that touch all along the first stays.
  void drop_repeated() {
    std::vector<DirectedCurve> becomes(work_.pieces.count());
    std::vector<CurveId> order;
    for (std::size_t i = 0; i < becomes.size(); ++i) {
      becomes[i] = {.curve = CurveId(i)};
      order.push_back(CurveId(i));
    }
    const auto ends = [this](CurveId id) {
      const Piece& piece = work_.pieces[id];
      return std::minmax(piece.tail, piece.head, std::less<VertexId>());
    };
    std::sort(order.begin(), order.end(), [&](CurveId a, CurveId b) {
      const auto u = ends(a), v = ends(b);
      return u != v ? u < v : a < b;
    });
    for (std::size_t first = 0, i = 0; i < order.size(); ++i) {
      if (ends(order[i]) != ends(order[first])) first = i;
      for (std::size_t j = first; j < i; ++j) {
        if (becomes[order[j].value].curve != order[j] || !is_same_curve(order[j], order[i])) continue;
        becomes[order[i].value] = {order[j], work_.pieces[order[j]].tail != work_.pieces[order[i]].tail};
        break;
      }
    }
    keep(becomes);
  }

  bool is_same_curve(CurveId a, CurveId b) const {
    const CurvePiece& p = work_.pieces[a].curve;
    const CurvePiece& q = work_.pieces[b].curve;
    return distance(point_at(p, 0.5 * length(p)), point_at(q, 0.5 * length(q))) <= kTouch * work_.tolerance;
  }

  /// Renumbers the pieces; `becomes` tells for each the one that takes its place (itself: it stays; invalid: none).
  void keep(const std::vector<DirectedCurve>& becomes) {
    IdVector<CurveId, Piece> kept;
    std::vector<CurveId> renumbered(becomes.size());
    for (std::size_t i = 0; i < becomes.size(); ++i) {
      if (becomes[i].curve == CurveId(i)) renumbered[i] = kept.push_back(work_.pieces[CurveId(i)]);
    }
    if (kept.count() == work_.pieces.count()) return;
    work_.pieces = std::move(kept);
    for (Route& route : work_.routes) {
      std::vector<DirectedCurve> uses;
      for (const DirectedCurve& use : route.uses) {
        const DirectedCurve& now = becomes[use.curve.value];
        if (now.curve.valid()) uses.push_back({renumbered[now.curve.value], use.reversed != now.reversed});
      }
      route.uses = std::move(uses);
    }
  }

  Work& work_;
};

}  // namespace

void merge(Work& work, bool report) { Merger(work).run(report); }

}  // namespace quadline::arrangement
