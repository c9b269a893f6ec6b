// The main loop of Q-Morph [Owen1999 section 3] with line constraints [Lee2003 section 4].
#include "stages/qmorph/qmorph.hpp"

#include <algorithm>
#include <optional>

#include "base/step_limit.hpp"
#include "stages/qmorph/front_queue.hpp"
#include "stages/qmorph/morph.hpp"
#include "stages/qmorph/sleeping_sides.hpp"

namespace quadline {

Morph::Morph(WorkMesh& mesh, const SizeField& size) : mesh_(mesh), size_(size) {
  counts_.n_triangles = mesh.topo().face_count();
  insertions_ = mesh.topo().node_count() / 4 + 64;
  const Topology& topo = mesh.topo();
  for (const EdgeId e : topo.edges()) {
    if (!mesh.is_constraint(e)) continue;
    if (parity_.tie(topo.tail(half_of(e, 0)), topo.tail(half_of(e, 1)), true)) continue;
    const Point p = mesh.point(topo.tail(half_of(e, 0)));
    throw InternalError("the edges round a cell are odd in number", {.file = {}, .place = {}, .point = p});
  }
}

namespace {

class Driver {
 public:
  using Observe = std::function<void(std::string_view, const WorkMesh&)>;

  Driver(WorkMesh& mesh, const SizeField& size, const FrontOptions& options, const Observe& observe)
      : mesh_(mesh), options_(options), observe_(observe), morph_(mesh, size), queue_(morph_) {
    if (options.lines == LineFronts::OneSided) asleep_.emplace(mesh);
    push_all();
  }

  MorphCounts run(Context& context) {
    const std::size_t n_start = mesh_.topo().face_count();
    StepLimit limit("the front", options_.steps_per_triangle * n_start);
    bool half_way = true;
    while (next_step()) {
      limit.step();
      if (limit.steps() % 1024 == 0) {
        context.progress("qmorph", 1 - static_cast<double>(2 * mesh_.topo().face_count() - n_start) /
                                           static_cast<double>(n_start + 1));
      }
      if (half_way && 4 * mesh_.topo().face_count() < 3 * n_start) {
        half_way = false;
        if (observe_) observe_("half-way", mesh_);
      }
    }
    morph_.complete();
    return morph_.counts();
  }

 private:
  // One base edge: true while there is work. Edges that were refused wait; each success brings back its neighbours, and
  // when nothing else is left all that waited get one more try, as long as something has changed since.
  bool next_step() {
    const HalfId base = queue_.pop();
    if (!base.valid()) return retry();
    if (!mesh_.topo().is_live(edge_of(base)) || !is_front(mesh_, base)) return true;
    if (is_first_layer_ && morph_.level(edge_of(base)) > 0) {
      is_first_layer_ = false;
      if (observe_) observe_("first-layer", mesh_);
    }
    if (!step(base)) {
      waiting_.push_back(base);
      return true;
    }
    progress_ = true;
    push_touched();
    return true;
  }

  bool step(HalfId base) {
    if (morph_.close_loop(base)) return true;
    for (const bool at_head : {false, true}) {
      const Corner corner = at_head ? corner_after(mesh_, base) : corner_before(mesh_, base);
      if (morph_.transition(corner)) return true;
      if (corner.quads == 0 && morph_.seam(corner)) return true;
    }
    return morph_.form_quad(base);
  }

  bool retry() {
    if (asleep_) {  // nothing else can be chosen: the second sides of lines wake up
      wake(asleep_->wake_all());
      asleep_.reset();
      return true;
    }
    if (!progress_ || retries_ == kMostRetries) return false;
    progress_ = false;
    ++retries_;
    for (const HalfId h : waiting_)
      if (mesh_.topo().is_live(edge_of(h)) && is_front(mesh_, h)) queue_.push(h);
    waiting_.clear();
    return true;
  }

  void push_touched() {
    const Topology& topo = mesh_.topo();
    pushed_.clear();
    const auto push = [&](HalfId h) {
      if (is_asleep(h)) return wake(asleep_->wake_if_due(h));
      if (!is_front(mesh_, h) || std::find(pushed_.begin(), pushed_.end(), h) != pushed_.end()) return;
      pushed_.push_back(h);
      queue_.push(h);
    };
    for (const NodeId v : morph_.touched()) {
      if (!topo.is_live(v)) continue;
      topo.for_each_out(v, [&](HalfId h) {
        push(h);
        push(twin(h));
      });
    }
  }

  void push_all() {
    for (const EdgeId e : mesh_.topo().edges())
      for (int side = 0; side < 2; ++side)
        if (const HalfId h = half_of(e, side); is_front(mesh_, h) && !is_asleep(h)) queue_.push(h);
  }

  bool is_asleep(HalfId h) const { return asleep_ && asleep_->contains(h); }

  // The second side of a line joins the loop that the quads on the first have closed round it, at their level.
  void wake(const std::vector<HalfId>& side) {
    for (const HalfId h : side) {
      if (!is_front(mesh_, h)) continue;
      morph_.set_level(edge_of(h), 1);
      queue_.push(h);
    }
  }

  static constexpr int kMostRetries = 8;
  WorkMesh& mesh_;
  const FrontOptions& options_;
  const Observe& observe_;
  Morph morph_;
  FrontQueue queue_;
  std::optional<SleepingSides> asleep_;  // where fronts are one-sided
  std::vector<HalfId> waiting_, pushed_;
  bool is_first_layer_ = true, progress_ = false;
  int retries_ = 0;
};

}  // namespace

MorphCounts merge_to_quads(WorkMesh& mesh, const SizeField& size, const FrontOptions& options,
                           const std::function<void(std::string_view, const WorkMesh&)>& observe, Context& context) {
  context.progress("qmorph", 0);
  const MorphCounts counts = Driver(mesh, size, options, observe).run(context);
  mesh.sort_in_space();
  return counts;
}

}  // namespace quadline
