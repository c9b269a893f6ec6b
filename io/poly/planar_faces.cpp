// Faces by walking: each closed walk of half-edges is a rim of one face. A connected part of the graph has one rim that
// sees it from outside; the face it belongs to is found by a ray from the top of the part. Decisions are exact.
#include <algorithm>
#include <limits>
#include <tuple>

#include "geom/predicates.hpp"
#include "io/poly/planar_graph.hpp"

namespace quadline {

namespace {

std::vector<Box> boxes_of(const StraightLineGraph& graph) {
  std::vector<Box> boxes;
  for (const GraphSegment& segment : graph.segments) {
    const Point a = graph.points[segment.a], b = graph.points[segment.b];
    boxes.push_back(join({a, a}, {b, b}));
  }
  return boxes;
}

/// Above or level with `from` and to the right: the first half turn of directions.
bool is_in_upper_half(Point from, Point to) { return to.y != from.y ? to.y > from.y : to.x > from.x; }

/// A segment by its ends, the lower one first; of no use for level ones.
struct Rise {
  Point low, high;
};

/// True where s lies left of t at the heights they share. They do not cross.
bool is_left_of(const Rise& s, const Rise& t) {
  if (s.low.y >= t.low.y) {
    const int side = orientation(t.low, t.high, s.low);
    if (side != 0) return side > 0;
  } else {
    const int side = orientation(s.low, s.high, t.low);
    if (side != 0) return side < 0;
  }
  if (s.high.y <= t.high.y) return orientation(t.low, t.high, s.high) > 0;
  return orientation(s.low, s.high, t.high) < 0;
}

}  // namespace

PlanarFaces::PlanarFaces(const StraightLineGraph& graph) : graph_(graph), tree_(boxes_of(graph)) {
  sort_round_points();
  const std::vector<std::uint32_t> cycle = number_cycles();  // of each half-edge
  const auto n_cycles = cycle.empty() ? 0 : 1 + *std::max_element(cycle.begin(), cycle.end());

  // Parts of the graph, by their topmost (then rightmost) point: from the top down, so that what a ray meets, which
  // reaches higher, has its face already.
  std::vector<std::uint32_t> part(graph.points.size(), kNone), tops;
  std::vector<std::uint32_t> order(cycle.size());
  for (std::uint32_t h = 0; h < order.size(); ++h) order[h] = h;
  const auto key = [&](std::uint32_t h) {
    const Point p = graph.points[tail(h)];
    return std::tuple(-p.y, -p.x, h);
  };
  std::sort(order.begin(), order.end(), [&](std::uint32_t g, std::uint32_t h) { return key(g) < key(h); });
  std::vector<std::uint32_t> stack;
  for (const std::uint32_t start : order) {
    if (part[tail(start)] != kNone) continue;
    tops.push_back(start);
    part[tail(start)] = start;
    stack.push_back(start);
    while (!stack.empty()) {
      const std::uint32_t first = stack.back();
      stack.pop_back();
      std::uint32_t h = first;
      do {
        if (part[head(h)] == kNone) {
          part[head(h)] = start;
          stack.push_back(h ^ 1u);
        }
        h = clockwise_[h];
      } while (h != first);
    }
  }

  std::vector<std::uint32_t> face_of_cycle(n_cycles, kNone);
  std::vector<std::uint32_t> outer_cycles;
  for (const std::uint32_t top : tops) {
    // All edges at the top go down; straight up lies in the face left of the last of them, counter-clockwise.
    std::uint32_t last = top;
    const Point p = graph.points[tail(top)];
    for (std::uint32_t h = clockwise_[top]; h != top; h = clockwise_[h])
      if (orientation(p, graph.points[head(last)], graph.points[head(h)]) > 0) last = h;
    outer_cycles.push_back(cycle[last]);
  }
  for (const std::uint32_t c : outer_cycles) face_of_cycle[c] = kOutside;
  for (std::uint32_t& f : face_of_cycle)
    if (f == kNone) f = n_faces_++;
  for (std::size_t i = 0; i < tops.size(); ++i) {
    const std::uint32_t right = half_right_of(graph.points[tail(tops[i])]);
    if (right != kNone) face_of_cycle[outer_cycles[i]] = face_of_cycle[cycle[right]];
  }
  face_.resize(cycle.size());
  for (std::size_t h = 0; h < cycle.size(); ++h) face_[h] = face_of_cycle[cycle[h]];
}

void PlanarFaces::sort_round_points() {
  const auto n = static_cast<std::uint32_t>(2 * graph_.segments.size());
  std::vector<std::uint32_t> order(n);
  for (std::uint32_t h = 0; h < n; ++h) order[h] = h;
  std::sort(order.begin(), order.end(), [&](std::uint32_t g, std::uint32_t h) {
    if (tail(g) != tail(h)) return tail(g) < tail(h);
    const Point p = graph_.points[tail(g)], a = graph_.points[head(g)], b = graph_.points[head(h)];
    const bool upper_a = is_in_upper_half(p, a), upper_b = is_in_upper_half(p, b);
    if (upper_a != upper_b) return upper_a;
    const int side = orientation(p, a, b);
    return side != 0 ? side > 0 : g < h;
  });
  clockwise_.resize(n);
  for (std::uint32_t i = 0; i < n;) {
    std::uint32_t j = i;
    while (j < n && tail(order[j]) == tail(order[i])) ++j;
    for (std::uint32_t k = i; k < j; ++k) clockwise_[order[k]] = order[k == i ? j - 1 : k - 1];
    i = j;
  }
}

std::vector<std::uint32_t> PlanarFaces::number_cycles() {
  std::vector<std::uint32_t> cycle(clockwise_.size(), kNone);
  std::uint32_t n = 0;
  for (std::uint32_t start = 0; start < cycle.size(); ++start) {
    if (cycle[start] != kNone) continue;
    for (std::uint32_t h = start; cycle[h] == kNone; h = clockwise_[h ^ 1u]) cycle[h] = n;
    ++n;
  }
  return cycle;
}

/// The half-edge upwards that a ray from p to the right meets first; kNone: none. The ray runs a hair above p.
std::uint32_t PlanarFaces::half_right_of(Point p) const {
  const double infinity = std::numeric_limits<double>::infinity();
  std::uint32_t found = kNone;
  Rise nearest{};
  tree_.query({p, {infinity, p.y}}, [&](std::uint32_t s) {
    const std::uint32_t up =
        2 * s + (graph_.points[graph_.segments[s].a].y < graph_.points[graph_.segments[s].b].y ? 0 : 1);
    const Rise rise{graph_.points[tail(up)], graph_.points[head(up)]};
    const bool is_met = rise.low.y <= p.y && p.y < rise.high.y && orientation(rise.low, rise.high, p) > 0;
    if (!is_met || (found != kNone && !is_left_of(rise, nearest))) return;
    found = up;
    nearest = rise;
  });
  return found;
}

std::uint32_t PlanarFaces::face_at(Point p) const {
  const std::uint32_t half = half_right_of(p);
  return half == kNone ? kOutside : face_[half];
}

}  // namespace quadline
