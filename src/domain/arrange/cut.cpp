// Second step of `arrange`: pieces cut in parts at the vertices on them.
#include <algorithm>
#include <cmath>

#include "domain/arrange/work.hpp"

namespace quadline::arrangement {

namespace {

constexpr double kShortArc = 16;        // in tolerances; shorter ones are straight
constexpr double kOffCircle = 0x1p-10;  // in tolerances; nearer ends lie on the circle

class Cutter {
 public:
  explicit Cutter(Work& work) : work_(work) {}

  void run(std::vector<Cut>& cuts) {
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

 private:
  Piece cut_out(const Piece& whole, Piece part, double from, double to) const {
    part.curve = cut_curve(work_, whole.curve, from, to, work_.vertices[part.tail].at, work_.vertices[part.head].at);
    part.checked_near = part.checked_across = false;
    return part;
  }

  static std::vector<DirectedCurve> replaced(const std::vector<DirectedCurve>& uses,
                                             const std::vector<CurveId>& first) {
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
};

}  // namespace

CurvePiece cut_curve(const Work& work, const CurvePiece& whole, double from, double to, Point a, Point b) {
  const CurvePiece part = sub_piece(whole, from, to, a, b);
  if (!part.is_arc()) return part;
  if (length(part) <= kShortArc * work.tolerance) return {.a = a, .b = b};
  return moved_to_ends(part, kOffCircle * work.tolerance);
}

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

void cut_pieces(Work& work, std::vector<Cut>& cuts) { Cutter(work).run(cuts); }

}  // namespace quadline::arrangement
