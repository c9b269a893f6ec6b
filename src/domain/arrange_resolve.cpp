// Second step of `arrange`: rounds of merging and cutting until the pieces meet at shared vertices only.
//
// In the manner of snap rounding [Hobby1999], but with a distance in place of a grid, so that the model's own corners
// stay where they are: vertices end up farther than the tolerance from each other and from every piece that they do not
// end. A crossing is then never near a vertex, a cut never makes a piece shorter than the tolerance, and the rounds come
// to rest.
#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "domain/arrange_work.hpp"
#include "search/box_tree.hpp"

namespace quadline::arrangement {

namespace {

constexpr int kMaxRounds = 64;  // four or five are usual
constexpr double kBoxesPerPiece = 2;
constexpr double kShortArc = 16;          // in tolerances; shorter ones are straight
constexpr double kOffCircle = 0x1p-10;    // in tolerances; nearer ends lie on the circle

/// A vertex on a piece, at arc length s.
struct Cut {
  CurveId piece;
  double s;
  VertexId vertex;
};

/// Finds vertices by place: squares of one tolerance, which hold few vertices that are farther apart than that.
class VertexGrid {
 public:
  VertexGrid(const Work& work, std::size_t n) : work_(work) {
    first_.reserve(n);
    next_.assign(work.vertices.count(), VertexId());
  }

  /// The nearest vertex within the tolerance of p, invalid if there is none.
  VertexId find(Point p) const {
    VertexId best;
    double best_distance = work_.tolerance;
    const Square at = square(p);
    for (int dx = -1; dx <= 1; ++dx) {
      for (int dy = -1; dy <= 1; ++dy) {
        const auto it = first_.find({at.x + dx, at.y + dy});
        if (it == first_.end()) continue;
        for (VertexId v = it->second; v.valid(); v = next_[v]) {
          const double d = distance(work_.vertices[v].at, p);
          if (d < best_distance || (d == best_distance && (!best.valid() || v < best))) best = v, best_distance = d;
        }
      }
    }
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
      return std::hash<double>()(s.x) * 0x9e3779b97f4a7c15u + std::hash<double>()(s.y);
    }
  };
  Square square(Point p) const { return {std::floor(p.x / work_.tolerance), std::floor(p.y / work_.tolerance)}; }

  const Work& work_;
  std::unordered_map<Square, VertexId, Hash> first_;
  IdVector<VertexId, VertexId> next_;
};

/// Boxes of parts of pieces: long pieces are taken in parts, since the box of a long slanted one is mostly empty.
struct Parts {
  std::vector<Box> boxes;
  std::vector<CurveId> piece;
};

/// Turns and scales an arc so that it goes through its ends, if they lie farther than `slack` off its circle. Then what
/// holds for straight pieces holds for arcs: a point of the piece near its end is near no other piece that its end is not.
CurvePiece moved_to_ends(CurvePiece arc, double slack) {
  const Point u = arc.a - arc.center;
  const Point v = arc.b - arc.center;
  if (std::max(std::abs(norm(u) - arc.radius), std::abs(norm(v) - arc.radius)) <= slack) return arc;
  const Point on_a = (arc.radius / norm(u)) * u;
  const Point on_b = (arc.radius / norm(v)) * v;
  const Point was = on_b - on_a;
  const Point is = arc.b - arc.a;
  const Point turn = (1 / norm2(was)) * Point{dot(was, is), cross(was, is)};  // as a complex number
  arc.center = arc.a - Point{turn.x * on_a.x - turn.y * on_a.y, turn.x * on_a.y + turn.y * on_a.x};
  arc.radius *= norm(turn);
  return arc;
}

class Resolver {
 public:
  Resolver(Work& work, Context& context) : work_(work), context_(context) {}

