#include "stages/cleanup/cavity.hpp"

#include <cstdlib>

namespace quadline::cleanup {

int least_cost(const Cavity& cavity) {
  int sum = cavity.inner_index;
  for (const Cavity::RimNode& r : cavity.rim) {
    if (r.ideal.second != 0) return 0;
    sum += r.ideal.ideal - r.inside - r.outside;
  }
  return std::abs(sum);
}

int cost_after(const Cavity& cavity, const Replacement& replacement) {
  std::vector<int> quads(cavity.rim.size() + replacement.inner.size(), 0);
  for (const auto& q : replacement.quads)
    for (const auto v : q) ++quads[v];
  int sum = 0;
  for (std::size_t i = 0; i < quads.size(); ++i) {
    const bool is_rim = i < cavity.rim.size();
    sum += is_rim ? valence_cost(cavity.rim[i].ideal, cavity.rim[i].outside + quads[i])
                  : valence_cost(IdealValence{}, quads[i]);
  }
  return sum;
}

bool CavityFinder::collect(std::span<const FaceId> faces, Cavity& cavity) {
  const Topology& topo = mesh_.topo();
  face_mark_.grow(topo.face_capacity(), 0);
  node_mark_.grow(topo.node_capacity(), 0);
  ++mark_;
  cavity.faces.assign(faces.begin(), faces.end());
  cavity.rim.clear();
  cavity.inner.clear();
  cavity.cost = cavity.inner_index = 0;
  for (const FaceId f : faces) face_mark_[f] = mark_;

  HalfId start;
  std::size_t n_rim = 0;
  bool is_cut = false;
  for (const FaceId f : faces) {
    is_cut |= mesh_.can_replace(f) != Refusal::None;
    topo.for_each_half(f, [&](HalfId h) {
      if (!is_inside(twin(h))) {
        ++n_rim;
        start = h;
      } else {
        is_cut |= mesh_.can_cross(h) != Refusal::None;
      }
    });
  }
  if (is_cut || !start.valid() || !walk_rim(start, n_rim, cavity)) return false;

  for (const FaceId f : faces) {
    const Polygon p = topo.polygon(f);
    for (const NodeId v : p.corners()) {
      if (node_mark_[v] == mark_) continue;
      node_mark_[v] = mark_;
      if (!mesh_.is_free(v)) return false;
      cavity.inner.push_back(v);
      const Sector sector = sectors_.at(topo.out(v));
      cavity.cost += valence_cost(sector.ideal, sector.quads);
      cavity.inner_index += 4 - sector.quads;
    }
  }
  return true;
}

// One closed walk along all rim half-edges that meets no node twice.
bool CavityFinder::walk_rim(HalfId start, std::size_t n_rim, Cavity& cavity) {
  const Topology& topo = mesh_.topo();
  HalfId h = start;
  do {
    const NodeId v = topo.tail(h);
    if (node_mark_[v] == mark_) return false;
    node_mark_[v] = mark_;
    Cavity::RimNode node;
    node.node = v;
    node.half = h;
    const Sector sector = sectors_.at(h);
    node.ideal = sector.ideal;
    for (HalfId spoke = h; is_inside(spoke); spoke = topo.rotate_ccw(spoke)) ++node.inside;
    node.outside = sector.quads - node.inside;
    cavity.cost += valence_cost(node.ideal, sector.quads);
    cavity.rim.push_back(node);
    h = topo.next(h);
    while (is_inside(twin(h))) h = topo.next(twin(h));
  } while (h != start);
  return cavity.rim.size() == n_rim;
}

}  // namespace quadline::cleanup
