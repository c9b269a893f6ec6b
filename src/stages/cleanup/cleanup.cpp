// Topological clean-up [Kinney1997, Canann1998] by re-meshing cavities [Reberol2021, Bunin2006]. Every edit is tried
// beside the mesh, smoothed, and kept only if the measure (valence costs, and much more for what is not convex) falls
// and the least quality does not. As the measure is a whole number, clean-up ends. We differ: one mechanism for all
// patterns; valences are those of sectors; edits must keep the size.
#include "stages/cleanup/cleanup.hpp"

#include <algorithm>
#include <optional>
#include <queue>

#include "stages/cleanup/grow_patch.hpp"
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
constexpr double kJacobianWorth = 20;  // in valence costs, where something must be mended
constexpr double kGoodJacobian = 0.5;
constexpr std::size_t kTries = 3;        // replacements tried per cavity
constexpr std::size_t kTriesBroken = 8;  // where something must be mended

/// Nodes to look at: small cavities first, then patches; dearest first, then by id.
class WorkList {
 public:
  enum Phase { Local, Patch, Done };
  struct Entry {
    Phase phase;
    int cost;
    NodeId node;
    bool operator<(const Entry& o) const {
      if (phase != o.phase) return phase > o.phase;
      return cost != o.cost ? cost < o.cost : node > o.node;
    }
  };
  void push(NodeId v, Phase phase, int cost) {
    if (pending_.count() <= v.value) pending_.grow(v.value + 1, Done);
    if (pending_[v] <= phase) return;
    pending_[v] = phase;
    queue_.push({phase, cost, v});
  }
  /// False: nothing is left.
  bool pop(Entry& entry) {
    while (!queue_.empty()) {
      entry = queue_.top();
      queue_.pop();
      if (pending_[entry.node] != entry.phase) continue;  // it was pushed again for an earlier phase
      pending_[entry.node] = Done;
      return true;
    }
    return false;
  }
  std::size_t count() const { return queue_.size(); }

 private:
  std::priority_queue<Entry> queue_;
  IdVector<NodeId, Phase> pending_;
};

class CleanUp {
 public:
  CleanUp(WorkMesh& mesh, const SizeField& field)
      : mesh_(mesh), sectors_(mesh), finder_(mesh, sectors_), grower_(mesh, sectors_, size_), trial_(mesh, size_) {
    const Topology& topo = mesh.topo();
    size_.grow(topo.node_capacity());
    for (std::size_t i = 0; i < topo.node_capacity(); ++i)
      if (topo.is_live(NodeId(i))) size_[NodeId(i)] = field.at(mesh.point(NodeId(i)));
  }

  void run(Context& context) {
    for (int sweep = 0; sweep < kFirstSweeps; ++sweep) smooth_all();
    for (std::size_t i = 0; i < mesh_.topo().node_capacity(); ++i)
      if (mesh_.topo().is_live(NodeId(i))) push(NodeId(i));
    const double n_start = std::max(1.0, static_cast<double>(work_.count()));
    WorkList::Entry entry;
    for (std::size_t n = 0; work_.pop(entry); ++n) {
      if (n % 256 == 0) context.progress("clean-up", 1 - std::min(1.0, static_cast<double>(work_.count()) / n_start));
      const NodeId v = entry.node;
      if (!mesh_.topo().is_live(v) || cost(v) == 0) continue;
      if (entry.phase == WorkList::Local) {
        if (!try_shapes(v)) work_.push(v, WorkList::Patch, cost(v));
      } else {
        try_patches(v);
      }
    }
    mesh_.compact();
  }

 private:
  void smooth_all();
  bool is_broken(FaceId f) const { return scaled_jacobian(mesh_.quad_points(f)) < kFlatQuad; }
  int cost(NodeId v) const;
  void push(NodeId v) {
    if (const int c = cost(v); c > 0) work_.push(v, WorkList::Local, c);
  }