  void run() {
    for (int round = 0; round < kMaxRounds; ++round) {
      context_.progress("arrange", 0.7 * round / (round + 2.0));
      merge_vertices();
      drop_short(round == 0);
      drop_repeated();
      const Parts parts = cover_pieces();
      const BoxTree tree(parts.boxes);
      std::vector<Cut> cuts = cuts_at_vertices(tree, parts);
      if (cuts.empty()) cuts = cuts_at_crossings(tree, parts);
      if (cuts.empty()) return;
      place_ = work_.vertices[cuts[0].vertex].at;
      apply(cuts);
    }
    throw InputError("curves here cannot be told apart: remove details finer than the tolerance " +
                         std::to_string(work_.tolerance),
                     work_.where("", place_));
  }

 private:
  /// Merges vertices within the tolerance of each other, the better ranked and earlier first.
  void merge_vertices() {
    std::vector<VertexId> order;
    for (std::size_t i = 0; i < work_.vertices.count(); ++i) order.push_back(VertexId(i));
    std::stable_sort(order.begin(), order.end(),
                     [this](VertexId a, VertexId b) { return work_.vertices[a].rank < work_.vertices[b].rank; });
    IdVector<VertexId, VertexId> stays(work_.vertices.count());
    VertexGrid grid(work_, work_.vertices.count());
    for (const VertexId v : order) {
      const VertexId near = grid.find(work_.vertices[v].at);
      stays[v] = near.valid() ? near : v;
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
      if (piece.tail != piece.head) piece.curve = cut_curve(piece.curve, 0, length(piece.curve), a, b);
      piece.checked_near = piece.checked_across = false;
    }
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
        work_.findings.push_back({"'" + route.name + "' has no length: dropped", route.where, at});
      } else if (dropped > 0) {
        const std::string what = std::to_string(dropped) + (dropped == 1 ? " repeated point" : " repeated points");
        work_.findings.push_back({"'" + route.name + "' has " + what + ": dropped", route.where, at});
      }
    }
  }

  /// Of pieces with the same ends that run within the tolerance of each other the first stays.
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
    return distance(point_at(p, 0.5 * length(p)), point_at(q, 0.5 * length(q))) <= work_.tolerance;
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

  Parts cover_pieces() const {
    double total = 0;
    for (const Piece& piece : work_.pieces) total += length(piece.curve);
    const double step = kBoxesPerPiece * total / static_cast<double>(std::max<std::size_t>(1, work_.pieces.count()));
    Parts parts;
    for (std::size_t i = 0; i < work_.pieces.count(); ++i) {
      const CurvePiece& curve = work_.pieces[CurveId(i)].curve;
      const double all = length(curve);
      const double n = std::max(1.0, std::ceil(all / step));
      Point a = curve.a;
      for (double k = 0; k < n; ++k) {
        const double s0 = all * (k / n), s1 = all * ((k + 1) / n);
        const Point b = point_at(curve, s1);
        parts.boxes.push_back(inflated(box(sub_piece(curve, s0, s1, a, b)), work_.tolerance));
        parts.piece.push_back(CurveId(i));
        a = b;
      }
    }
    return parts;
  }

  std::vector<Cut> cuts_at_vertices(const BoxTree& tree, const Parts& parts) {
    std::vector<Cut> cuts;
    for (std::size_t i = 0; i < work_.vertices.count(); ++i) {
      const VertexId v(i);
      Vertex& vertex = work_.vertices[v];
      tree.query({vertex.at, vertex.at}, [&](std::uint32_t part) {
        const CurveId id = parts.piece[part];
        const Piece& piece = work_.pieces[id];
        if ((vertex.checked && piece.checked_near) || piece.tail == v || piece.head == v) return;
        if (distance_to(piece.curve, vertex.at) > work_.tolerance) return;
        cuts.push_back({id, project(piece.curve, vertex.at), v});
      });
      vertex.checked = true;
    }
    for (Piece& piece : work_.pieces) piece.checked_near = true;
    return cuts;
  }

  std::vector<Cut> cuts_at_crossings(const BoxTree& tree, const Parts& parts) {
    std::vector<std::pair<CurveId, CurveId>> pairs;
    for (std::uint32_t part = 0; part < parts.piece.size(); ++part) {
      const CurveId p = parts.piece[part];
      const bool checked = work_.pieces[p].checked_across;
      tree.query(parts.boxes[part], [&](std::uint32_t other) {
        const CurveId q = parts.piece[other];
        if (p < q && !(checked && work_.pieces[q].checked_across) && may_meet(p, q)) pairs.emplace_back(p, q);
      });
    }
    std::sort(pairs.begin(), pairs.end());
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
    std::vector<Cut> cuts;
    for (const auto& [p, q] : pairs) {
      for (const Point at : meetings(work_.pieces[p], work_.pieces[q], work_.tolerance)) {
        const VertexId v = work_.vertices.push_back({.at = at, .rank = Rank::Crossing});
        for (const CurveId id : {p, q}) cuts.push_back({id, project(work_.pieces[id].curve, at), v});
      }
    }
    for (Piece& piece : work_.pieces) piece.checked_across = true;
    return cuts;
  }

  /// Straight pieces with a common end meet nowhere else.
  bool may_meet(CurveId a, CurveId b) const {
    const Piece& p = work_.pieces[a];
    const Piece& q = work_.pieces[b];
    if (p.curve.is_arc() || q.curve.is_arc()) return true;
    return p.tail != q.tail && p.tail != q.head && p.head != q.tail && p.head != q.head;
  }

  void apply(std::vector<Cut>& cuts) {
    std::sort(cuts.begin(), cuts.end(), [](const Cut& a, const Cut& b) {
      if (a.piece != b.piece) return a.piece < b.piece;
      return a.s != b.s ? a.s < b.s : a.vertex < b.vertex;
    });
    std::vector<CurveId> first(work_.pieces.count() + 1);
    IdVector<CurveId, Piece> pieces;
    auto cut = cuts.begin();
    for (std::size_t i = 0; i < work_.pieces.count(); ++i) {
      first[i] = pieces.end_id();
      const Piece& whole = work_.pieces[CurveId(i)];
      Piece part = whole;
      double from = 0;
      for (; cut != cuts.end() && cut->piece == CurveId(i); ++cut) {
        if (cut->vertex == part.tail) continue;  // found in two parts of the piece
        part.head = cut->vertex;
        pieces.push_back(cut_out(whole, part, from, cut->s));
        part.tail = part.head;
        from = cut->s;
      }
      if (part.tail != whole.tail) {
        part.head = whole.head;
        part = cut_out(whole, part, from, length(whole.curve));
      }
      pieces.push_back(part);
    }
    first.back() = pieces.end_id();
    work_.pieces = std::move(pieces);
    for (Route& route : work_.routes) route.uses = replaced(route.uses, first);
  }

  Piece cut_out(const Piece& whole, Piece part, double from, double to) const {
    part.curve = cut_curve(whole.curve, from, to, work_.vertices[part.tail].at, work_.vertices[part.head].at);
    part.checked_near = part.checked_across = false;
    return part;
  }

  /// The part of a curve between two vertices that may lie off it by the tolerance.
  CurvePiece cut_curve(const CurvePiece& whole, double from, double to, Point a, Point b) const {
    const CurvePiece part = sub_piece(whole, from, to, a, b);
    if (!part.is_arc()) return part;
    if (length(part) <= kShortArc * work_.tolerance) return {.a = a, .b = b};
    return moved_to_ends(part, kOffCircle * work_.tolerance);
  }

  static std::vector<DirectedCurve> replaced(const std::vector<DirectedCurve>& uses, const std::vector<CurveId>& first) {
    std::vector<DirectedCurve> now;
    for (const DirectedCurve& use : uses) {
      const std::uint32_t begin = first[use.curve.value].value;
      const std::uint32_t end = first[use.curve.value + 1].value;
      for (std::uint32_t k = 0; k < end - begin; ++k) {
        now.push_back({CurveId(use.reversed ? end - 1 - k : begin + k), use.reversed});
      }
    }
    return now;
  }

  Work& work_;
  Context& context_;
  Point place_;
};

}  // namespace

void resolve(Work& work, Context& context) { Resolver(work, context).run(); }

}  // namespace quadline::arrangement
