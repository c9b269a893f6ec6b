#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "geom/predicates.hpp"
#include "io/poly/planar_graph.hpp"
#include "quadline/errors.hpp"

namespace quadline {

namespace {

constexpr double kNothing = 1e-9;  // of the extent: files are written with fewer digits than a double has

Box box_of(Point a, Point b) { return join({a, a}, {b, b}); }

class Planarizer {
 public:
  Planarizer(StraightLineGraph& graph, const std::string& file) : graph_(graph), file_(file) {}

  std::vector<std::uint32_t> run() {
    const std::size_t n_given = graph_.points.size();
    if (n_given == 0) return {};
    // Crossing points are rounded, so that a split segment may run over what it passed before: again, a few times.
    int rounds = 0;
    do {
      if (rounds++ == kMostRounds) fail_at_crossing();
      merge_points();
    } while (split_all());
    stand_in_.resize(n_given);
    return std::move(stand_in_);
  }

 private:
  static constexpr int kMostRounds = 8;

  Point at(std::uint32_t point) const { return graph_.points[point]; }

  void merge_points() {
    std::vector<Box> boxes;
    for (const Point p : graph_.points) boxes.push_back({p, p});
    Box all = boxes[0];
    for (const Box& box : boxes) all = join(all, box);
    nothing_ = kNothing * distance(all.lo, all.hi);
    const BoxTree tree(boxes);
    stand_in_.clear();
    for (std::uint32_t i = 0; i < boxes.size(); ++i) {
      std::uint32_t first = i;
      tree.query(inflated(boxes[i], nothing_), [&](std::uint32_t j) {
        if (j < first && stand_in_[j] == j && distance(at(i), at(j)) <= nothing_) first = j;
      });
      stand_in_.push_back(first);
    }
    for (GraphSegment& segment : graph_.segments) {
      segment.a = stand_in_[segment.a];
      segment.b = stand_in_[segment.b];
    }
  }

  /// Splits every segment where points lie on it and where others cross it. False where there was nothing to do.
  bool split_all() {
    drop_repeated();
    std::vector<Box> boxes;
    for (const GraphSegment& segment : graph_.segments) boxes.push_back(box_of(at(segment.a), at(segment.b)));
    const BoxTree tree(boxes);
    cuts_.assign(graph_.segments.size(), {});
    std::vector<char> is_end(graph_.points.size(), 0);
    for (const GraphSegment& segment : graph_.segments) is_end[segment.a] = is_end[segment.b] = 1;
    for (std::uint32_t p = 0; p < is_end.size(); ++p) {
      if (!is_end[p]) continue;
      tree.query(inflated(box_of(at(p), at(p)), nothing_), [&](std::uint32_t s) { cut_by_point(s, p); });
    }
    for (std::uint32_t s = 0; s < boxes.size(); ++s)
      tree.query(boxes[s], [&](std::uint32_t t) {
        if (t > s) cut_by_segment(s, t);
      });
    return apply_cuts();
  }

  void drop_repeated() {
    auto& segments = graph_.segments;
    std::vector<std::uint32_t> order(segments.size());
    for (std::uint32_t i = 0; i < order.size(); ++i) order[i] = i;
    const auto key = [&](std::uint32_t i) {
      return std::pair(std::min(segments[i].a, segments[i].b), std::max(segments[i].a, segments[i].b));
    };
    std::stable_sort(order.begin(), order.end(), [&](std::uint32_t i, std::uint32_t j) { return key(i) < key(j); });
    std::vector<char> is_kept(segments.size(), 0);
    for (std::size_t i = 0; i < order.size(); ++i) {
      const bool has_length = segments[order[i]].a != segments[order[i]].b;
      is_kept[order[i]] = has_length && (i == 0 || key(order[i]) != key(order[i - 1]));
    }
    std::size_t n = 0;
    for (std::size_t i = 0; i < segments.size(); ++i)
      if (is_kept[i]) segments[n++] = segments[i];
    segments.resize(n);
  }

  void cut_by_point(std::uint32_t s, std::uint32_t p) {
    const GraphSegment& segment = graph_.segments[s];
    if (p == segment.a || p == segment.b) return;
    const Point along = at(segment.b) - at(segment.a), way = at(p) - at(segment.a);
    const double length = norm(along), place = dot(way, along) / length;
    const bool is_beside = place > 0 && place < length;
    if (is_beside && std::abs(cross(along, way)) <= nothing_ * length) cuts_[s].push_back({place, p});
  }

  void cut_by_segment(std::uint32_t s, std::uint32_t t) {
    const auto [a, b] = ends(s);
    const auto [c, d] = ends(t);
    const bool cross_each_other = orientation(a, b, c) * orientation(a, b, d) < 0 &&  //
                                  orientation(c, d, a) * orientation(c, d, b) < 0;
    if (!cross_each_other || is_cut_at_end(s, t)) return;
    // Relative to c: where the file lies far from the origin, this keeps the digits.
    const double part = cross(c - a, d - c) / cross(b - a, d - c);
    const Point p = a + std::clamp(part, 0.0, 1.0) * (b - a);
    if (p == a || p == b || p == c || p == d) return;
    const auto index = static_cast<std::uint32_t>(graph_.points.size());
    graph_.points.push_back(p);
    cuts_[s].push_back({distance(a, p), index});
    cuts_[t].push_back({distance(c, p), index});
  }

  std::array<Point, 2> ends(std::uint32_t s) const { return {at(graph_.segments[s].a), at(graph_.segments[s].b)}; }

  /// One of the two is cut at an end of the other already: so near to it, that is the crossing.
  bool is_cut_at_end(std::uint32_t s, std::uint32_t t) const {
    const auto at_end_of = [&](std::uint32_t cut, const GraphSegment& other) {
      for (const Cut& c : cuts_[cut])
        if (c.point == other.a || c.point == other.b) return true;
      return false;
    };
    return at_end_of(s, graph_.segments[t]) || at_end_of(t, graph_.segments[s]);
  }

  bool apply_cuts() {
    std::vector<GraphSegment> pieces;
    for (std::size_t s = 0; s < graph_.segments.size(); ++s) {
      std::sort(cuts_[s].begin(), cuts_[s].end());
      GraphSegment piece = graph_.segments[s];
      for (const Cut& cut : cuts_[s]) {
        piece.b = cut.point;
        if (piece.a != piece.b) pieces.push_back(piece);
        piece.a = cut.point;
        last_cut_ = {graph_.segments[s].line, at(cut.point)};
      }
      piece.b = graph_.segments[s].b;
      pieces.push_back(piece);
    }
    const bool has_cut = pieces.size() > graph_.segments.size();
    graph_.segments = std::move(pieces);
    return has_cut;
  }

  [[noreturn]] void fail_at_crossing() const {
    throw InputError("segments cross here too flatly to be split: let them end at a common point",
                     Where{file_, "line " + std::to_string(last_cut_.first), last_cut_.second});
  }

  struct Cut {
    double place;  ///< distance from the start of the segment
    std::uint32_t point;
    friend auto operator<=>(const Cut&, const Cut&) = default;
  };

  StraightLineGraph& graph_;
  const std::string& file_;
  double nothing_ = 0;
  std::vector<std::uint32_t> stand_in_;  ///< of each point, the one that took its place
  std::vector<std::vector<Cut>> cuts_;   ///< of each segment
  std::pair<std::size_t, Point> last_cut_{};
};

}  // namespace

std::vector<std::uint32_t> make_planar(StraightLineGraph& graph, const std::string& file) {
  return Planarizer(graph, file).run();
}

}  // namespace quadline