  bool try_shapes(NodeId v);
  bool try_templates(const Cavity& cavity, bool must);
  bool try_patches(NodeId v);
  bool try_replacement(const Cavity& cavity, int cost_after, bool must);
  bool carry_out_best();
  double w_=1;
  void commit();
  static int least_cost(const WorkMesh& mesh, const Cavity& cavity);

  WorkMesh& mesh_;
  Sectors sectors_;
  IdVector<NodeId, double> size_;
  CavityFinder finder_;
  PatchGrower grower_;
  Trial trial_;
  TemplateTable table_;
  WorkList work_;
  Cavity cavity_;
  Replacement replacement_;
  FaceSets sets_;
  std::vector<TemplateTable::RimCosts> rim_costs_;
  std::vector<TemplateTable::Match> matches_;
  std::vector<NodeId> nodes_;
  struct Attempt {
    Cavity cavity;
    Replacement replacement;
    double gain;
  };
  std::optional<Attempt> best_;
};

void CleanUp::smooth_all() {
  const Topology& topo = mesh_.topo();
  std::vector<StarQuad> star;
  for (std::size_t i = 0; i < topo.node_capacity(); ++i) {
    const NodeId v(i);
    if (!topo.is_live(v) || !mesh_.is_free(v)) continue;
    star.clear();
    topo.for_each_out(v, [&](HalfId h) {
      const NodeId opposite = topo.head(topo.next(h)), previous = topo.tail(topo.prev(h));
      star.push_back({mesh_.point(topo.head(h)), mesh_.point(opposite), mesh_.point(previous)});
    });
    mesh_.move(v, better_place(mesh_.point(v), star));
  }
}

// Of the sectors of a node and of the quads round it that are not convex.
int CleanUp::cost(NodeId v) const {
  int sum = sectors_.cost(v);
  mesh_.topo().for_each_out(v, [&](HalfId h) {
    if (const FaceId f = mesh_.topo().face(h); f.valid() && is_broken(f)) sum += kBroken;
  });
  return sum;
}

bool CleanUp::try_shapes(NodeId v) {
  best_.reset();
  const bool must = cost(v) >= kBroken;
  for (const Shape& shape : shapes()) {
    sets_.clear();
    shape.propose(mesh_, v, sets_);
    for (std::size_t i = 0; i < sets_.count(); ++i)
      if (finder_.collect(sets_[i], cavity_) && try_templates(cavity_, must)) return true;
  }
  return carry_out_best();
}
bool CleanUp::carry_out_best() {
  if (!best_) return false;
  cavity_ = best_->cavity;
  replacement_ = best_->replacement;
  trial_.build(cavity_, replacement_);
  trial_.smooth(kTrialSweeps);
  commit();
  return true;
}

bool CleanUp::try_templates(const Cavity& cavity, bool must) {
  int n_broken = 0;
  for (const FaceId f : cavity.faces) n_broken += is_broken(f);
  if (n_broken == 0 && cavity.cost <= least_cost(mesh_, cavity)) return false;
  rim_costs_.clear();
  for (const Cavity::RimNode& r : cavity.rim) {
    TemplateTable::RimCosts c{};
    for (int q = 1; q <= TemplateTable::kMaxRimQuads; ++q) c[q] = valence_cost(r.wish, r.outside + q);
    rim_costs_.push_back(c);
  }
  table_.find(rim_costs_, cavity.cost + kBroken * n_broken, must ? kTriesBroken : kTries, matches_);
  for (const TemplateTable::Match& m : matches_) {
    replacement_.inner.assign(m.way->n_inner, NodeId());
    std::copy_n(cavity.inner.begin(), std::min(cavity.inner.size(), replacement_.inner.size()),
                replacement_.inner.begin());
    replacement_.quads.clear();
    for (int i = 0; i < m.way->n_quads; ++i) {
      const auto& q = m.way->quads[i];
      replacement_.quads.push_back({q[0], q[1], q[2], q[3]});
    }
    if (try_replacement(cavity, m.cost, must)) return true;
  }
  return false;
}

