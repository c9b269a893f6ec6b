// The normal step of Q-Morph [Owen1999]: base edge, two side edges, top edge; what they enclose becomes a quad.
#include <algorithm>

#include "stages/qmorph/morph.hpp"

namespace quadline {

namespace {

constexpr std::size_t kMostEnclosed = 64;     // triangles; more means that the flood has leaked
constexpr Angle kWidestFixed = degrees(168);  // no smoothing opens a corner at a fixed node

}  // namespace

bool Morph::form_quad(HalfId base) {
  const Topology& topo = mesh_.topo();
  const NodeId a = topo.tail(base), b = topo.head(base);
  const std::size_t mark = parity_.mark();
  const MorphCounts counts = counts_;
  const auto refuse = [&](std::size_t MorphCounts::* reason) {
    parity_.rollback(mark);
    counts_ = counts;
    ++(counts_.*reason);
    held_ = EdgeId();
    return false;
  };
  held_ = EdgeId();
  const Corner at_tail = corner_before(mesh_, base);
  const NodeId left = side_edge(at_tail, End::Tail);
  if (!left.valid() || left == b || !parity_.tie(a, left, true)) return refuse(&MorphCounts::refused_side);
  held_ = edge_of(topo.find(a, left));
  const Corner at_head = corner_after(mesh_, base);
  const NodeId right = side_edge(at_head, End::Head);
  if (!right.valid() || right == a || right == left || !parity_.tie(b, right, true))
    return refuse(&MorphCounts::refused_side);

  // The colours of left and right differ, as those of a and b do: the top edge keeps the loops even.
  ++(topo.find(right, left).valid() ? counts_.top_found : counts_.top_swapped);
  const HalfId top = recover_edge(right, left);
  if (!top.valid()) return refuse(&MorphCounts::refused_top);
  const HalfId left_side = topo.find(left, a), right_side = topo.find(b, right);
  if (!left_side.valid() || !right_side.valid()) return refuse(&MorphCounts::refused_shape);
  std::vector<FaceId> inside;
  if (!enclosed_triangles(base, {edge_of(base), edge_of(right_side), edge_of(top), edge_of(left_side)}, inside))
    return refuse(&MorphCounts::refused_shape);
  const Polygon quad(a, b, right, left);
  if (!is_good_enough(quad)) return refuse(&MorphCounts::refused_shape);

  ++counts_.quads[static_cast<std::size_t>(at_tail.state)][static_cast<std::size_t>(at_head.state)];
  held_ = EdgeId();
  put_quads(inside, {quad}, level(edge_of(base)) + 1);
  touched_ = {a, b, right, left};
  smooth_around(touched_);
  return true;
}

// The triangles left of `start` within the rim; false where the rim does not enclose just free triangles.
bool Morph::enclosed_triangles(HalfId start, const std::vector<EdgeId>& rim, std::vector<FaceId>& inside) const {
  const Topology& topo = mesh_.topo();
  const auto contains = [](const auto& items, auto item) {
    return std::find(items.begin(), items.end(), item) != items.end();
  };
  inside.assign(1, topo.face(start));
  std::vector<NodeId> rim_nodes, nodes;
  for (const EdgeId e : rim) {
    rim_nodes.push_back(topo.tail(half_of(e, 0)));
    rim_nodes.push_back(topo.tail(half_of(e, 1)));
  }
  for (std::size_t i = 0; i < inside.size(); ++i) {
    bool enclosed = true;
    topo.for_each_half(inside[i], [&](HalfId h) {
      if (!contains(rim_nodes, topo.tail(h)) && !contains(nodes, topo.tail(h))) nodes.push_back(topo.tail(h));
      if (contains(rim, edge_of(h))) return;
      if (mesh_.can_merge(edge_of(h)) != Refusal::None) {
        enclosed = false;
      } else if (!contains(inside, topo.face(twin(h)))) {
        inside.push_back(topo.face(twin(h)));
      }
    });
    if (!enclosed || inside.size() > kMostEnclosed) return false;
  }
  return std::all_of(nodes.begin(), nodes.end(), [&](NodeId v) { return mesh_.is_free(v) && !is_attached(mesh_, v); });
}

// What valid triangles fill has no more than one reflex corner, and smoothing opens that, but not at a node that stays.
bool Morph::is_good_enough(const Polygon& quad) const {
  const auto p = [&](int i) { return mesh_.point(quad.nodes[i % 4]); };
  for (int i = 0; i < 4; ++i)
    if (!mesh_.is_free(quad.nodes[i]) && angle_at(p(i + 3), p(i), p(i + 1)) > kWidestFixed) return false;
  return true;
}

void Morph::put_quads(const std::vector<FaceId>& cavity, const std::vector<Polygon>& quads, int level) {
  std::vector<FaceId> made;
  mesh_.replace_cavity(cavity, quads, made);
  for (const FaceId f : made)
    mesh_.topo().for_each_half(f, [&](HalfId h) {
      if (mesh_.is_triangle(twin(h)) && mesh_.can_cross(h) == Refusal::None) set_level(edge_of(h), level);
    });
}

void Morph::set_level(EdgeId e, int level) {
  level_.grow(e.value + std::size_t{1}, 0);
  level_[e] = level;
}

NodeId Morph::add_free_node(HalfId split, Point p) {
  const NodeId v = mesh_.split_edge(edge_of(split), p);
  parity_.forget(v);
  --insertions_;
  return v;
}

}  // namespace quadline
