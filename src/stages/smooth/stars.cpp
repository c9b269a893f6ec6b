#include "stages/smooth/stars.hpp"

#include <algorithm>
#include <cmath>

#include "geom/element.hpp"
#include "quality/limits.hpp"

namespace quadline::smoothing {

namespace {

constexpr double kLeastGap = 0.3;  // of the way between two neighbours on a curve: how near a node may slide to one
constexpr std::size_t kFewAwake = 16;

bool is_beside_broken(const WorkMesh& mesh, NodeId v) {
  bool is_broken = false;
  mesh.topo().for_each_out(v, [&](HalfId h) {
    const FaceId f = mesh.topo().face(h);
    if (f.valid()) is_broken |= scaled_jacobian(mesh.quad_points(f)) < kBrokenJacobian;
  });
  return is_broken;
}

}  // namespace

Stars::Stars(const WorkMesh& mesh, const Domain& domain, const SizeField& size, bool slides) : domain_(domain) {
  const Topology& topo = mesh.topo();
  star_of_.assign(topo.node_capacity(), kNone);
  point_.resize(topo.node_capacity());
  first_.push_back(0);
  for (const NodeId v : topo.nodes()) {
    point_[v.value] = mesh.point(v);
    if (mesh.is_free(v) || (slides && add_slide(mesh, v))) add_star(mesh, v, size);
  }
  limit_slides();
  find_beyond();
  awake_.assign(node_.size(), 0);
}

void Stars::add_star(const WorkMesh& mesh, NodeId v, const SizeField& size) {
  const Topology& topo = mesh.topo();
  star_of_[v.value] = static_cast<std::uint32_t>(node_.size());
  node_.push_back(v.value);
  slide_of_.push_back(mesh.is_free(v) ? kNone : static_cast<std::uint32_t>(slides_.size() - 1));
  size_.push_back(size.at(mesh.point(v)));
  topo.for_each_out(v, [&](HalfId h) {
    if (!topo.face(h).valid()) return;
    const HalfId b = topo.next(h), c = topo.next(b);
    spokes_.push_back({topo.tail(b).value, topo.tail(c).value, topo.head(c).value, kNone});
  });
  first_.push_back(static_cast<std::uint32_t>(spokes_.size()));
}

// False where the node has to stay: at a vertex, on an arc, or beside a curve that is broken. Even chords are what the
// eye sees first on a hole, and long ones would cut its arc short; but a sound quad is worth an uneven one.
bool Stars::add_slide(const WorkMesh& mesh, NodeId v) {
  const NodeTag& tag = mesh.tag(v);
  if (tag.kind != NodeKind::OnCurve || (domain_.curves[tag.curve].piece.is_arc() && !is_beside_broken(mesh, v)))
    return false;
  Slide slide{tag.curve, tag.s, kNone, kNone, 0, length(domain_.curves[tag.curve].piece), 0, 0};
  mesh.topo().for_each_out(v, [&](HalfId h) {
    if (mesh.curve(edge_of(h)) != tag.curve) return;
    const NodeId w = mesh.topo().head(h);
    const NodeTag& other = mesh.tag(w);
    const bool shares_curve = other.curve == tag.curve;
    const bool is_before = shares_curve ? other.s < tag.s : other.vertex == domain_.curves[tag.curve].tail;
    (is_before ? slide.before : slide.after) = w.value;
    if (shares_curve) (is_before ? slide.low : slide.high) = other.s;
  });
  if (slide.before == kNone || slide.after == kNone) return false;
  slides_.push_back(slide);
  return true;
}

void Stars::limit_slides() {
  for (Slide& slide : slides_) {
    slide.least = place_of(slide.before, slide, true);
    slide.most = place_of(slide.after, slide, false);
  }
}

void Stars::find_beyond() {
  for (std::size_t i = 0; i < count(); ++i)
    for (std::uint32_t k = first_[i]; k < first_[i + 1]; ++k) {
      const std::uint32_t star = star_of_[spokes_[k].next];
      if (star == kNone || !is_regular(star)) continue;
      const std::span<const Spoke> round = spokes(star);
      for (std::size_t back = 0; back < 4; ++back)
        if (round[back].next == node_[i]) spokes_[k].beyond = round[(back + 2) % 4].next;
    }
}

double Stars::place_of(std::uint32_t neighbour, const Slide& slide, bool before) const {
  const std::uint32_t star = star_of_[neighbour];
  if (star != kNone && slide_of_[star] != kNone && slides_[slide_of_[star]].curve == slide.curve)
    return slides_[slide_of_[star]].s;
  return before ? slide.low : slide.high;
}

Point Stars::tangent(std::size_t i) const {
  const Slide& slide = slides_[slide_of_[i]];
  const Point t = point_[slide.after] - point_[slide.before];
  return (1 / norm(t)) * t;
}

Stars::Place Stars::slid(std::size_t i, Point p) const {
  const Slide& slide = slides_[slide_of_[i]];
  const CurvePiece& piece = domain_.curves[slide.curve].piece;
  const double low = place_of(slide.before, slide, true), high = place_of(slide.after, slide, false);
  const double gap = std::min(kLeastGap * (high - low), std::min(slide.s - low, high - slide.s));
  const double least = std::max(low + gap, std::min(slide.least, slide.s));
  const double most = std::min(high - gap, std::max(slide.most, slide.s));
  const double s = std::clamp(project(piece, p), std::min(least, most), most);
  return {s, point_at(piece, s)};
}

void Stars::move(std::size_t i, Point p) {
  if (slides(i)) {
    const Place place = slid(i, p);
    slides_[slide_of_[i]].s = place.s;
    p = place.point;
  }
  point_[node_[i]] = p;
}

void Stars::wake_around(std::size_t i) {
  wake(i);
  for (const Spoke& s : spokes(i))
    for (const std::uint32_t v : {s.next, s.opposite, s.previous})
      if (star_of_[v] != kNone) wake(star_of_[v]);
}

void Stars::wake_all() {
  for (std::size_t i = 0; i < count(); ++i) wake(i);
}

std::span<const std::uint32_t> Stars::take_awake() {
  taken_.clear();
  if (list_.size() * kFewAwake < count()) {
    std::sort(list_.begin(), list_.end());
    taken_.swap(list_);
  } else {
    for (std::size_t i = 0; i < count(); ++i)
      if (awake_[i]) taken_.push_back(static_cast<std::uint32_t>(i));
    list_.clear();
  }
  for (const std::uint32_t i : taken_) awake_[i] = 0;
  return taken_;
}

void Stars::store(WorkMesh& mesh) const {
  for (std::size_t i = 0; i < node_.size(); ++i) {
    const NodeId v(node_[i]);
    if (slides(i)) {
      mesh.slide(v, slides_[slide_of_[i]].s, point_[node_[i]]);
    } else {
      mesh.move(v, point_[node_[i]]);
    }
  }
}

}  // namespace quadline::smoothing
