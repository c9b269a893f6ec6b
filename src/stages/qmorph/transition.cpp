// Transition seam and transition split [Owen1999 section 3.4], where neighbouring front edges differ much in length.
// The long edge is halved; of the quad behind it smaller quads remain and a triangle, which the front takes back. We
// differ: the seam is left to the normal step that follows, and a quad made here is never split again, so that the
// front ends.
#include <algorithm>
#include <array>

#include "stages/qmorph/morph.hpp"

namespace quadline {

namespace {

constexpr double kRatio = 2.5;      // of the lengths of two neighbouring front edges [Owen1999]
constexpr double kSoundQuad = 0.3;  // scaled Jacobian of a quad that may be split

Polygon turned(Polygon p, bool mirrored) {
  if (mirrored) std::reverse(p.nodes.begin(), p.nodes.begin() + p.n);
  return p;
}

}  // namespace

bool Morph::transition(const Corner& corner) {
  const Topology& topo = mesh_.topo();
  const double in = mesh_.edge_length(edge_of(corner.in)), out = mesh_.edge_length(edge_of(corner.out));
  if (std::fmax(in, out) < kRatio * std::fmin(in, out) || insertions_ < 2) return false;
  if (corner.quads != 0 && corner.angle >= degrees(180)) return false;
  const bool mirrored = in > out;  // the long edge arrives at the corner instead of leaving it
  const HalfId longer = mirrored ? corner.in : corner.out;
  const FaceId ahead = topo.face(longer), behind = topo.face(twin(longer));
  if (mesh_.can_cross(longer) != Refusal::None || topo.is_triangle(behind)) return false;
  if (scaled_jacobian(mesh_.quad_points(behind)) < kSoundQuad) return false;

  // The quad behind is k, b, d, c; the triangle ahead is k, b, x.
  const NodeId k = corner.node, b = mirrored ? topo.tail(longer) : topo.head(longer);
  const HalfId along = twin(longer);
  const NodeId c = mirrored ? topo.tail(topo.prev(along)) : topo.head(topo.next(along));
  const NodeId d = mirrored ? topo.head(topo.next(along)) : topo.tail(topo.prev(along));
  const NodeId x = topo.head(topo.next(longer));
  for (const NodeId v : {k, b, c, d})
    if (is_transition(v)) return false;

  const int old_level = level(edge_of(longer));
  const NodeId m = mesh_.add_node(midpoint(mesh_.point(k), mesh_.point(b)));
  parity_.forget(m);
  std::vector<Polygon> polygons{turned({k, m, x}, mirrored), turned({m, b, x}, mirrored)};
  std::array<NodeId, 2> made_nodes{m, m};
  if (corner.quads == 0) {  // transition seam
    polygons.push_back(turned({b, m, c, d}, mirrored));
    polygons.push_back(turned({m, k, c}, mirrored));
    parity_.tie(m, k, false);
    ++counts_.transition_seams;
  } else {  // transition split
    const NodeId p = mesh_.add_node(0.25 * (mesh_.point(k) + mesh_.point(b) + mesh_.point(c) + mesh_.point(d)));
    parity_.forget(p);
    made_nodes[1] = p;
    polygons.push_back(turned({k, c, d, p}, mirrored));
    polygons.push_back(turned({d, b, m, p}, mirrored));
    polygons.push_back(turned({m, k, p}, mirrored));
    parity_.tie(p, k, true);
    parity_.tie(m, k, false);
    --insertions_;
    ++counts_.transition_splits;
  }
  --insertions_;
  put_quads({ahead, behind}, polygons, old_level);
  transition_.grow(mesh_.topo().node_capacity(), false);
  for (const NodeId v : made_nodes) transition_[v] = true;
  touched_ = {k, b, c, d, made_nodes[0], made_nodes[1]};
  smooth_around({made_nodes[0], made_nodes[1]});
  return true;
}

}  // namespace quadline
