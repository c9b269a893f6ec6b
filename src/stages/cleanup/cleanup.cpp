// Topological clean-up [Kinney1997, Canann1998] by re-meshing small cavities [Reberol2021]. Every edit is tried beside
// the mesh, smoothed, and kept only if the measure (valence costs, and much more for what is not convex) falls and the
// least quality does not. As the measure is a whole number, clean-up ends. We differ: one mechanism for all patterns;
// valences are those of sectors; edits must keep the size.
#include "stages/cleanup/cleanup.hpp"

#include <algorithm>
#include <queue>

#include "stages/cleanup/shapes.hpp"
#include "stages/cleanup/templates.hpp"
#include "stages/cleanup/trial.hpp"

namespace quadline {

namespace cleanup {
namespace {

constexpr int kFirstSweeps = 3;  // of smoothing before anything is judged
constexpr int kTrialSweeps = 5;
constexpr double kFloor = 0.25;  // an edit may lower the least scaled Jacobian by kMayLose, but not below this
constexpr double kMayLose = 0.1;
constexpr std::size_t kTries = 3;        // replacements tried per cavity
constexpr std::size_t kTriesBroken = 8;  // where something must be mended

class CleanUp {
 public:
  CleanUp(WorkMesh& mesh, const SizeField& field)
      : mesh_(mesh), sectors_(mesh), finder_(mesh, sectors_), trial_(mesh, size_) {
    const Topology& topo = mesh.topo();
    size_.grow(topo.node_capacity());
    for (std::size_t i = 0; i < topo.node_capacity(); ++i)
      if (topo.is_live(NodeId(i))) size_[NodeId(i)] = field.at(mesh.point(NodeId(i)));
  }

  void run(Context& context) {
    for (int sweep = 0; sweep < kFirstSweeps; ++sweep) smooth_all();
    fill_queue();
    const std::size_t n_start = std::max<std::size_t>(1, queue_.size());
    for (std::size_t n = 0; !queue_.empty(); ++n) {
      if (n % 256 == 0) context.progress("clean-up", 1 - std::min(1.0, double(queue_.size()) / double(n_start)));
      const Entry entry = queue_.top();
      queue_.pop();
      if (!mesh_.topo().is_live(entry.node) || queued_[entry.node] == 0) continue;
      queued_[entry.node] = 0;
      improve(entry.node);
    }
    mesh_.compact();
  }

 private:
  struct Entry {
    int cost;
    NodeId node;
    bool operator<(const Entry& o) const { return cost != o.cost ? cost < o.cost : node > o.node; }
  };
  struct Outcome {
    int before = 0, after = 0;
    PatchQuality quality;
  };

  void smooth_all() {
    const Topology& topo = mesh_.topo();
    std::vector<StarQuad> star;
    for (std::size_t i = 0; i < topo.node_capacity(); ++i) {
      const NodeId v(i);
      if (!topo.is_live(v) || !mesh_.is_free(v)) continue;
      star.clear();
      topo.for_each_out(v, [&](HalfId h) {
        const HalfId n = topo.next(h);
        star.push_back({mesh_.point(topo.head(h)), mesh_.point(topo.head(n)), mesh_.point(topo.tail(topo.prev(h)))});
      });
      mesh_.move(v, better_place(mesh_.point(v), star));
    }
  }

  void push(NodeId v, int cost) {
    queued_.grow(mesh_.topo().node_capacity(), 0);
    if (cost == 0 || queued_[v] != 0) return;
    queued_[v] = 1;
    queue_.push({cost, v});
  }

  int cost_with_quads(NodeId v) const {
    int cost = sectors_.cost(v);
    mesh_.topo().for_each_out(v, [&](HalfId h) {
      if (const FaceId f = mesh_.topo().face(h); f.valid() && is_broken(f)) cost += kBroken;
    });
    return cost;
  }
  bool is_broken(FaceId f) const { return scaled_jacobian(mesh_.quad_points(f)) < kFlatQuad; }

