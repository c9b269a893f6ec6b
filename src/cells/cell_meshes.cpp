#include "cells/cell_meshes.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

#include "cells/cell_loop.hpp"
#include "cells/flatten.hpp"
#include "cells/join.hpp"
#include "cells/thin_quads.hpp"

namespace quadline {

namespace {

// Sizes from a spoiled place to what is kept, round by round; in the last it is all.
constexpr std::array<double, 3> kReaches{4, 16, 1e9};

SpacedSizes spaced_sizes(const IdVector<CellId, Recipe>& recipes, const SizeField& size) {
  bool is_halved = false, may_retry = false;
  for (const Recipe& recipe : recipes) {
    is_halved |= recipe.method != Method::QMorph;
    may_retry |= recipe.may_retry;
  }
  SpacedSizes sizes(size);
  if (is_halved) sizes.add(kHalvedSpacing);
  if (may_retry)
    for (const double spacing : {kCloser, kWider}) sizes.add(spacing);
  return sizes;
}

IdVector<CellId, Recipe> recipes_of(const FallbackPlan& plan) {
  IdVector<CellId, Recipe> recipes;
  for (std::size_t i = 0; i < plan.domain().cells.count(); ++i) recipes.push_back(plan.recipe(CellId(i)));
  return recipes;
}

// The meshes that `mesh_of` gives for the results; it may give null.
template <class MeshOf>
WorkMesh joined_of(const IdVector<CellId, CellResult>& results, MeshOf mesh_of) {
  IdVector<CellId, const WorkMesh*> parts;
  for (const CellResult& result : results) parts.push_back(mesh_of(result));
  return joined(parts);
}

}  // namespace

CellMeshes::CellMeshes(const FallbackPlan& plan, const CurveNodes& nodes, const SizeField& size, CellCache& cache,
                       StageClock& clock, const Context& context)
    : plan_(plan),
      nodes_(nodes),
      cache_(cache),
      clock_(clock),
      context_(context),
      recipes_(recipes_of(plan)),
      sizes_(spaced_sizes(recipes_, size)),
      results_(plan.domain().cells.count()) {
  const std::vector<CellCopy> copies = clock.run("copies", context, [&] {
    return find_copies(plan.domain(), plan.symmetries(), nodes, size,
                       [&](CellId a, CellId b) { return plan.is_alike(a, b); });
  });
  IdVector<CellId, bool> is_copy(results_.count(), false);
  for (const CellCopy& copy : copies) is_copy[copy.copy] = true;
  CellSet planned, others;
  for (std::size_t i = 0; i < results_.count(); ++i)
    if (const CellId c(i); !is_copy[c]) (recipes_[c].is_grid_planned() ? planned : others).insert(c);
  mesh(planned);
  if (!troubles().empty()) {  // there will be another attempt: the others would be meshed in vain
    for (const CellCopy& next : copies) copy_trouble(next);
    return;
  }
  mesh(others);
  clock.run("copies", context, [&] {
    for (const CellCopy& next : copies) copy(next);
  });
  for (std::size_t i = 0; i < results_.count(); ++i)
    if (const CellId c(i); plan_.rung(c).is_halved) n_raw_unsound_ += unsound_faces(results_[c].raw).size();
  if (context_.on_snapshot) tell_snapshots();
}

void CellMeshes::mesh(const CellSet& cells) {
  IdVector<CellId, double> weights;  // near the numbers of quads
  for (std::size_t i = 0; i < results_.count(); ++i) {
    const double n = cells.contains(CellId(i)) ? static_cast<double>(nodes_.count(CellId(i))) : 0;
    weights.push_back(1 + n * n);
  }
  clock_.run_parts("cells", context_, [&] {
    for_each_cell("cells", weights, context_, [&](CellId c, Context& context) {
      if (!cells.contains(c)) return;
      const CellInput input{plan_.domain(), c, nodes_, sizes_, templates_,
                            // Most models need one attempt, and no memory for a second: the first fills no cache.
                            plan_.is_first() ? nullptr : &cache_, static_cast<bool>(context_.on_snapshot)};
      results_[c] = mesh_cell(input, recipes_[c], context);
      keep_in_cache(c);
    });
    std::vector<StageTime> times;
    for (std::size_t i = 0; i < results_.count(); ++i)
      if (cells.contains(CellId(i)))
        times.insert(times.end(), results_[CellId(i)].times.begin(), results_[CellId(i)].times.end());
    return times;
  });
}

void CellMeshes::copy_trouble(const CellCopy& copy) {
  std::optional<Trouble>& trouble = results_[copy.copy].trouble;
  trouble = results_[copy.original].trouble;
  if (!trouble) return;
  trouble->cell = copy.copy;
  trouble->at = copy.move(trouble->at);
}

void CellMeshes::copy(const CellCopy& copy) {
  const CellResult& from = results_[copy.original];
  CellResult& to = results_[copy.copy];
  to.mesh = copied(from.mesh, copy, nodes_);
  to.raw = copied(from.raw, copy, nodes_);
  to.counts = from.counts;
  to.is_grid = from.is_grid;
  to.is_copy = true;
  for (const CellSnapshot& snapshot : from.snapshots)
    to.snapshots.push_back({snapshot.name, copied(snapshot.mesh, copy, nodes_)});
  copy_trouble(copy);
}

void CellMeshes::keep_in_cache(CellId c) {
  const CellResult& result = results_[c];
  if (plan_.is_first() || result.trouble || result.is_cached || !recipes_[c].kept_places.empty()) return;
  cache_.keep(c, {result.start, result.mesh, result.counts});
}

// A cell that a stage does not reach is shown as it was before.
void CellMeshes::tell_snapshots() const {
  const bool any_halved = std::any_of(recipes_.begin(), recipes_.end(),
                                      [](const Recipe& recipe) { return recipe.method != Method::QMorph; });
  for (std::size_t event = 0; event < kCellSnapshots.size(); ++event) {
    if (kCellSnapshots[event] == "before-halving" && !any_halved) continue;
    bool is_new = false;
    const WorkMesh mesh = joined_of(results_, [&](const CellResult& result) {
      const WorkMesh* latest = nullptr;
      for (std::size_t i = 0; i <= event; ++i)
        for (const CellSnapshot& snapshot : result.snapshots) {
          if (snapshot.name != kCellSnapshots[i]) continue;
          latest = &snapshot.mesh;
          is_new |= i == event;
        }
      return latest;
    });
    if (is_new) context_.on_snapshot(kCellSnapshots[event], flatten(mesh, plan_.domain()));
  }
}

std::vector<Trouble> CellMeshes::troubles() const {
  std::vector<Trouble> found;
  for (const CellResult& result : results_)
    if (result.trouble) found.push_back(*result.trouble);
  return found;
}

CellOrigins CellMeshes::origins() const {
  CellOrigins origins;
  for (std::size_t i = 0; i < results_.count(); ++i) {
    const CellResult& result = results_[CellId(i)];
    const bool is_front = recipes_[CellId(i)].method == Method::QMorph;
    CellOrigins::Share& share = result.is_copy   ? origins.copies
                                : result.is_grid ? origins.grids
                                : is_front       ? origins.fronts
                                                 : origins.halved;
    ++share.n_cells;
    share.n_quads += result.mesh.topo().face_count();
  }
  return origins;
}

MorphCounts CellMeshes::morph_counts() const {
  MorphCounts sum;
  for (const CellResult& result : results_) sum += result.counts;
  return sum;
}

WorkMesh CellMeshes::take_raw() {
  WorkMesh mesh = joined_of(results_, [](const CellResult& result) { return &result.raw; });
  for (CellResult& result : results_.raw()) result.raw = WorkMesh();
  return mesh;
}

// A grid among grids is smooth as it is, and alike where its cell is. Beside others its nodes on curves must give way.
void CellMeshes::freeze_grids() {
  if (plan_.has_criteria()) return;
  IdVector<CellId, bool> is_among_grids;
  for (const CellResult& result : results_) is_among_grids.push_back(result.is_grid);
  for (const Domain::Curve& curve : plan_.domain().curves)
    for (const auto& [cell, other] : {std::pair(curve.left, curve.right), std::pair(curve.right, curve.left)})
      if (cell.valid() && other.valid() && !results_[other].is_grid) is_among_grids[cell] = false;
  for (std::size_t i = 0; i < results_.count(); ++i) {
    WorkMesh& mesh = results_[CellId(i)].mesh;
    if (!is_among_grids[CellId(i)]) continue;
    for (const FaceId f : mesh.topo().faces()) mesh.freeze(f);
  }
}

WorkMesh CellMeshes::take_joined() {
  freeze_grids();
  WorkMesh mesh = joined_of(results_, [](const CellResult& result) { return &result.mesh; });
  if (!plan_.any_halved()) results_.clear();
  return mesh;
}

bool CellMeshes::mesh_spoiled_again(const WorkMesh& smoothed) {
  std::vector<FaceId> faces = unsound_faces(smoothed);
  std::erase_if(faces, [&](FaceId f) { return !plan_.rung(smoothed.cell(f)).is_halved; });
  if (faces.size() <= n_raw_unsound_ || rounds_ == kReaches.size()) return false;
  CellSet cells;
  for (const FaceId f : faces) {
    spoiled_.push_back(centre_of(smoothed, f));
    cells.insert(smoothed.cell(f));
  }
  for (std::size_t i = 0; i < recipes_.count(); ++i) {
    if (!cells.contains(CellId(i))) continue;
    recipes_[CellId(i)].kept_places = spoiled_;
    recipes_[CellId(i)].kept_reach = kReaches[rounds_];
  }
  ++rounds_;
  mesh(cells);
  return true;
}

}  // namespace quadline