bool CleanUp::try_patches(NodeId v) {
  static const int EX=getenv("EX")?atoi(getenv("EX")):0; static const double W=getenv("W")?atof(getenv("W")):1; w_=W;
  best_.reset(); int left=EX;
  for (bool more = grower_.start(v); more; more = grower_.grow()) {
    if (best_ && left--<=0) break;
    const Cavity& patch = grower_.cavity();
    if (grower_.rim_cost() + std::abs(4 - grower_.corner_count()) >= patch.cost) continue;
    for (const Filling& filling : fill_patch(grower_.rim(), kTries)) {
      const int cost_after = grower_.rim_cost() + filling.n_irregular;
      if (cost_after >= patch.cost) break;
      replacement_.inner.assign(filling.n_inner, NodeId());
      std::copy_n(patch.inner.begin(), std::min(patch.inner.size(), replacement_.inner.size()),
                  replacement_.inner.begin());
      replacement_.quads = filling.quads;
      try_replacement(patch, cost_after, true);
    }
  }
  return carry_out_best();
}

// What no filling can go below: the sum of the signed differences is the same for all.
int CleanUp::least_cost(const WorkMesh& mesh, const Cavity& cavity) {
  int sum = 0;
  for (const Cavity::RimNode& r : cavity.rim) {
    if (r.wish.second != 0) return 0;
    sum += r.wish.ideal - r.inside - r.outside;
  }
  for (const NodeId v : cavity.inner) sum += 4 - mesh.topo().edge_valence(v);
  return std::abs(sum);
}

// Carries out what is better; where something must be mended, only notes the best.
bool CleanUp::try_replacement(const Cavity& cavity, int cost_after, bool must) {
  if (!trial_.build(cavity, replacement_)) return false;
  const PatchQuality now = trial_.quality_now();
  trial_.smooth(kTrialSweeps);
  const PatchQuality then = trial_.quality();
  const int before = cavity.cost + kBroken * now.n_broken, after = cost_after + kBroken * then.n_broken;
  if (after >= before) return false;
  if (before - after < kBroken / 2) {
    const double floor = std::min(now.least_jacobian, std::max(kFloor, now.least_jacobian - kMayLose));
    if (then.least_jacobian < floor) return false;
    if (then.size_error > std::max(1.0, now.size_error)) return false;
    static const double SP=getenv("SP")?atof(getenv("SP")):9, BT=getenv("BT")?atof(getenv("BT")):9, ST=getenv("ST")?atof(getenv("ST")):1;
    if (then.size_spread > std::max(SP, ST*now.size_spread)) return false;
    if (then.mean_beta < now.mean_beta-BT) return false;
    static const double KA=getenv("KA")?atof(getenv("KA")):1e9;
    if ((now.mean_beta-then.mean_beta)*(cavity.faces.size()+trial_.ring().size())>KA*(before-after)) return false;
  }
  if (!must) {
    commit();
    return true;
  }
  const double gain = before>=kBroken? before - after + kJacobianWorth * std::min(then.least_jacobian, kGoodJacobian): before-after+w_*(then.mean_beta-now.mean_beta)*(cavity.faces.size()+trial_.ring().size());
  if (!best_ || gain > best_->gain) best_ = Attempt{cavity, replacement_, gain};
  return false;
}

void CleanUp::commit() {
  trial_.commit(mesh_, size_, nodes_);
  for (const NodeId v : nodes_) {
    push(v);
    mesh_.topo().for_each_out(v, [&](HalfId h) { push(mesh_.topo().head(h)); });
  }
}

}  // namespace
}  // namespace cleanup

void clean_up(WorkMesh& mesh, const SizeField& size, Context& context) { cleanup::CleanUp(mesh, size).run(context); }

}  // namespace quadline
