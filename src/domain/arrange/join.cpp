// Last step of `arrange`, first half: pieces are joined again where nothing needs the vertex between them.
#include <cmath>

#include "domain/arrange/work.hpp"

namespace quadline::arrangement {

namespace {

constexpr double kSmooth = 1.0 / 16;  // in tolerances

class Joiner {
 public:
  Joiner(Work& work, const Subdivision& parts) : work_(work), parts_(parts) {}

  Joints run() {
    list_routes();
    find_joints();
    keep_two_on_circles();
    return std::move(out_);
  }

 private:
  /// Which routes run along each piece, without repeats.
  void list_routes() {
    out_.routes.assign(work_.pieces.count(), {});
    for (std::uint32_t r = 0; r < work_.routes.size(); ++r) {
      for (const DirectedCurve& use : work_.routes[r].uses) {
        std::vector<std::uint32_t>& routes = out_.routes[use.curve];
        if (routes.empty() || routes.back() != r) routes.push_back(r);
      }
    }
  }

  void find_joints() {
    IdVector<VertexId, int> degree(work_.vertices.count(), 0);
    IdVector<VertexId, CurveId> into(work_.vertices.count());
    out_.out_of.assign(work_.vertices.count(), CurveId());
    for (std::size_t i = 0; i < work_.pieces.count(); ++i) {
      const Piece& piece = work_.pieces[CurveId(i)];
      if (!parts_.is_kept(CurveId(i))) continue;
      ++degree[piece.tail];
      ++degree[piece.head];
      into[piece.head] = CurveId(i);
      out_.out_of[piece.tail] = CurveId(i);
    }
    out_.is_joint.assign(work_.vertices.count(), false);
    for (std::size_t i = 0; i < work_.vertices.count(); ++i) {
      const VertexId v(i);
      if (degree[v] != 2 || !into[v].valid() || !out_.out_of[v].valid() || into[v] == out_.out_of[v]) continue;
      const Piece& a = work_.pieces[into[v]];
      const Piece& b = work_.pieces[out_.out_of[v]];
      out_.is_joint[v] = work_.vertices[v].rank >= Rank::Crossing && a.origin == b.origin &&
                         a.curve.is_arc() == b.curve.is_arc() && out_.routes[into[v]] == out_.routes[out_.out_of[v]] &&
                         is_smooth(a, b);
    }
    for (const VertexId v : work_.point_vertex) out_.is_joint[v] = false;
  }

  /// Does joining the two leave the curve where it is?
  bool is_smooth(const Piece& a, const Piece& b) const {
    const CurvePiece chord{.a = a.curve.a, .b = b.curve.b};
    return a.curve.is_arc() || distance_to(chord, a.curve.b) <= kSmooth * work_.tolerance;
  }

  /// A whole circle keeps two vertices, so that no curve ends where it starts: its own and one opposite.
  void keep_two_on_circles() {
    std::vector<bool> is_seen(work_.pieces.count(), false);
    for (std::size_t i = 0; i < work_.pieces.count(); ++i) {
      if (!parts_.is_kept(CurveId(i)) || is_seen[i]) continue;
      const VertexId start = work_.pieces[CurveId(i)].tail;
      if (out_.is_joint[start]) continue;
      const VertexId end = mark_chain(CurveId(i), is_seen);
      if (end == start) keep_opposite(CurveId(i));
    }
    // What is left are circles of joints alone.
    for (std::size_t i = 0; i < work_.pieces.count(); ++i) {
      if (!parts_.is_kept(CurveId(i)) || is_seen[i]) continue;
      out_.is_joint[work_.pieces[CurveId(i)].tail] = false;
      mark_chain(CurveId(i), is_seen);
      keep_opposite(CurveId(i));
    }
  }

  /// Marks the pieces from `first` on up to a vertex that is no joint, and returns it.
  VertexId mark_chain(CurveId first, std::vector<bool>& is_seen) const {
    VertexId at;
    for (CurveId piece = first;; piece = out_.out_of[at]) {
      is_seen[piece.value] = true;
      at = work_.pieces[piece].head;
      if (!out_.is_joint[at]) return at;
    }
  }

  /// Keeps the joint that is nearest to the other side of the circle from the start of `first`, and moves it there.
  void keep_opposite(CurveId first) {
    const CurvePiece& curve = work_.pieces[first].curve;
    const Point spoke = curve.a - curve.center;
    const Point opposite = curve.center - (curve.radius / norm(spoke)) * spoke;
    VertexId best;
    for (VertexId v = work_.pieces[first].head; out_.is_joint[v]; v = work_.pieces[out_.out_of[v]].head) {
      const double d = distance(work_.vertices[v].at, opposite);
      if (!best.valid() || d < distance(work_.vertices[best].at, opposite)) best = v;
    }
    QUADLINE_CHECK(best.valid() && curve.is_arc());
    out_.is_joint[best] = false;
    work_.vertices[best].at = opposite;
    out_.moved.insert(best);
  }

  Work& work_;
  const Subdivision& parts_;
  Joints out_;
};

}  // namespace

Joints find_joints(Work& work, const Subdivision& parts) { return Joiner(work, parts).run(); }

}  // namespace quadline::arrangement
