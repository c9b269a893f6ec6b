#include "topo/topology.hpp"

#include <algorithm>
#include <utility>

#include "base/check.hpp"

namespace quadline {

namespace {

constexpr FaceId kInCavity(UINT32_MAX - 1);

}  // namespace

HalfId Topology::find(NodeId a, NodeId b) const {
  HalfId found;
  const HalfId start = out(a);
  if (!start.valid()) return found;
  HalfId h = start;
  do {
    if (head(h) == b) return h;
    h = rotate_ccw(h);
  } while (h != start);
  return found;
}

Polygon Topology::polygon(FaceId f) const {
  Polygon p;
  for_each_half(f, [&](HalfId h) { p.nodes[p.n++] = tail(h); });
  return p;
}

int Topology::edge_valence(NodeId v) const {
  int n = 0;
  for_each_out(v, [&](HalfId) { ++n; });
  return n;
}

NodeId Topology::add_node() {
  if (free_nodes_.empty()) return out_.push_back(HalfId());
  const NodeId v = free_nodes_.back();
  free_nodes_.pop_back();
  out_[v] = HalfId();
  return v;
}

void Topology::remove_node(NodeId v) {
  QUADLINE_CHECK(out_[v] == HalfId());
  out_[v] = kDeleted;
  free_nodes_.push_back(v);
}

EdgeId Topology::add_edge(NodeId a, NodeId b) {
  EdgeId e;
  if (free_edges_.empty()) {
    e = EdgeId(half_.count() / 2);
    half_.push_back({});
    half_.push_back({});
  } else {
    e = free_edges_.back();
    free_edges_.pop_back();
  }
  half_[half_of(e, 0)] = {a, HalfId(), HalfId(), FaceId()};
  half_[half_of(e, 1)] = {b, HalfId(), HalfId(), FaceId()};
  return e;
}

void Topology::free_edge(EdgeId e) {
  half_[half_of(e, 0)] = {};
  half_[half_of(e, 1)] = {};
  free_edges_.push_back(e);
}

FaceId Topology::add_face(HalfId first) {
  FaceId f;
  if (free_faces_.empty()) {
    f = first_.push_back(first);
  } else {
    f = free_faces_.back();
    free_faces_.pop_back();
    first_[f] = first;
  }
  return f;
}

void Topology::close_triangle(FaceId f, HalfId a, HalfId b, HalfId c) {
  link(a, b);
  link(b, c);
  link(c, a);
  half_[a].face = half_[b].face = half_[c].face = f;
  first_[f] = a;
}

void Topology::build(std::size_t n_nodes, std::span<const Polygon> polygons) {
  *this = {};
  out_.assign(n_nodes, HalfId());
  // Half-edges that wait for the face on their other side, in a list for each node, that of their smaller end. What
  // comes next in the list stands in the `next` of their twins, which have none yet.
  IdVector<NodeId, HalfId> waiting(n_nodes);
  for (const Polygon& p : polygons) {
    const FaceId f = add_face(HalfId());
    HalfId before, first;
    for (int i = 0; i < p.n; ++i) {
      const NodeId a = p.nodes[i], b = p.nodes[(i + 1) % p.n];
      QUADLINE_CHECK(a != b && a.value < n_nodes && b.value < n_nodes);
      const NodeId smaller = std::min(a, b), larger = std::max(a, b);
      HalfId* place = &waiting[smaller];
      while (place->valid() && tail(*place) != larger && head(*place) != larger) place = &half_[twin(*place)].next;
      HalfId h;
      if (place->valid()) {
        h = twin(*place);
        QUADLINE_CHECK(tail(h) == a);  // else two faces lie on the same side of an edge
        *place = half_[h].next;
      } else {
        h = half_of(add_edge(a, b));
        half_[twin(h)].next = std::exchange(waiting[smaller], h);
      }
      half_[h].face = f;
      out_[a] = h;
      if (before.valid()) link(before, h);
      if (!first.valid()) first = h;
      before = h;
    }
    link(before, first);
    first_[f] = first;
  }
  // The outside: a node has one ring, so where several fans of faces meet in it, each is followed by the next.
  struct Fans {
    HalfId first_in, last_out;
  };
  IdVector<NodeId, Fans> fans(n_nodes);
  for (std::size_t i = 0; i < half_.count(); ++i) {
    const HalfId h(i);
    if (half_[h].face.valid()) continue;
    if (!out_[half_[h].tail].valid()) out_[half_[h].tail] = h;
    HalfId g = twin(h);  // turns round the head of h, through the faces of its fan
    while (half_[g].face.valid()) g = twin(half_[g].prev);
    Fans& at = fans[head(h)];
    if (at.last_out.valid()) {
      link(h, at.last_out);
    } else {
      at.first_in = h;
    }
    at.last_out = g;
  }
  for (const Fans& at : fans)
    if (at.first_in.valid()) link(at.first_in, at.last_out);
}

std::array<FaceId, 2> Topology::split_face(FaceId f, NodeId v) {
  const HalfId a = first_[f], b = next(a), c = next(b);
  const EdgeId ea = add_edge(v, tail(a)), eb = add_edge(v, tail(b)), ec = add_edge(v, tail(c));
  const FaceId g = add_face(b), k = add_face(c);
  close_triangle(f, a, half_of(eb, 1), half_of(ea, 0));
  close_triangle(g, b, half_of(ec, 1), half_of(eb, 0));
  close_triangle(k, c, half_of(ea, 1), half_of(ec, 0));
  out_[v] = half_of(ea, 0);
  return {g, k};
}

EdgeId Topology::split_edge(EdgeId e, NodeId v) {
  const HalfId h = half_of(e, 0), t = half_of(e, 1);
  const NodeId b = tail(t);
  const EdgeId rest = add_edge(v, b);
  const HalfId rh = half_of(rest, 0), rt = half_of(rest, 1);
  if (out_[b] == t) out_[b] = rt;
  half_[t].tail = v;
  out_[v] = rh;
  half_[rh].face = half_[h].face;
  half_[rt].face = half_[t].face;
  link(rh, next(h));
  link(h, rh);
  link(prev(t), rt);
  link(rt, t);
  // A triangle has become a quad with v on one of its sides: cut it from v.
  const auto halve = [&](HalfId arriving, HalfId leaving) {
    const FaceId f = half_[arriving].face;
    if (!f.valid()) return;
    const HalfId x = next(leaving), y = next(x);
    QUADLINE_CHECK(next(y) == arriving);
    const EdgeId d = add_edge(v, tail(y));
    const FaceId g = add_face(leaving);
    close_triangle(g, leaving, x, half_of(d, 1));
    close_triangle(f, arriving, half_of(d, 0), y);
  };
  halve(h, rh);
  halve(rt, t);
  return rest;
}

void Topology::swap_edge(EdgeId e) {
  const HalfId h = half_of(e, 0), t = half_of(e, 1);
  const HalfId a = next(h), b = next(a), c = next(t), d = next(c);
  const FaceId f = half_[h].face, g = half_[t].face;
  QUADLINE_CHECK(f.valid() && g.valid() && next(b) == h && next(d) == t);
  const NodeId p = tail(h), q = tail(t);
  if (out_[p] == h) out_[p] = c;
  if (out_[q] == t) out_[q] = a;
  half_[h].tail = tail(d);
  half_[t].tail = tail(b);
  close_triangle(f, h, b, c);
  close_triangle(g, t, d, a);
}

void Topology::unlink_edge(EdgeId e) {
  const HalfId h = half_of(e, 0), t = half_of(e, 1);
  const NodeId a = tail(h), b = tail(t);
  if (out_[a] == h) out_[a] = rotate_ccw(h) == h ? HalfId() : rotate_ccw(h);
  if (out_[b] == t) out_[b] = rotate_ccw(t) == t ? HalfId() : rotate_ccw(t);
  const HalfId before_h = prev(h), after_h = next(h), before_t = prev(t), after_t = next(t);
  link(before_h, after_t);
  link(before_t, after_h);
  free_edge(e);
}

void Topology::remove_face(FaceId f) {
  std::array<HalfId, 4> halves;
  int n = 0;
  for_each_half(f, [&](HalfId h) { halves[n++] = h; });
  for (int i = 0; i < n; ++i) half_[halves[i]].face = FaceId();
  for (int i = 0; i < n; ++i) {
    if (!half_[twin(halves[i])].face.valid()) unlink_edge(edge_of(halves[i]));
  }
  first_[f] = HalfId();
  free_faces_.push_back(f);
}

void Topology::replace_cavity(std::span<const FaceId> faces, std::span<const Polygon> polygons,
                              std::vector<FaceId>& made, std::vector<HalfId>& fresh) {
  std::vector<HalfId>&rim = scratch_.rim, &open = scratch_.open;
  std::vector<EdgeId>& inside = scratch_.inside;
  std::vector<NodeId>& nodes = scratch_.nodes;
  // Half-edges of the cavity whose twin lies outside it, each waits for a polygon; second sides of new edges; new ones.
  for (std::vector<HalfId>* halves : {&rim, &open, &fresh}) halves->clear();
  inside.clear();  // edges with both sides in the cavity
  nodes.clear();
  for (const FaceId f : faces) for_each_half(f, [&](HalfId h) { half_[h].face = kInCavity; });
  for (const FaceId f : faces) {
    for_each_half(f, [&](HalfId h) {
      nodes.push_back(tail(h));
      out_[tail(h)] = HalfId();
      if (half_[twin(h)].face != kInCavity) {
        rim.push_back(h);
      } else if (h < twin(h)) {
        inside.push_back(edge_of(h));
      }
    });
    first_[f] = HalfId();
    free_faces_.push_back(f);
  }
  for (const HalfId h : rim) out_[tail(h)] = h;
  for (const EdgeId e : inside) free_edge(e);

  const auto take = [this](std::vector<HalfId>& waiting, NodeId a, NodeId b) {
    for (std::size_t i = 0; i < waiting.size(); ++i) {
      const HalfId h = waiting[i];
      if (tail(h) != a || head(h) != b) continue;
      waiting[i] = waiting.back();
      waiting.pop_back();
      return h;
    }
    return HalfId();
  };
  made.clear();
  for (const Polygon& p : polygons) {
    std::array<HalfId, 4> side;
    for (int i = 0; i < p.n; ++i) {
      const NodeId a = p.nodes[i], b = p.nodes[(i + 1) % p.n];
      side[i] = take(rim, a, b);
      if (!side[i].valid()) side[i] = take(open, a, b);
      if (side[i].valid()) continue;
      side[i] = half_of(add_edge(a, b));
      open.push_back(twin(side[i]));
      fresh.push_back(side[i]);
    }
    const FaceId f = add_face(side[0]);
    for (int i = 0; i < p.n; ++i) {
      link(side[i], side[(i + 1) % p.n]);
      half_[side[i]].face = f;
      out_[tail(side[i])] = side[i];
    }
    made.push_back(f);
  }
  QUADLINE_CHECK(rim.empty() && open.empty());  // the polygons fill the boundary of the cavity
  for (const NodeId v : nodes)
    if (out_[v] == HalfId()) remove_node(v);
}

Topology::Renumbering Topology::compact() {
  Renumbering map{IdVector<NodeId, NodeId>(node_capacity()), IdVector<EdgeId, EdgeId>(edge_capacity()),
                  IdVector<FaceId, FaceId>(face_capacity())};
  std::size_t n_nodes = 0, n_edges = 0, n_faces = 0;
  for (const NodeId v : nodes()) map.node[v] = NodeId(n_nodes++);
  for (const EdgeId e : edges()) map.edge[e] = EdgeId(n_edges++);
  for (const FaceId f : faces()) map.face[f] = FaceId(n_faces++);

  apply(map, n_nodes, n_edges, n_faces);
  return map;
}

Topology::Renumbering Topology::reorder(std::span<const FaceId> order) {
  Renumbering map{IdVector<NodeId, NodeId>(node_capacity()), IdVector<EdgeId, EdgeId>(edge_capacity()),
                  IdVector<FaceId, FaceId>(face_capacity())};
  std::size_t n_nodes = 0, n_edges = 0, n_faces = 0;
  for (const FaceId f : order) {
    QUADLINE_CHECK(is_live(f) && !map.face[f].valid());
    map.face[f] = FaceId(n_faces++);
    for_each_half(f, [&](HalfId h) {
      if (!map.edge[edge_of(h)].valid()) map.edge[edge_of(h)] = EdgeId(n_edges++);
      if (!map.node[tail(h)].valid()) map.node[tail(h)] = NodeId(n_nodes++);
    });
  }
  for (const NodeId v : nodes())  // isolated ones
    if (!map.node[v].valid()) map.node[v] = NodeId(n_nodes++);
  QUADLINE_CHECK(n_faces == face_count() && n_edges == edge_count() && n_nodes == node_count());
  apply(map, n_nodes, n_edges, n_faces);
  return map;
}

void Topology::apply(const Renumbering& map, std::size_t n_nodes, std::size_t n_edges, std::size_t n_faces) {
  const auto moved = [&](HalfId h) { return h.valid() ? half_of(map.edge[edge_of(h)], h.value & 1) : HalfId(); };
  IdVector<HalfId, Half> halves(2 * n_edges);
  IdVector<NodeId, HalfId> out(n_nodes);
  IdVector<FaceId, HalfId> first(n_faces);
  for (const NodeId v : nodes())
    if (const NodeId to = map.node[v]; to.valid()) out[to] = moved(out_[v]);
  for (const EdgeId e : edges()) {
    const EdgeId to = map.edge[e];
    if (!to.valid()) continue;
    for (int side = 0; side < 2; ++side) {
      const Half& h = half_[half_of(e, side)];
      halves[half_of(to, side)] = {map.node[h.tail], moved(h.next), moved(h.prev),
                                   h.face.valid() ? map.face[h.face] : FaceId()};
    }
  }
  for (const FaceId f : faces())
    if (const FaceId to = map.face[f]; to.valid()) first[to] = moved(first_[f]);
  half_ = std::move(halves);
  out_ = std::move(out);
  first_ = std::move(first);
  free_nodes_.clear();
  free_edges_.clear();
  free_faces_.clear();
}

const char* Topology::defect() const {
  const char* text = defect_of_halves();
  if (!text) text = defect_of_faces();
  return text ? text : defect_of_nodes();
}

const char* Topology::defect_of_halves() const {
  for (const EdgeId e : edges()) {
    for (const HalfId h : {half_of(e, 0), half_of(e, 1)}) {
      const Half& a = half_[h];
      if (!is_live(a.tail)) return "a half-edge starts at a deleted node";
      if (tail(h) == head(h)) return "an edge joins a node to itself";
      if (half_[a.next].prev != h || half_[a.prev].next != h) return "next and prev disagree";
      if (tail(a.next) != head(h)) return "next does not start at the head";
      if (half_[a.next].face != a.face) return "a face changes along its half-edges";
      if (!a.face.valid() && !half_[twin(h)].face.valid()) return "an edge has no face";
    }
  }
  return nullptr;
}

const char* Topology::defect_of_faces() const {
  for (const FaceId f : faces()) {
    const HalfId h = first_[f];
    if (half_[h].face != f) return "the first half-edge of a face is not its own";
    const HalfId third = next(next(next(h)));
    if (third != h && next(third) != h) return "a face has neither three nor four sides";
    const Polygon p = polygon(f);
    for (int a = 0; a < p.n; ++a)
      for (int b = a + 1; b < p.n; ++b)
        if (p.nodes[a] == p.nodes[b]) return "a face meets a node twice";
  }
  return nullptr;
}

const char* Topology::defect_of_nodes() const {
  IdVector<NodeId, std::uint32_t> outgoing(node_capacity(), 0);
  for (const EdgeId e : edges())
    for (const HalfId h : {half_of(e, 0), half_of(e, 1)}) ++outgoing[tail(h)];
  for (const NodeId v : nodes()) {
    if (out_[v] == HalfId()) continue;
    if (!is_live(edge_of(out_[v])) || tail(out_[v]) != v) return "the outgoing half-edge of a node is not its own";
    std::uint32_t n = 0;
    for_each_out(v, [&](HalfId) { ++n; });
    if (n != outgoing[v]) return "the half-edges of a node are not one ring";
  }
  return nullptr;
}

}  // namespace quadline
