// The stages of Fig. 3 in [Lee2003] for one cell. Where the first triangles leave something to wish for, others may do
// better: none win everywhere.
#include "cells/mesh_cell.hpp"

#include <algorithm>
#include <cstddef>

#include "base/stage_clock.hpp"
#include "cells/accept_grid.hpp"
#include "cells/cell_cost.hpp"
#include "cells/thin_quads.hpp"
#include "stages/field_points/field_points.hpp"
#include "stages/grid/fill_grid.hpp"
#include "stages/halve/halve.hpp"
#include "stages/pair/pair.hpp"
#include "stages/qmorph/qmorph.hpp"
#include "stages/smooth/smooth.hpp"
#include "stages/triangulate/triangulate.hpp"

namespace quadline {

namespace {

// The points that fill a cell.
struct Fill {
  Triangles triangles;
  double spacing;
};
constexpr std::array<Fill, 3> kRetries{
    {{Triangles::Delaunay, 1}, {Triangles::Front, kCloser}, {Triangles::Front, kWider}}};

// About the parts of a cell's time that its stages take.
constexpr double kTriangulated = 0.05, kFilled = 0.15, kMerged = 0.35, kCleaned = 0.65;

// Tells the progress of a stage as that of a part of the whole.
Context part_of(const Context& context, double from, double to) {
  Context part;
  part.is_cancelled = context.is_cancelled;
  part.on_progress = [&context, from, to](std::string_view stage, double done) {
    context.progress(stage, from + done * (to - from));
  };
  return part;
}

class CellMesher {
 public:
  CellMesher(const CellInput& input, const Recipe& recipe, Context& context)
      : input_(input), recipe_(recipe), context_(context) {}

  CellResult run() {
    if (recipe_.may_grid && grid()) return std::move(result_);
    if (recipe_.is_grid_planned()) {
      note(InternalError("the grid that was planned does not come out"));
      result_.trouble->is_grid = true;
      return std::move(result_);
    }
    try {
      first_try();
    } catch (const InternalError& error) {
      note(error);
    }
    if (recipe_.may_retry && !result_.is_cached && (result_.trouble || is_improvable(result_.mesh)))
      clock_.run("retries", context_, [&] { retry(); });
    result_.times = std::move(clock_.times());
    return std::move(result_);
  }

 private:
  bool grid() {
    WorkMesh mesh = input_.nodes.of(input_.cell);
    bool is_good = false;
    run(clock_, "grid", part_of(context_, 0, kTriangulated), 0, 1, [&](Context& own) {
      if (!fill_grid(mesh, input_.domain, input_.cell, recipe_.grid)) return;
      if (recipe_.grid.rings > 0) {  // they are what is asked for, and stay it
        for (const FaceId f : mesh.topo().faces()) mesh.freeze(f);
        is_good = unsound_faces(mesh).empty();
        return;
      }
      smooth(mesh, input_.domain, input_.sizes.at(1), {.slides = false, .raises_beta = false}, own);
      is_good = is_good_grid(mesh, input_.domain, input_.sizes.at(1));
    });
    result_.times = clock_.times();
    if (!is_good) return false;
    result_.is_grid = true;
    result_.raw = mesh;
    result_.start = fingerprint(mesh);
    result_.mesh = std::move(mesh);
    return true;
  }

  void first_try() {
    const Context part = part_of(context_, 0, kCleaned);
    const Fill fill{recipe_.triangles, recipe_.method == Method::QMorph ? 1 : kHalvedSpacing};
    result_.raw = merged(fill, result_.counts, clock_, part, input_.wants_snapshots);
    result_.start = fingerprint(result_.raw);
    if (const CellCache::Entry* known = find_known()) {
      result_.mesh = known->mesh;
      result_.counts = known->counts;
      result_.is_cached = true;
      return;
    }
    result_.mesh = result_.raw;
    if (recipe_.keeps_thin_quads) freeze_thin_quads(result_.mesh);
    if (!recipe_.kept_places.empty())
      freeze_near(result_.mesh, recipe_.kept_places, recipe_.kept_reach, input_.sizes.at(1));
    clean(result_.mesh, clock_, part);
  }

