// Topological clean-up [Kinney1997, Canann1998] by re-meshing cavities [Reberol2021, Bunin2006]. Every edit is tried
// beside the mesh, smoothed, and kept only if the measure (valence costs, and much more for what is not convex) falls
// and the shapes do not suffer. As the measure is a whole number, clean-up ends. We differ: one mechanism for all
// patterns; valences are those of sectors; edits must keep the size.
#include "stages/cleanup/cleanup.hpp"

#include <algorithm>
#include <optional>

#include "base/step_limit.hpp"
#include "quality/limits.hpp"
#include "stages/cleanup/grow_patch.hpp"
#include "stages/cleanup/shapes.hpp"
#include "stages/cleanup/trial.hpp"
#include "stages/cleanup/work_list.hpp"

namespace quadline {

namespace cleanup {
namespace {

constexpr int kRounds = 2;                      // the first moves many nodes; a third gains hardly anything
constexpr std::size_t kStepsPerNode = 100;      // of the work list: a guard, as every edit lowers the measure
constexpr int kFirstSweeps = 3;                 // of smoothing, before anything is judged
constexpr int kTrialSweeps = 7;                 // of a trial in all; smoothing comes after
constexpr int kFirstLook = 1, kSecondLook = 3;  // sweeps after which hopeless trials are given up
constexpr std::size_t kTries = 6;               // cheapest replacements of a cavity that are tried
constexpr std::size_t kTriesBroken = 8;         // the same where something must be mended, and the best is taken
constexpr std::size_t kStepsPerReport = 256;    // of the work list

// What an edit may lose, as smoothing will make good a part of it.
constexpr double kFloor = 0.4;  // the least scaled Jacobian may fall by kMayLose, but not below this
constexpr double kMayLose = 0.2;
constexpr double kBetaMayLose = 0.08;  // of the mean beta round the cavity: 0.05 leaves more nodes irregular, 0.12
                                       // shears regions
constexpr double kSizeSpread = 0.15;   // see PatchQuality; never refused below it

// How far off its limits a trial may be at a look: of those that are farther off no more than one in a hundred
// comes good in the sweeps that are left.
struct Slack {
  double beta, spread, size;
};
struct Slacks {
  Slack first, second;
};
constexpr Slacks kSmallSlacks{{0.12, 0.32, 1.8}, {0.04, 0.15, 0.75}};
constexpr Slacks kPatchSlacks{{0.02, 0.08, 1.5}, {0.01, 0.03, 0.75}};

// What it is worth beside a valence, to choose among edits.
constexpr double kJacobianWorth = 20;    // of the least scaled Jacobian, where something must be mended,
constexpr double kEnoughJacobian = 0.5;  // up to here: beyond it valences decide
constexpr double kBetaWorth = 0.5;       // of the sum of beta

bool is_within(const PatchQuality& then, const PatchQuality& now, const Slack& slack) {
  return then.mean_beta >= now.mean_beta - kBetaMayLose - slack.beta &&
         then.size_spread <= std::max(kSizeSpread, now.size_spread) + slack.spread &&
         then.size_error <= std::max(1.0, now.size_error) + slack.size;
}

class CleanUp {
 public:
  CleanUp(WorkMesh& mesh, const SizeField& field, const TemplateTable& table);
  void run(Context& context);

 private:
  void work_off(Context& context, int round);
  void smooth_all();
  bool is_broken(FaceId f) const { return scaled_jacobian(mesh_.quad_points(f)) < kBrokenJacobian; }
  int cost(NodeId v) const;
  void push(NodeId v) {
    if (const int c = cost(v); c > 0) work_.push(v, WorkList::Local, c);
  }

  bool try_shapes(NodeId v);
  bool try_templates(const Cavity& cavity, bool must);
  bool try_patches(NodeId v);
  std::optional<double> gain_of_trial(const Cavity& cavity, const Slacks& slacks, bool must);
  void note(const Cavity& cavity, double gain);
  bool carry_out_best();
  void commit();
  void reuse_inner_nodes(const Cavity& cavity, std::size_t n_inner);

