#include "stages/cleanup/trial.hpp"

#include <algorithm>
#include <cmath>

#include "geom/element.hpp"
#include "quality/limits.hpp"

namespace quadline::cleanup {

namespace {

constexpr double kShortest = 0.4, kLongest = 1.8;  // edge over local size
constexpr int kLaplaceSweeps = 10;
constexpr std::uint32_t kManyNodes = 8;  // from so many on, places are found by over-relaxation
constexpr double kOverRelaxation = 1.5;

// Sums up the quality of quads; the mean beta is the arithmetic one, as a flat quad must not decide alone.
class Measure {
 public:
  void add(const QuadPoints& q, const std::array<double, 4>& size) {
    const double jacobian = scaled_jacobian(q);
    quality_.least_jacobian = std::min(quality_.least_jacobian, jacobian);
    if (jacobian < kBrokenJacobian) ++quality_.n_broken;
    sum_ += jacobian > 0 ? quad_distortion(q) : jacobian;
    ++n_;
    for (int i = 0; i < 4; ++i) {
      const int k = (i + 1) % 4;
      const double ratio = 2 * distance(q[i], q[k]) / (size[i] + size[k]);
      const double shown = std::max(ratio, 1e-9);
      spread_ += shown + 1 / shown - 2;
      quality_.size_error = std::max({quality_.size_error, ratio / kLongest, kShortest / shown});
    }
  }
  PatchQuality result() {
    quality_.n_quads = n_;
    if (n_ > 0) {
      quality_.mean_beta = sum_ / n_;
      quality_.size_spread = spread_ / (4 * n_);
    }
    return quality_;
  }

 private:
  PatchQuality quality_;
  double sum_ = 0, spread_ = 0;
  int n_ = 0;
};

}  // namespace

std::uint32_t Trial::local(NodeId v) {
  Slot& at = slot_[v];
  if (at.mark != mark_) {
    at = {mark_, static_cast<std::uint32_t>(nodes_.size())};
    nodes_.push_back({v, mesh_.point(v), size_[v], false});
  }
  return at.index;
}

bool Trial::build(const Cavity& cavity, const Replacement& replacement) {
  ++mark_;
  slot_.grow(mesh_.topo().node_capacity());
  cavity_ = &cavity;
  nodes_.clear();
  quads_.clear();
  ring_.clear();
  n_rim_ = static_cast<std::uint32_t>(cavity.rim.size());
  Point sum;
  double size = 0;
  for (const Cavity::RimNode& r : cavity.rim) {
    nodes_[local(r.node)].may_move = mesh_.is_free(r.node);
    sum += mesh_.point(r.node);
    size += size_[r.node];
  }
  const double each = 1.0 / n_rim_;
  for (const NodeId v : replacement.inner) {
    if (v.valid()) slot_[v] = {mark_, static_cast<std::uint32_t>(nodes_.size())};
    nodes_.push_back({v, each * sum, each * size, true});
  }
  n_own_ = static_cast<std::uint32_t>(nodes_.size());
  for (const auto& q : replacement.quads) quads_.push_back({q[0], q[1], q[2], q[3]});
  n_own_quads_ = quads_.size();
  if (duplicates_an_edge()) return false;
  add_ring();
  make_stars();
  place_inner_nodes();
  return true;
}

// An edge across the cavity between two rim nodes must not stand outside it already.
bool Trial::duplicates_an_edge() const {
  const Topology& topo = mesh_.topo();
  for (const Quad& q : quads_) {
    for (int i = 0; i < 4; ++i) {
      const std::uint32_t a = q[i], b = q[(i + 1) % 4];
      if (a >= n_rim_ || b >= n_rim_ || (a + 1) % n_rim_ == b) continue;
      if ((b + 1) % n_rim_ == a) return true;  // clockwise along the rim: it has a second edge there
      const HalfId h = topo.find(nodes_[a].id, nodes_[b].id);
      if (!h.valid()) continue;
      const auto is_inside = [&](FaceId f) {
        return std::find(cavity_->faces.begin(), cavity_->faces.end(), f) != cavity_->faces.end();
      };
      if (!is_inside(topo.face(h)) || !is_inside(topo.face(twin(h)))) return true;
    }
  }
  return false;
}

void Trial::add_ring() {
  const Topology& topo = mesh_.topo();
  face_mark_.grow(topo.face_capacity(), 0);
  for (const FaceId f : cavity_->faces) face_mark_[f] = mark_;
  for (std::uint32_t i = 0; i < n_rim_; ++i) {
    if (!nodes_[i].may_move) continue;
    topo.for_each_out(nodes_[i].id, [&](HalfId h) {
      const FaceId f = topo.face(h);
      if (face_mark_[f] == mark_) return;
      face_mark_[f] = mark_;
      ring_.push_back(f);
      const Polygon p = topo.polygon(f);
      Quad q;
      for (int k = 0; k < 4; ++k) q[k] = local(p.nodes[k]);
      quads_.push_back(q);
    });
  }
}

// The quads round each node that may move, one after the other.
void Trial::make_stars() {
  stars_.fill(nodes_.size(), [&](const auto& visit) {
    for (const Quad& q : quads_)
      for (int k = 0; k < 4; ++k)
        if (nodes_[q[k]].may_move) visit(q[k], StarEntry{q[(k + 1) % 4], q[(k + 2) % 4], q[(k + 3) % 4]});
  });
}

void Trial::place_inner_nodes() {
  if (n_own_ == n_rim_) return;
  const std::uint32_t n_inner = n_own_ - n_rim_;
  const int sweeps = kLaplaceSweeps + static_cast<int>(3 * std::sqrt(n_inner));
  const double relax = n_inner < kManyNodes ? 1 : kOverRelaxation;
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    for (std::uint32_t v = n_rim_; v < n_own_; ++v) {
      Point sum;
      for (const StarEntry& quad : stars_[v]) sum += nodes_[quad.next].at + nodes_[quad.previous].at;
      const Point mean = (0.5 / static_cast<double>(stars_[v].size())) * sum;
      nodes_[v].at += relax * (mean - nodes_[v].at);
    }
  }
}

