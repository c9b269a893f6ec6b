// The table of cavities. What the literature draws as single cases [Kinney1997, Canann1998] are fillings of few shapes:
// a doublet is a full fan of two quads, an edge rotation a pair, a diagonal collapse or a vertex split a star.
#include "stages/cleanup/shapes.hpp"

#include <algorithm>

namespace quadline::cleanup {

namespace {

bool can_cross(const WorkMesh& mesh, HalfId h) { return mesh.can_cross(h) == Refusal::None; }

// The two quads beside each edge of the node: edge rotation, and three or four quads in the place of two.
void spokes(const WorkMesh& mesh, NodeId v, FaceSets& sets) {
  const Topology& topo = mesh.topo();
  topo.for_each_out(v, [&](HalfId h) {
    if (!can_cross(mesh, h) || !topo.face(h).valid()) return;
    sets.begin();
    sets.add(topo.face(h));
    sets.add(topo.face(twin(h)));
    sets.end();
  });
}

// A quad of the node with the quad across one of its two far sides: gives the node one more edge.
void links(const WorkMesh& mesh, NodeId v, FaceSets& sets) {
  const Topology& topo = mesh.topo();
  topo.for_each_out(v, [&](HalfId h) {
    const FaceId f = topo.face(h);
    if (!f.valid()) return;
    for (HalfId far : {topo.next(h), topo.prev(topo.prev(h))}) {
      if (!can_cross(mesh, far)) continue;
      sets.begin();
      sets.add(f);
      sets.add(topo.face(twin(far)));
      sets.end();
    }
  });
}

// Runs of three and more consecutive quads of the node, and all of them: doublets, collapse, vertex split.
void fans(const WorkMesh& mesh, NodeId v, FaceSets& sets) {
  const Topology& topo = mesh.topo();
  const int valence = topo.edge_valence(v);
  topo.for_each_out(v, [&](HalfId first) {
    if (!topo.face(first).valid()) return;
    sets.begin();
    sets.add(topo.face(first));
    HalfId h = first;
    for (int n = 2; n <= valence; ++n) {
      h = topo.rotate_ccw(h);
      if (h == first || !can_cross(mesh, h) || !topo.face(h).valid()) break;
      sets.add(topo.face(h));
      if (n < 3 && n < valence) continue;
      if (n == valence && first != topo.out(v)) break;  // the whole star once
      sets.end_and_repeat();
    }
    sets.drop();
  });
}

// The stars of two nodes together, of those that are free.
void stars(const WorkMesh& mesh, NodeId v, NodeId u, FaceSets& sets) {
  if (!mesh.is_free(v) && !mesh.is_free(u)) return;
  sets.begin();
  for (const NodeId w : {v, u}) {
    if (!mesh.is_free(w)) continue;
    mesh.topo().for_each_out(w, [&](HalfId spoke) { sets.add(mesh.topo().face(spoke)); });
  }
  sets.end();
}

// The stars of the node and of one neighbour: pairs of irregular nodes, diamonds.
void edge_stars(const WorkMesh& mesh, NodeId v, FaceSets& sets) {
  const Topology& topo = mesh.topo();
  topo.for_each_out(v, [&](HalfId h) { stars(mesh, v, topo.head(h), sets); });
}

// The stars of the node and of the node across a quad: pairs along a diagonal.
void diagonal_stars(const WorkMesh& mesh, NodeId v, FaceSets& sets) {
  const Topology& topo = mesh.topo();
  topo.for_each_out(v, [&](HalfId h) {
    if (topo.face(h).valid()) stars(mesh, v, topo.tail(topo.next(topo.next(h))), sets);
  });
}

// A run of two quads of the node and the quads across their far sides, one side or two neighbouring ones.
void grown_pairs(const WorkMesh& mesh, NodeId v, FaceSets& sets) {
  const Topology& topo = mesh.topo();
  topo.for_each_out(v, [&](HalfId h) {
    if (!can_cross(mesh, h) || !topo.face(h).valid()) return;
    const HalfId t = twin(h);
    const HalfId far[] = {topo.next(h), topo.next(topo.next(h)), topo.next(topo.next(t)), topo.prev(t)};
    for (int i = 0; i < 4; ++i) {
      if (!can_cross(mesh, far[i])) continue;
      for (int j = i; j < 4; ++j) {
        if (!can_cross(mesh, far[j])) continue;
        sets.begin();
        sets.add(topo.face(h));
        sets.add(topo.face(t));
        sets.add(topo.face(twin(far[i])));
        sets.add(topo.face(twin(far[j])));
        sets.end();
      }
    }
  });
}

// Each quad of the node alone: five in the place of one, where a cell has nothing else to give.
void single_quads(const WorkMesh& mesh, NodeId v, FaceSets& sets) {
  const Topology& topo = mesh.topo();
  topo.for_each_out(v, [&](HalfId h) {
    if (!topo.face(h).valid()) return;
    sets.begin();
    sets.add(topo.face(h));
    sets.end();
  });
}

constexpr Shape kShapes[] = {
    {"pair at a spoke", spokes},       // rotation, 3-5 pairs, sectors with a quad too many
    {"pair at a link", links},         // sectors with a quad too few
    {"fan", fans},                     // doublet, collapse, split
    {"stars of an edge", edge_stars},  // 3-3, 3-5, 5-5 neighbours
    {"grown pair", grown_pairs},       // boundary and line patterns
    {"stars of a diagonal", diagonal_stars},
    {"quad", single_quads},
};

}  // namespace

void FaceSets::add(FaceId f) {
  const auto set = current();
  if (std::find(set.begin(), set.end(), f) == set.end()) faces_.push_back(f);
}

void FaceSets::end_and_repeat() {
  const std::size_t n = current().size();
  end();
  begin();
  faces_.resize(start_ + n);
  std::copy_n(faces_.data() + start_ - n, n, faces_.data() + start_);
}

std::span<const Shape> shapes() { return kShapes; }

}  // namespace quadline::cleanup