  void fill_queue() {
    const Topology& topo = mesh_.topo();
    for (std::size_t i = 0; i < topo.node_capacity(); ++i)
      if (topo.is_live(NodeId(i))) push(NodeId(i), cost_with_quads(NodeId(i)));
  }

  void improve(NodeId v) {
    const int cost = cost_with_quads(v);
    if (cost == 0) return;
    for (const Shape& shape : shapes()) {
      sets_.clear();
      shape.propose(mesh_, v, sets_);
      for (std::size_t i = 0; i < sets_.count(); ++i)
        if (try_cavity(sets_[i])) return;
    }
  }

  bool try_cavity(std::span<const FaceId> faces) {
    if (!finder_.collect(faces, cavity_)) return false;
    int broken = 0;
    for (const FaceId f : faces) broken += is_broken(f);
    if (broken == 0 && cavity_.cost <= least_cost()) return false;
    costs_.clear();
    for (const Cavity::RimNode& r : cavity_.rim) {
      TemplateTable::RimCosts c{};
      for (int q = 1; q <= TemplateTable::kMaxRimQuads; ++q) c[q] = valence_cost(r.wish, r.outside + q);
      costs_.push_back(c);
    }
    const bool must = broken > 0 || cavity_.cost >= kBroken;
    table_.find(costs_, cavity_.cost + kBroken * broken, must ? kTriesBroken : kTries, matches_);
    for (const TemplateTable::Match& m : matches_) {
      replacement_.inner.assign(m.way->n_inner, NodeId());
      for (std::size_t i = 0; i < cavity_.inner.size() && i < replacement_.inner.size(); ++i)
        replacement_.inner[i] = cavity_.inner[i];
      replacement_.quads.assign(m.way->quads.begin(), m.way->quads.begin() + m.way->n_quads);
      if (try_replacement(m.cost)) return true;
    }
    return false;
  }

  // What no filling can go below: the sum of the signed differences is the same for all.
  int least_cost() const {
    int sum = 0;
    for (const Cavity::RimNode& r : cavity_.rim) {
      if (r.wish.second != 0) return 0;
      sum += r.wish.ideal - r.inside - r.outside;
    }
    for (const NodeId v : cavity_.inner) sum += 4 - mesh_.topo().edge_valence(v);
    return std::abs(sum);
  }

  bool try_replacement(int cost_after) {
    if (!trial_.build(cavity_, replacement_)) return false;
    const PatchQuality now = trial_.quality_now();
    trial_.smooth(kTrialSweeps);
    const PatchQuality then = trial_.quality();
    const int before = cavity_.cost + kBroken * now.n_broken, after = cost_after + kBroken * then.n_broken;
    if (after >= before) return false;
    if (before - after < kBroken / 2) {
      if (then.least_jacobian < std::min(now.least_jacobian, std::max(kFloor, now.least_jacobian - kMayLose)))
        return false;
      if (then.size_error > std::max(1.0, now.size_error)) return false;
    }
    trial_.commit(mesh_, size_, nodes_);
    requeue();
    return true;
  }

  void requeue() {
    const Topology& topo = mesh_.topo();
    for (const NodeId v : nodes_) {
      push(v, cost_with_quads(v));
      topo.for_each_out(v, [&](HalfId h) { push(topo.head(h), cost_with_quads(topo.head(h))); });
    }
  }

  WorkMesh& mesh_;
  Sectors sectors_;
  IdVector<NodeId, double> size_;
  CavityFinder finder_;
  Trial trial_;
  TemplateTable table_;
  std::priority_queue<Entry> queue_;
  IdVector<NodeId, std::uint8_t> queued_;
  Cavity cavity_;
  Replacement replacement_;
  FaceSets sets_;
  std::vector<TemplateTable::RimCosts> costs_;
  std::vector<TemplateTable::Match> matches_;
  std::vector<NodeId> nodes_;
};

}  // namespace
}  // namespace cleanup

void clean_up(WorkMesh& mesh, const SizeField& size, Context& context) { cleanup::CleanUp(mesh, size).run(context); }

}  // namespace quadline
