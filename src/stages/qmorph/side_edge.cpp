// Side edges [Owen1999 section 3.2, Lee2003 section 4]: reuse an edge within pi/6 of the wanted direction, else swap,
// else split. We differ: the wanted direction is the corner's angle over the number of quads that will fill it (the
// bisector for two, the normal at the end of an open line); an edge that would make a front loop odd is not taken but
// split, as in [Lee2003], unless a neighbour within pi/4 will do.
#include <numbers>

#include "stages/qmorph/morph.hpp"

namespace quadline {

namespace {

// Cosines of how far a side edge may lie from the wanted direction
constexpr double kFan = degrees(30).cosine;      // [Owen1999], [Lee2003]
constexpr double kWideFan = degrees(45).cosine;  // before a node is inserted
constexpr double kLastFan = degrees(60).cosine;  // before the step is given up
constexpr double kLongest = 1.7;                 // side edges above this part of the local size are split
constexpr double kShortest = 0.35;               // no piece below this part of the local size is made

// Cosine of the angle between two directions.
double closeness(Point u, Point v) { return dot(u, v) / std::sqrt(norm2(u) * norm2(v)); }

}  // namespace

NodeId Morph::side_edge(const Corner& corner, End end) {
  const Topology& topo = mesh_.topo();
  const NodeId foot = end == End::Tail ? topo.head(corner.out) : topo.tail(corner.in);
  const NodeId neighbour = end == End::Tail ? topo.tail(corner.in) : topo.head(corner.out);
  if (corner.quads <= 1) {
    ++counts_.side_neighbour;
    return neighbour;
  }

  const Point k = mesh_.point(corner.node);
  const double turn = radians(corner.angle) / corner.quads;
  const Point direction = turned(mesh_.point(foot) - k, end == End::Tail ? turn : -turn);
  if (const NodeId v = reuse_edge(corner, direction, kFan, foot); v.valid()) return v;

  // The triangle of the fan that the wanted direction cuts
  HalfId cut, h = corner.out;
  do {
    const HalfId rim = topo.next(h);
    const Point a = mesh_.point(topo.tail(rim)) - k, b = mesh_.point(topo.head(rim)) - k;
    if (cross(a, direction) >= 0 && cross(direction, b) > 0) cut = rim;
    h = topo.rotate_ccw(h);
  } while (h != twin(corner.in) && !cut.valid());
  const double longest =
      std::numbers::sqrt3 / 2 * (mesh_.edge_length(edge_of(corner.in)) + mesh_.edge_length(edge_of(corner.out)));
  if (cut.valid()) {
    if (const NodeId v = swap_for_edge(corner, cut, direction, longest, foot); v.valid()) return v;
  }
  if (const NodeId v = reuse_edge(corner, direction, kWideFan, foot); v.valid()) return v;
  if (cut.valid()) {
    if (const NodeId v = split_for_edge(corner, cut, direction); v.valid()) return v;
  }
  return reuse_edge(corner, direction, kLastFan, foot);
}

// The edge of the corner's fan nearest to the direction, closer than `least_cosine` says, that keeps the loops even.
NodeId Morph::reuse_edge(const Corner& corner, Point direction, double least_cosine, NodeId foot) {
  const Topology& topo = mesh_.topo();
  const Point k = mesh_.point(corner.node);
  const double longest = kLongest * size_at(k);
  double best = least_cosine;
  double best_split = least_cosine;
  HalfId found, to_split;
  bool would_be_odd = false;  // the edge to split, if taken whole
  for (HalfId h = topo.rotate_ccw(corner.out); h != twin(corner.in) && h != corner.out; h = topo.rotate_ccw(h)) {
    const NodeId v = topo.head(h);
    if (v == foot || is_held(edge_of(h))) continue;
    const double close = closeness(mesh_.point(v) - k, direction);
    if (close <= best && close <= best_split) continue;
    const std::size_t mark = parity_.mark();
    const bool even = parity_.tie(corner.node, v, true);
    parity_.rollback(mark);
    const bool attached = is_attached(mesh_, v);
    if (even && !(attached && mesh_.edge_length(edge_of(h)) > longest)) {
      if (close > best) {
        best = close;
        found = h;
      }
    } else if (close > best_split) {
      best_split = close;
      to_split = h;
      would_be_odd = !even;
    }
  }
  if (to_split.valid() && best_split > best) {
    if (const NodeId v = shorten_edge(to_split); v.valid()) {
      ++(would_be_odd ? counts_.side_split_parity : counts_.side_split_length);
      return v;
    }
  }
  if (!found.valid()) return {};
  ++counts_.side_chosen;
  return topo.head(found);
}

// The paper's rule for odd loops: the side edge is split, and the new node is free. Also for edges much too long.
NodeId Morph::shorten_edge(HalfId side) {
  const Point k = mesh_.point(mesh_.topo().tail(side)), m = mesh_.point(mesh_.topo().head(side));
  const double h = size_at(k), length = distance(k, m);
  if (length < 2 * kShortest * h || !may_insert()) return {};
  const double part = length > 2 * h ? h / length : 0.5;
  return add_free_node(side, k + part * (m - k));
}

NodeId Morph::swap_for_edge(const Corner& corner, HalfId cut, Point direction, double longest, NodeId foot) {
  const Topology& topo = mesh_.topo();
  if (mesh_.can_merge(edge_of(cut)) != Refusal::None || is_held(edge_of(cut))) return {};
  const NodeId v = topo.head(topo.next(twin(cut)));
  const Point side = mesh_.point(v) - mesh_.point(corner.node);
  if (v == foot || norm(side) >= longest || closeness(side, direction) <= kFan) return {};
  if (mesh_.can_swap(edge_of(cut)) != Refusal::None) return {};
  const std::size_t mark = parity_.mark();
  const bool even = parity_.tie(corner.node, v, true);
  parity_.rollback(mark);
  if (!even) return {};
  mesh_.swap_edge(edge_of(cut));
  ++counts_.side_swapped;
  return v;
}

NodeId Morph::split_for_edge(const Corner& corner, HalfId cut, Point direction) {
  const Topology& topo = mesh_.topo();
  if (mesh_.can_merge(edge_of(cut)) != Refusal::None || is_held(edge_of(cut)) || !may_insert()) return {};
  const Point k = mesh_.point(corner.node), a = mesh_.point(topo.tail(cut)), b = mesh_.point(topo.head(cut));
  const double across = cross(b - a, direction);
  const double t = across == 0 ? 0.5 : cross(k - a, direction) / across;
  const Point p = a + std::fmin(0.8, std::fmax(0.2, t)) * (b - a);
  const double h = size_at(k);
  if (distance(k, p) < kShortest * h) return {};
  const NodeId v = add_free_node(cut, p);
  ++counts_.side_split_direction;
  if (distance(k, p) > 1.3 * h) try_move(v, k + (h / norm(direction)) * direction);
  return v;
}

}  // namespace quadline
