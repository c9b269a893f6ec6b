#include "stages/smooth/stars.hpp"

#include <algorithm>
#include <cmath>

namespace quadline {

namespace {

constexpr std::uint32_t kNone = UINT32_MAX;
constexpr double kLeastGap = 0.42;  // of the way between two neighbours on a curve: how near a node may slide to one

}  // namespace

Stars::Stars(WorkMesh& mesh, const Domain& domain, const SizeField& size) : domain_(domain) {
  const Topology& topo = mesh.topo();
  star_of_.assign(topo.node_capacity(), kNone);
  point_.resize(topo.node_capacity());
  first_.push_back(0);
  for (std::size_t i = 0; i < topo.node_capacity(); ++i) {
    const NodeId v(i);
    if (!topo.is_live(v)) continue;
    point_[i] = mesh.point(v);
    if (mesh.tag(v).kind == NodeKind::Fixed) continue;
    Slide slide;
    if (mesh.tag(v).kind == NodeKind::OnCurve) {
      slide = {mesh.tag(v).curve, mesh.tag(v).s, kNone, kNone};
      topo.for_each_out(v, [&](HalfId h) {
        if (mesh.curve(edge_of(h)) != slide.curve) return;
        const NodeId w = topo.head(h);
        const bool same = mesh.tag(w).kind == NodeKind::OnCurve && mesh.tag(w).curve == slide.curve;
        const bool is_before = same ? mesh.tag(w).s < slide.s : mesh.tag(w).vertex == domain.curves[slide.curve].tail;
        (is_before ? slide.before : slide.after) = w.value;
      });
      if (slide.before == kNone || slide.after == kNone) continue;  // stays
    }
    star_of_[i] = static_cast<std::uint32_t>(node_.size());
    node_.push_back(static_cast<std::uint32_t>(i));
    slide_.push_back(slide);
    size_.push_back(size.at(point_[i]));
    topo.for_each_out(v, [&](HalfId h) {
      if (!topo.face(h).valid()) return;
      const HalfId b = topo.next(h), c = topo.next(b);
      spokes_.push_back({topo.tail(b).value, topo.tail(c).value, topo.head(c).value});
    });
    first_.push_back(static_cast<std::uint32_t>(spokes_.size()));
  }
  awake_.assign(node_.size(), 0);
}

double Stars::place_of(std::uint32_t neighbour, const Slide& slide, bool before) const {
  const std::uint32_t star = star_of_[neighbour];
  if (star != kNone && slide_[star].curve == slide.curve) return slide_[star].s;
  return before ? 0 : length(domain_.curves[slide.curve].piece);
}

Stars::Place Stars::slid(std::size_t i, Point p) const {
  const Slide& slide = slide_[i];
  const CurvePiece& piece = domain_.curves[slide.curve].piece;
  const double low = place_of(slide.before, slide, true), high = place_of(slide.after, slide, false);
  const double gap = std::min(kLeastGap * (high - low), std::min(slide.s - low, high - slide.s));
  const double s = std::clamp(project(piece, p), low + gap, high - gap);
  return {s, point_at(piece, s)};
}

void Stars::move(std::size_t i, Point p) {
  if (slides(i)) {
    const Place place = slid(i, p);
    slide_[i].s = place.s;
    p = place.point;
  }
  point_[node_[i]] = p;
}

void Stars::wake(std::size_t i) {
  awake_[i] = 1;
  for (const Spoke& s : spokes(i))
    for (const std::uint32_t v : {s.next, s.opposite, s.previous})
      if (star_of_[v] != kNone) awake_[star_of_[v]] = 1;
}

void Stars::wake_all() { std::fill(awake_.begin(), awake_.end(), std::uint8_t{1}); }

std::vector<std::uint32_t> Stars::take_awake() {
  std::vector<std::uint32_t> list;
  for (std::size_t i = 0; i < awake_.size(); ++i)
    if (awake_[i]) list.push_back(static_cast<std::uint32_t>(i));
  std::fill(awake_.begin(), awake_.end(), std::uint8_t{0});
  return list;
}

void Stars::store(WorkMesh& mesh) const {
  for (std::size_t i = 0; i < node_.size(); ++i) {
    const NodeId v(node_[i]);
    if (slides(i)) {
      mesh.slide(v, slide_[i].s, point_[node_[i]]);
    } else {
      mesh.move(v, point_[node_[i]]);
    }
  }
}

}  // namespace quadline