  // In small cells different triangles often give the same quads, which need not be cleaned up again.
  void retry() {
    std::vector<std::uint64_t> seen{result_.start};
    for (std::size_t i = 0; i < kRetries.size(); ++i) {
      const double share = (1 - kCleaned) / kRetries.size(), from = kCleaned + share * static_cast<double>(i);
      const Context part = part_of(context_, from, from + share);
      StageClock clock;  // all retries are one stage
      try {
        MorphCounts counts;
        WorkMesh other = merged(kRetries[i], counts, clock, part, false);
        const std::uint64_t start = fingerprint(other);
        if (std::find(seen.begin(), seen.end(), start) != seen.end()) continue;
        seen.push_back(start);
        clean(other, clock, part);
        if (!result_.trouble && cell_cost(other) >= cell_cost(result_.mesh)) continue;
        result_.mesh = std::move(other);
        result_.counts = counts;
        result_.trouble.reset();
      } catch (const InternalError&) {
        continue;  // what is there stays
      }
      if (!is_improvable(result_.mesh)) return;
    }
  }

  // From nodes to quads, before clean-up.
  WorkMesh merged(const Fill& fill, MorphCounts& counts, StageClock& clock, const Context& context, bool seen) {
    WorkMesh mesh = input_.nodes.of(input_.cell);
    run(clock, "triangulate", context, 0, kTriangulated, [&](Context& own) {
      triangulate(mesh, input_.domain, own);
      mesh.keep_cell(input_.cell);
    });
    if (seen) keep("triangulation", mesh);
    run(clock, "field points", context, kTriangulated, kFilled,
        [&](Context& own) { insert_field_points(mesh, input_.sizes.at(fill.spacing), fill.triangles, own); });
    if (seen) keep("field-points", mesh);
    if (recipe_.method == Method::QMorph) {
      counts = morph(mesh, clock, context, seen);
    } else {
      halve_all(mesh, clock, context, seen);
    }
    if (!seen) return mesh;
    if (recipe_.method == Method::QMorph) keep("before-halving", mesh);  // as it is while others are halved
    keep("before-smoothing", mesh);
    return mesh;
  }

  MorphCounts morph(WorkMesh& mesh, StageClock& clock, const Context& context, bool seen) {
    std::function<void(std::string_view, const WorkMesh&)> observe;
    if (seen) {
      keep("first-layer", mesh);  // a small cell may never come so far
      keep("half-way", mesh);
      observe = [&](std::string_view name, const WorkMesh& now) { keep(name, now); };
    }
    MorphCounts counts;
    run(clock, "qmorph", context, kFilled, kMerged, [&](Context& own) {
      counts = merge_to_quads(mesh, input_.sizes.at(1), {.lines = recipe_.lines}, observe, own);
    });
    return counts;
  }

  void halve_all(WorkMesh& mesh, StageClock& clock, const Context& context, bool seen) {
    if (recipe_.method == Method::Merge)
      run(clock, "pair", context, kFilled, 0.5 * (kFilled + kMerged), [&](Context& own) { pair_triangles(mesh, own); });
    if (seen) keep("before-halving", mesh);
    run(clock, "halve", context, 0.5 * (kFilled + kMerged), kMerged,
        [&](Context& own) { halve(mesh, input_.domain, own); });
  }

  void clean(WorkMesh& mesh, StageClock& clock, const Context& context) {
    run(clock, "clean-up", context, kMerged, 1,
        [&](Context& own) { clean_up(mesh, input_.sizes.at(1), input_.templates, own); });
  }

  template <class Work>
  static void run(StageClock& clock, const char* stage, const Context& context, double from, double to, Work work) {
    Context own = part_of(context, from, to);
    clock.run(stage, own, [&] { work(own); });
  }

  // What is kept near places is no part of the fingerprint.
  const CellCache::Entry* find_known() const {
    if (!input_.cache || !recipe_.kept_places.empty()) return nullptr;
    return input_.cache->find(input_.cell, result_.start);
  }

  void note(const InternalError& error) {
    const Domain::Curve& curve = input_.domain.curves[input_.domain.cells[input_.cell].walks[0][0].curve];
    result_.trouble = {input_.cell, error.what(), error.where().point.value_or(curve.piece.a)};
    result_.mesh = WorkMesh();
    result_.counts = {};
  }

  void keep(std::string_view name, const WorkMesh& mesh) {
    for (CellSnapshot& snapshot : result_.snapshots)
      if (snapshot.name == name) return void(snapshot.mesh = mesh);
    result_.snapshots.push_back({name, mesh});
  }

  const CellInput& input_;
  const Recipe& recipe_;
  Context& context_;
  StageClock clock_;
  CellResult result_;
};

}  // namespace

CellResult mesh_cell(const CellInput& input, const Recipe& recipe, Context& context) {
  return CellMesher(input, recipe, context).run();
}

}  // namespace quadline
