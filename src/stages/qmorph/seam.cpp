// Seams [Owen1999 section 3.4, Lee2003: below pi/6]: the two front edges of a sharp corner become one. We differ: the
// merged node goes to the place of five tried that is best for its quads, and the seam is refused where a
// triangle ahead would invert.
#include <algorithm>
#include <array>

#include "geom/predicates.hpp"
#include "stages/qmorph/morph.hpp"

namespace quadline {

namespace {

bool contains(const std::vector<FaceId>& faces, FaceId f) {
  return std::find(faces.begin(), faces.end(), f) != faces.end();
}

Polygon renamed(Polygon p, NodeId from, NodeId to) {
  std::replace(p.nodes.begin(), p.nodes.begin() + p.n, from, to);
  return p;
}

// The faces round two nodes as they will be when both are one at `at`: worst quad, or -2 where a triangle inverts.
double worst_after_merge(const WorkMesh& mesh, const std::vector<Polygon>& faces, NodeId merged, Point at) {
  double worst = 1;
  for (const Polygon& f : faces) {
    QuadPoints p{};
    for (int i = 0; i < f.n; ++i) p[i] = f.nodes[i] == merged ? at : mesh.point(f.nodes[i]);
    if (f.n == 3) {
      if (orientation(p[0], p[1], p[2]) <= 0) return -2;
    } else {
      worst = std::fmin(worst, scaled_jacobian(p));
    }
  }
  return worst;
}

}  // namespace

bool Morph::seam(const Corner& corner) {
  const Topology& topo = mesh_.topo();
  NodeId gone = topo.tail(corner.in), stays = topo.head(corner.out);
  if (!mesh_.is_free(gone)) std::swap(gone, stays);
  if (gone == stays || !mesh_.is_free(gone)) return false;
  held_ = EdgeId();
  const HalfId chord = recover_edge(topo.head(corner.out), topo.tail(corner.in));
  if (!chord.valid()) return false;
  std::vector<FaceId> inside;
  if (!enclosed_triangles(corner.out, {edge_of(corner.out), edge_of(chord), edge_of(corner.in)}, inside)) return false;

  // The star of the node that goes, without what closes up
  std::vector<FaceId> cavity = inside;
  std::vector<Polygon> polygons;
  bool possible = true;
  NodeId beyond;  // third corner of the triangle beyond the chord, if it is one
  topo.for_each_out(gone, [&](HalfId h) {
    const FaceId f = topo.face(h);
    if (!f.valid()) possible = false;
    if (!f.valid() || contains(inside, f)) return;
    cavity.push_back(f);
    const Polygon p = topo.polygon(f);
    if (std::find(p.nodes.begin(), p.nodes.begin() + p.n, stays) == p.nodes.begin() + p.n) {
      polygons.push_back(renamed(p, gone, stays));
    } else if (p.n == 4 || beyond.valid()) {
      possible = false;
    } else {
      for (const NodeId v : p.corners())
        if (v != gone && v != stays) beyond = v;
    }
  });
  if (!possible || !beyond.valid()) return false;
  bool double_edge = false;
  topo.for_each_out(gone, [&](HalfId h) {
    const NodeId v = topo.head(h);
    if (v != stays && v != corner.node && v != beyond && topo.find(v, stays).valid()) double_edge = true;
  });
  if (double_edge) return false;

  std::vector<Polygon> around = polygons;
  topo.for_each_out(stays, [&](HalfId h) {
    if (topo.face(h).valid() && !contains(cavity, topo.face(h))) around.push_back(topo.polygon(topo.face(h)));
  });
  const Point g = mesh_.point(gone), s = mesh_.point(stays);
  const int n_places = mesh_.is_free(stays) ? 5 : 1;
  constexpr std::array<double, 5> kPlaces{0, 0.5, 0.25, 0.75, 1};
  double best = -2;
  Point place = s;
  for (int i = 0; i < n_places; ++i) {
    const Point p = s + kPlaces[i] * (g - s);
    const double worst = worst_after_merge(mesh_, around, stays, p);
    if (worst > best) {
      best = worst;
      place = p;
    }
  }
  if (best <= -0.1 || !parity_.tie(gone, stays, false)) return false;

  ++counts_.seams;
  std::vector<std::pair<NodeId, int>> levels;
  topo.for_each_out(gone, [&](HalfId h) { levels.push_back({topo.head(h), level(edge_of(h))}); });
  std::vector<FaceId> made;
  mesh_.replace_cavity(cavity, polygons, made);
  for (const auto& [v, l] : levels)
    if (const HalfId h = v == stays ? HalfId() : topo.find(v, stays); h.valid()) set_level(edge_of(h), l);
  if (mesh_.is_free(stays)) mesh_.move(stays, place);
  touched_ = {corner.node, stays};
  topo.for_each_out(stays, [&](HalfId h) { touched_.push_back(topo.head(h)); });
  smooth_around({corner.node, stays});
  return true;
}

}  // namespace quadline
