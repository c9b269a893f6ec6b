// A rim node wants as many quads inside as it lacks outside: one makes a corner, two a straight side, three a notch
// that the patch grows over [Bunin2006, Reberol2021].
#include "stages/cleanup/grow_patch.hpp"

#include <algorithm>

namespace quadline::cleanup {

namespace {

constexpr std::size_t kMostFaces = 150;
constexpr int kMostRows = 20;
constexpr int kMostStars = 40;  // taken in to make a patch convex again

int wanted_inside(const Cavity::RimNode& r) { return r.ideal.ideal - r.outside; }

}  // namespace

void PatchGrower::add_face(FaceId f) {
  mark_of_.grow(mesh_.topo().face_capacity(), 0);
  if (mark_of_[f] == mark_) return;
  mark_of_[f] = mark_;
  faces_.push_back(f);
}

// All quads of the sector of v that the half-edge leads into.
void PatchGrower::add_star(NodeId v, HalfId in_sector) {
  const Topology& topo = mesh_.topo();
  if (mesh_.is_free(v)) {
    topo.for_each_out(v, [&](HalfId h) { add_face(topo.face(h)); });
    return;
  }
  HalfId h = in_sector;
  while (!mesh_.is_constraint(h)) {
    h = topo.rotate_cw(h);
    if (h == in_sector) return;
  }
  do {
    add_face(topo.face(h));
    h = topo.rotate_ccw(h);
  } while (!mesh_.is_constraint(h));
}

bool PatchGrower::start(NodeId v) {
  ++mark_;
  n_rows_ = 0;
  faces_.clear();
  center_ = mesh_.point(v);
  add_star(v, mesh_.topo().out(v));
  return !faces_.empty() && make_convex();
}

bool PatchGrower::make_convex() {
  for (int step = 0; step < kMostStars; ++step) {
    if (faces_.size() > kMostFaces || !finder_.collect(faces_, cavity_)) return false;
    bool has_notch = false;
    for (const Cavity::RimNode& r : cavity_.rim) {
      if (wanted_inside(r) < 3) continue;
      if (r.outside == 0) return false;  // a corner of the domain that looks into the patch
      has_notch = true;
      add_star(r.node, r.half);
    }
    if (!has_notch) {
      describe_rim();
      return true;
    }
  }
  return false;
}

void PatchGrower::describe_rim() {
  rim_.clear();
  n_corners_ = rim_cost_ = 0;
  for (const Cavity::RimNode& r : cavity_.rim) {
    const bool is_corner = wanted_inside(r) < 2;
    rim_.push_back({mesh_.point(r.node), size_[r.node], is_corner});
    n_corners_ += is_corner;
    rim_cost_ += valence_cost(r.ideal, r.outside + (is_corner ? 1 : 2));
  }
}

bool PatchGrower::add_row(std::size_t from, std::size_t to) {
  const Topology& topo = mesh_.topo();
  for (std::size_t p = from; p < to; ++p)
    if (mesh_.can_cross(cavity_.rim[p % cavity_.rim.size()].half) != Refusal::None) return false;
  for (std::size_t p = from; p < to; ++p) add_face(topo.face(twin(cavity_.rim[p % cavity_.rim.size()].half)));
  return true;
}

// Takes the row along the side that lies nearest to the start, so that the patch grows round it.
bool PatchGrower::grow() {
  if (++n_rows_ > kMostRows) return false;
  const std::size_t n = rim_.size();
  corners_.clear();
  for (std::size_t i = 0; i < n; ++i)
    if (rim_[i].is_corner) corners_.push_back(i);
  if (corners_.size() < 2) return false;
  sides_.clear();
  for (std::size_t i = 0; i < corners_.size(); ++i) {
    const std::size_t from = corners_[i], to = i + 1 < corners_.size() ? corners_[i + 1] : corners_[0] + n;
    const Point middle = midpoint(rim_[((from + to) / 2) % n].at, rim_[((from + to + 1) / 2) % n].at);
    sides_.push_back({distance(middle, center_), from, to});
  }
  std::sort(sides_.begin(), sides_.end(), [](const Side& a, const Side& b) {
    return a.distance != b.distance ? a.distance < b.distance : a.from < b.from;
  });
  kept_ = faces_;
  for (const Side& side : sides_) {
    if (!add_row(side.from, side.to)) continue;
    if (make_convex()) return true;
    // Not that way: back to the patch as it was.
    for (const FaceId f : faces_) mark_of_[f] = 0;
    faces_.clear();
    for (const FaceId f : kept_) add_face(f);
    if (!finder_.collect(faces_, cavity_)) return false;
    describe_rim();
  }
  return false;
}

}  // namespace quadline::cleanup