  struct Attempt {
    Cavity cavity;
    Replacement replacement;
    double gain;
  };

  WorkMesh& mesh_;
  Sectors sectors_;
  IdVector<NodeId, double> size_;
  CavityFinder finder_;
  PatchGrower grower_;
  Trial trial_;
  const TemplateTable& table_;
  WorkList work_;
  Cavity cavity_;
  Replacement replacement_;
  std::optional<Attempt> best_;
  FaceSets sets_;
  std::vector<TemplateTable::RimCosts> rim_costs_;
  std::vector<TemplateTable::Match> matches_;
  std::vector<NodeId> nodes_;
  std::size_t n_edits_ = 0;
};

CleanUp::CleanUp(WorkMesh& mesh, const SizeField& field, const TemplateTable& table)
    : mesh_(mesh),
      sectors_(mesh),
      finder_(mesh, sectors_),
      grower_(mesh, sectors_, size_),
      trial_(mesh, size_),
      table_(table) {
  size_.grow(mesh.topo().node_capacity());
  for (const NodeId v : mesh.topo().nodes()) size_[v] = field.at(mesh.point(v));
}

void CleanUp::run(Context& context) {
  for (int round = 0; round < kRounds; ++round) {
    for (int sweep = 0; sweep < kFirstSweeps; ++sweep) smooth_all();
    for (const NodeId v : mesh_.topo().nodes()) push(v);
    n_edits_ = 0;
    work_off(context, round);
    if (n_edits_ == 0) break;
  }
  mesh_.compact();
}

void CleanUp::work_off(Context& context, int round) {
  const double n_start = std::max(1.0, static_cast<double>(work_.count()));
  WorkList::Entry entry;
  StepLimit limit("clean-up", kStepsPerNode * mesh_.topo().node_count());
  while (work_.pop(entry)) {
    limit.step();
    if (limit.steps() % kStepsPerReport == 1) {
      const double done = 1 - std::min(1.0, static_cast<double>(work_.count()) / n_start);
      context.progress("clean-up", (round + done) / kRounds);
    }
    const NodeId v = entry.node;
    if (!mesh_.topo().is_live(v) || cost(v) == 0) continue;
    if (entry.phase == WorkList::Patch) {
      try_patches(v);
    } else if (!try_shapes(v)) {
      work_.push(v, WorkList::Patch, entry.cost);
    }
  }
}

void CleanUp::smooth_all() {
  const Topology& topo = mesh_.topo();
  std::vector<StarQuad> star;
  for (const NodeId v : topo.nodes()) {
    if (!mesh_.is_free(v)) continue;
    star.clear();
    topo.for_each_out(v, [&](HalfId h) {
      const NodeId opposite = topo.head(topo.next(h)), previous = topo.tail(topo.prev(h));
      star.push_back({mesh_.point(topo.head(h)), mesh_.point(opposite), mesh_.point(previous)});
    });
    mesh_.move(v, better_place(mesh_.point(v), star, size_[v]));
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

// Carries out the first replacement that is better; where something must be mended, only notes the best.
bool CleanUp::try_templates(const Cavity& cavity, bool must) {
  int n_broken = 0;
  for (const FaceId f : cavity.faces) n_broken += is_broken(f);
  if (n_broken == 0 && cavity.cost <= least_cost(cavity)) return false;
  rim_costs_.clear();
  for (const Cavity::RimNode& r : cavity.rim) {
    TemplateTable::RimCosts c{};
    for (int q = 1; q <= TemplateTable::kMaxRimQuads; ++q) c[q] = valence_cost(r.ideal, r.outside + q);
    rim_costs_.push_back(c);
  }
  table_.find(rim_costs_, cavity.cost + kBroken * n_broken, must ? kTriesBroken : kTries, matches_);
  for (const TemplateTable::Match& m : matches_) {
    reuse_inner_nodes(cavity, m.way->n_inner);
    replacement_.quads.clear();
    for (int i = 0; i < m.way->n_quads; ++i) {
      const auto& q = m.way->quads[i];
      replacement_.quads.push_back({q[0], q[1], q[2], q[3]});
    }
    const std::optional<double> gain = gain_of_trial(cavity, kSmallSlacks, must);
    if (!gain) continue;
    if (!must) {
      commit();
      return true;
    }
    note(cavity, *gain);
  }
  return false;
}

bool CleanUp::try_patches(NodeId v) {
  best_.reset();
  for (bool more = grower_.start(v); more && !best_; more = grower_.grow()) {
    const Cavity& patch = grower_.cavity();
    const int most_irregular = patch.cost - grower_.rim_cost() - 1;
    if (std::abs(4 - grower_.corner_count()) > most_irregular) continue;
    for (Filling& filling : fill_patch(grower_.rim(), kTries, most_irregular)) {
      reuse_inner_nodes(patch, filling.n_inner);
      replacement_.quads = std::move(filling.quads);
      if (const std::optional<double> gain = gain_of_trial(patch, kPatchSlacks, false)) note(patch, *gain);
    }
  }
  return carry_out_best();
}

void CleanUp::reuse_inner_nodes(const Cavity& cavity, std::size_t n_inner) {
  replacement_.inner.assign(n_inner, NodeId());
  std::copy_n(cavity.inner.begin(), std::min(cavity.inner.size(), n_inner), replacement_.inner.begin());
}

// Builds and smooths the replacement; what it is worth, or nothing where it is refused.
std::optional<double> CleanUp::gain_of_trial(const Cavity& cavity, const Slacks& slacks, bool must) {
  const int valences_after = cost_after(cavity, replacement_);
  if (valences_after >= cavity.cost && !must) return std::nullopt;
  if (!trial_.build(cavity, replacement_)) return std::nullopt;
  const PatchQuality now = trial_.quality_now();
  const auto fall_to = [&](const PatchQuality& then) {
    return cavity.cost - valences_after + kBroken * (now.n_broken - then.n_broken);
  };
  trial_.smooth(kFirstLook);
  if (!must && !is_within(trial_.quality(), now, slacks.first)) return std::nullopt;
  trial_.smooth(kSecondLook - kFirstLook);
  const PatchQuality soon = trial_.quality();
  if (must ? fall_to(soon) <= 0 : !is_within(soon, now, slacks.second)) return std::nullopt;
  trial_.smooth(kTrialSweeps - kSecondLook);
  const PatchQuality then = trial_.quality();
  const int fall = fall_to(then);
  if (fall <= 0) return std::nullopt;
  if (fall >= kBroken / 2) return fall + kJacobianWorth * std::min(then.least_jacobian, kEnoughJacobian);
  if (then.least_jacobian < std::min(now.least_jacobian, std::max(kFloor, now.least_jacobian - kMayLose)) ||
      !is_within(then, now, {}))
    return std::nullopt;
  return fall + kBetaWorth * static_cast<double>(now.n_quads) * (then.mean_beta - now.mean_beta);
}

void CleanUp::note(const Cavity& cavity, double gain) {
  if (!best_ || gain > best_->gain) best_ = Attempt{cavity, replacement_, gain};
}

bool CleanUp::carry_out_best() {
  if (!best_) return false;
  trial_.build(best_->cavity, best_->replacement);
  trial_.smooth(kTrialSweeps);
  commit();
  return true;
}

void CleanUp::commit() {
  ++n_edits_;
  trial_.commit(mesh_, size_, nodes_);
  for (const NodeId v : nodes_) {
    push(v);
    mesh_.topo().for_each_out(v, [&](HalfId h) { push(mesh_.topo().head(h)); });
  }
}

}  // namespace
}  // namespace cleanup

void clean_up(WorkMesh& mesh, const SizeField& size, const cleanup::TemplateTable& templates, Context& context) {
  cleanup::CleanUp(mesh, size, templates).run(context);
}

}  // namespace quadline
