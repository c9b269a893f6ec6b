// Fourth step of `arrange`: how many outer loops and holes are round every face, and what is wrong with the loops.
//
// A face belongs to the domain where one more outer loop than holes is round it. So an outer loop in a hole is an
// island, and a hole that reaches over the boundary or over another hole cuts away what it covers.
#include <algorithm>
#include <set>

#include "domain/arrange/work.hpp"

namespace quadline::arrangement {

namespace {

class Classifier {
 public:
  Classifier(Work& work, Subdivision& parts) : work_(work), parts_(parts) {}

  void run() {
    count_steps();
    spread();
    for (std::uint32_t f = 0; f < parts_.faces.size(); ++f) {
      const Face& face = parts_.faces[f];
      if (face.outer < 0 || face.holes < 0 || face.outer - face.holes > 1) fail(f);
    }
    for (const Route& route : work_.routes) refuse_flat(route);
    bool is_empty = true;
    for (const Face& face : parts_.faces) is_empty = is_empty && !face.is_inside();
    for (const Route& route : work_.routes) {
      if (route.kind == CurveKind::Hole) check_hole(route);
      if (route.kind == CurveKind::Outer && is_empty) {
        throw InputError("nothing is left of the domain: the holes cover it all",
                         work_.where(route.where, work_.pieces[route.uses[0].curve].curve.a));
      }
    }
    report_touching();
  }

 private:
  /// Loops more on the left of a piece than on its right.
  struct Step {
    int outer = 0, holes = 0;
  };

  void count_steps() {
    steps_.assign(work_.pieces.count(), {});
    for (const Route& route : work_.routes) {
      if (route.kind == CurveKind::Line) continue;
      for (const DirectedCurve& use : route.uses) {
        int& count = route.kind == CurveKind::Outer ? steps_[use.curve].outer : steps_[use.curve].holes;
        count += use.reversed == (route.area < 0) ? 1 : -1;
      }
    }
  }

  void spread() {
    std::vector<bool> is_known(parts_.faces.size(), false);
    std::vector<std::uint32_t> queue = {0};
    is_known[0] = true;
    for (std::size_t i = 0; i < queue.size(); ++i) {
      const Face here = parts_.faces[queue[i]];
      for (const std::uint32_t walk : here.walks) {
        for (const Half half : parts_.walks[walk]) {
          const std::uint32_t across = parts_.face_at(half ^ 1u);
          if (is_known[across]) continue;
          const Step& step = steps_[piece_of(half)];
          const int sign = is_reversed(half) ? 1 : -1;  // from the left to the right of the piece one step less
          parts_.faces[across].outer = here.outer + sign * step.outer;
          parts_.faces[across].holes = here.holes + sign * step.holes;
          is_known[across] = true;
          queue.push_back(across);
        }
      }
    }
  }

  bool is_boundary(CurveId id) const { return steps_[id].outer != 0 || steps_[id].holes != 0; }

  /// Names the loops round a face that cannot be, and a place where they meet.
  [[noreturn]] void fail(std::uint32_t face) const {
    std::set<CurveId> round;
    for (const std::uint32_t walk : parts_.faces[face].walks) {
      for (const Half half : parts_.walks[walk]) {
        if (is_boundary(piece_of(half))) round.insert(piece_of(half));
      }
    }
    std::vector<const Route*> loops;
    for (const Route& route : work_.routes) {
      const auto is_round = [&](const DirectedCurve& use) { return round.count(use.curve) > 0; };
      if (route.kind != CurveKind::Line && std::any_of(route.uses.begin(), route.uses.end(), is_round)) {
        loops.push_back(&route);
      }
    }
    QUADLINE_CHECK(!loops.empty());
    const Point at = work_.vertices[meeting_vertex(round)].at;
    const std::string name = "loop '" + loops[0]->name + "'";
    const Face& f = parts_.faces[face];
    std::string message;
    if (f.outer < 0 || f.holes < 0) {
      message = name + " crosses itself: give its points in order round it";
    } else if (loops.size() > 1) {
      message = "loops '" + loops[0]->name + "' and '" + loops[1]->name + "' overlap: make one loop of them";
    } else {
      message =
          name + " lies inside another outer loop, or crosses itself: make it a hole, or give its points in order";
    }
    throw InputError(message, work_.where(loops.back()->where, at));
  }

  /// The vertex where most boundary pieces meet, of those at the ends of some.
  VertexId meeting_vertex(const std::set<CurveId>& round) const {
    IdVector<VertexId, int> degree(work_.vertices.count(), 0);
    for (std::size_t i = 0; i < work_.pieces.count(); ++i) {
      if (!is_boundary(CurveId(i))) continue;
      ++degree[work_.pieces[CurveId(i)].tail];
      ++degree[work_.pieces[CurveId(i)].head];
    }
    VertexId best;
    for (const CurveId id : round) {
      for (const VertexId v : {work_.pieces[id].tail, work_.pieces[id].head}) {
        if (!best.valid() || degree[v] > degree[best]) best = v;
      }
    }
    return best;
  }

  /// A loop that crosses itself may have no area either: where it does is told before, by the faces.
  void refuse_flat(const Route& route) const {
    if (route.kind == CurveKind::Line || !route.is_flat) return;
    throw InputError("loop '" + route.name + "' has no area: it needs three distinct points, in order round it",
                     work_.where(route.where, route.start));
  }

  void check_hole(const Route& hole) {
    bool is_in_outer = false, bounds = false, is_whole = true;
    for (const DirectedCurve& use : hole.uses) {
      const bool is_left = use.reversed == (hole.area < 0);
      const Half within = 2 * use.curve.value + (is_left ? 0 : 1);
      is_in_outer = is_in_outer || parts_.faces[parts_.face_at(within)].outer > 0;
      bounds = bounds || parts_.is_kept(use.curve);
      is_whole = is_whole && parts_.is_kept(use.curve);
    }
    if (hole.uses.empty() || (bounds && is_whole)) return;
    const Point at = work_.pieces[hole.uses[0].curve].curve.a;
    if (!is_in_outer) {
      throw InputError("loop '" + hole.name + "' lies outside every outer loop: move it inside, or take it out",
                       work_.where(hole.where, at));
    }
    const std::string text = bounds ? "reaches over another loop: what they cover together is cut away"
                                    : "lies in another hole: it cuts away nothing";
    work_.findings.push_back({"'" + hole.name + "' " + text, hole.where, at, true});
  }

  void report_touching() {
    IdVector<VertexId, const Route*> owner(work_.vertices.count(), nullptr);
    std::set<std::pair<const Route*, const Route*>> pairs;
    for (const Route& route : work_.routes) {
      if (route.kind == CurveKind::Line) continue;
      for (const DirectedCurve& use : route.uses) {
        const Piece& piece = work_.pieces[use.curve];
        const VertexId v = use.reversed ? piece.head : piece.tail;
        if (owner[v] && owner[v] != &route && pairs.insert({owner[v], &route}).second) {
          const std::string text = "'" + route.name + "' touches '" + owner[v]->name + "'";
          work_.findings.push_back({text, route.where, work_.vertices[v].at});
        }
        owner[v] = &route;
      }
    }
  }

  Work& work_;
  Subdivision& parts_;
  IdVector<CurveId, Step> steps_;
};

}  // namespace

void classify(Work& work, Subdivision& parts) { Classifier(work, parts).run(); }

}  // namespace quadline::arrangement
