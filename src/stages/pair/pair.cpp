// Greedy pairing of triangles by the shape of the quad that they make [Lo1989].
#include "stages/pair/pair.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

namespace quadline {

namespace {

constexpr double kWorstPair = 0.3;  // scaled Jacobian below which two triangles rather stay alone

struct Pair {
  EdgeId edge;
  double worth;  // scaled Jacobian of the quad
};

Polygon merged(const Topology& topo, EdgeId e) {
  const HalfId h = half_of(e, 0), t = half_of(e, 1);
  return {topo.tail(h), topo.tail(topo.prev(t)), topo.tail(t), topo.tail(topo.prev(h))};
}

std::vector<Pair> pairs_of(const WorkMesh& mesh) {
  const Topology& topo = mesh.topo();
  std::vector<Pair> pairs;
  for (const EdgeId e : topo.edges()) {
    if (mesh.can_merge(e) != Refusal::None) continue;
    const Polygon q = merged(topo, e);
    const double worth = scaled_jacobian(
        {mesh.point(q.nodes[0]), mesh.point(q.nodes[1]), mesh.point(q.nodes[2]), mesh.point(q.nodes[3])});
    if (worth > kWorstPair) pairs.push_back({e, worth});
  }
  std::sort(pairs.begin(), pairs.end(),
            [](const Pair& p, const Pair& q) { return p.worth != q.worth ? p.worth > q.worth : p.edge < q.edge; });
  return pairs;
}

}  // namespace

void pair_triangles(WorkMesh& mesh, Context& context) {
  context.progress("pair", 0);
  const Topology& topo = mesh.topo();
  IdVector<FaceId, std::uint8_t> is_taken(topo.face_capacity(), 0);
  std::vector<FaceId> made;
  const std::vector<Pair> pairs = pairs_of(mesh);
  context.progress("pair", 0.5);
  // A merge frees the slot of its edge and of a face, but marks neither as free for others: new quads take only the
  // slots of the two triangles, which are taken.
  for (const Pair& pair : pairs) {
    const FaceId f = topo.face(half_of(pair.edge, 0)), g = topo.face(half_of(pair.edge, 1));
    if (is_taken[f] || is_taken[g]) continue;
    is_taken[f] = is_taken[g] = 1;
    const std::array<Polygon, 1> quad{merged(topo, pair.edge)};
    mesh.replace_cavity(std::array{f, g}, quad, made);
  }
  mesh.sort_in_space();
  context.progress("pair", 1);
}

}  // namespace quadline
