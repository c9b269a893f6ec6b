// Second step of `arrange`: rounds of merging and cutting until the pieces meet at shared vertices only.
//
// In the manner of snap rounding [Hobby1999], but with a distance in place of a grid, so that the model's own corners
// stay where they are: vertices end up farther than the tolerance from each other, and farther than half of it from
// every piece that they do not end. A crossing is then never near a vertex, a cut never makes a piece shorter than the
// tolerance, and the rounds come to rest.
#include <algorithm>
#include <cmath>

#include "domain/arrange/work.hpp"
#include "search/box_tree.hpp"

namespace quadline::arrangement {

namespace {

constexpr int kMaxRounds = 64;  // four or five are usual
constexpr double kBoxesPerPiece = 2;

/// Boxes of parts of pieces: long pieces are taken in parts, since the box of a long slanted one is mostly empty.
struct Parts {
  std::vector<Box> boxes;
  std::vector<CurveId> piece;
};

class Resolver {
 public:
  Resolver(Work& work, Context& context) : work_(work), context_(context), touch_(kTouch * work.tolerance) {}

  void run() {
    for (int round = 0; round < kMaxRounds; ++round) {
      context_.progress("arrange", 0.7 * round / (round + 2.0));
      merge(work_, round == 0);
      const Parts parts = cover_pieces();
      const BoxTree tree(parts.boxes);
      std::vector<Cut> cuts = cuts_at_vertices(tree, parts);
      if (cuts.empty()) cuts = cuts_at_crossings(tree, parts);
      if (cuts.empty()) return;
      place_ = work_.vertices[cuts[0].vertex].at;
      cut_pieces(work_, cuts);
    }
    throw InputError("curves here cannot be told apart: remove details finer than the tolerance",
                     work_.where("", place_));
  }

 private:
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
        const double gap = distance_to(piece.curve, vertex.at);
        if (gap > touch_) return;
        if (!vertex.checked && vertex.rank <= Rank::Point)
          work_.report_joined("a point and a curve are joined", gap, vertex.at);
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

  Work& work_;
  Context& context_;
  double touch_;
  Point place_;
};

}  // namespace

void resolve(Work& work, Context& context) { Resolver(work, context).run(); }

}  // namespace quadline::arrangement