void Trial::smooth(int sweeps) {
  const auto step = [&](std::uint32_t v) {
    if (!nodes_[v].may_move) return;
    star_quads_.clear();
    for (const StarEntry& quad : stars_[v])
      star_quads_.push_back({nodes_[quad.next].at, nodes_[quad.opposite].at, nodes_[quad.previous].at});
    nodes_[v].at = better_place(nodes_[v].at, star_quads_, nodes_[v].size);
  };
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    for (std::uint32_t v = n_rim_; v < n_own_; ++v) step(v);
    for (std::uint32_t v = 0; v < n_rim_; ++v) step(v);
  }
}

PatchQuality Trial::quality_now() const {
  Measure measure;
  const auto add = [&](FaceId f) {
    const Polygon p = mesh_.topo().polygon(f);
    const auto& n = p.nodes;
    measure.add(mesh_.quad_points(f), {size_[n[0]], size_[n[1]], size_[n[2]], size_[n[3]]});
  };
  for (const FaceId f : cavity_->faces) add(f);
  for (const FaceId f : ring_) add(f);
  return measure.result();
}

PatchQuality Trial::quality() const {
  Measure measure;
  for (const Quad& q : quads_) {
    const Node &a = nodes_[q[0]], &b = nodes_[q[1]], &c = nodes_[q[2]], &d = nodes_[q[3]];
    measure.add({a.at, b.at, c.at, d.at}, {a.size, b.size, c.size, d.size});
  }
  return measure.result();
}

void Trial::commit(WorkMesh& mesh, IdVector<NodeId, double>& size, std::vector<NodeId>& nodes) {
  nodes.clear();
  for (std::uint32_t i = 0; i < n_own_; ++i) {
    Node& node = nodes_[i];
    if (!node.id.valid()) node.id = mesh.add_node(node.at);
    nodes.push_back(node.id);
  }
  polygons_.clear();
  for (std::size_t i = 0; i < n_own_quads_; ++i) {
    const Quad& q = quads_[i];
    polygons_.emplace_back(nodes[q[0]], nodes[q[1]], nodes[q[2]], nodes[q[3]]);
  }
  mesh.replace_cavity(cavity_->faces, polygons_, made_);
  size.grow(mesh.topo().node_capacity());
  for (std::uint32_t i = 0; i < n_own_; ++i) {
    if (nodes_[i].may_move) mesh.move(nodes[i], nodes_[i].at);
    size[nodes[i]] = nodes_[i].size;
  }
}

}  // namespace quadline::cleanup
