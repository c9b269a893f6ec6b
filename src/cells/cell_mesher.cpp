#include "cells/cell_mesher.hpp"

#include <algorithm>
#include <array>
#include <cstddef>

#include "cells/cell_cost.hpp"
#include "cells/cell_loop.hpp"
#include "cells/thin_quads.hpp"
#include "stages/discretize/discretize.hpp"
#include "stages/field_points/field_points.hpp"
#include "stages/halve/halve.hpp"
#include "stages/pair/pair.hpp"
#include "stages/qmorph/qmorph.hpp"
#include "stages/triangulate/triangulate.hpp"

namespace quadline {

namespace {

// Triangles that are tried after the first, at a part of the sizes.
struct Retry {
  Triangles triangles;
  double spacing;
};
constexpr std::array<Retry, 3> kRetries{{{Triangles::Delaunay, 1}, {Triangles::Front, 0.93}, {Triangles::Front, 1.07}}};

// Tells the progress of the stages of one try as that of a part of it.
Context part_of_tries(Context& context, std::size_t i) {
  Context part;
  part.is_cancelled = context.is_cancelled;
  part.on_progress = [&context, i](std::string_view stage, double done) {
    const double before = stage == "clean-up" ? 0.5 : stage == "qmorph" ? 0.2 : 0, share = before == 0.5 ? 0.5 : 0.25;
    context.progress("", (static_cast<double>(i) + before + share * done) / kRetries.size());
  };
  return part;
}

}  // namespace

CellMesher::CellMesher(const Domain& domain, const SizeField& size, const FallbackPlan& plan, const Options& options,
                       CellCache& cache, const Context& context, StageClock& clock, Observe observe)
    : domain_(domain),
      size_(size),
      plan_(plan),
      options_(options),
      context_(context),
      clock_(clock),
      cache_(cache),
      observe_(std::move(observe)),
      parts_(domain.cells.count()),
      raw_(domain.cells.count()),
      counts_(domain.cells.count()),
      troubles_(domain.cells.count()),
      starts_(domain.cells.count()),
      is_done_(domain.cells.count(), 0) {
  for (std::size_t i = 0; i < domain.cells.count(); ++i) {
    const CellId c(i);
    if (plan.rung(c).is_halved) fallen_back_.insert(c);
    if (plan.rung(c).is_halved || options.method != Method::QMorph) halved_.insert(c);
  }
  if (!halved_.empty()) double_size_ = size.scaled(2);
}

void CellMesher::place_nodes() {
  clock_.run("discretize", [&] {
    Context context = context_;
    halved_nodes_ = discretize(domain_, size_, halved_, context);
    nodes_ = halved_nodes_;
    halve_segments(nodes_, domain_, curves_round(domain_, halved_));
  });
  of_whole_.emplace(domain_, nodes_);
  of_halved_.emplace(domain_, halved_nodes_);
}

double CellMesher::least_quads() const {
  double sum = 0;
  for (std::size_t i = 0; i < domain_.cells.count(); ++i)
    sum += std::max(1.0, 0.5 * (static_cast<double>(of_whole_->count(CellId(i))) - 2));
  return sum;
}

void CellMesher::make_triangles() {
  run("triangulate", [&](CellId c, Context& context) { parts_[c] = triangulated(c, context); });
  observe("triangulation");
  run("field points", [&](CellId c, Context& context) {
    insert_field_points(parts_[c], is_halved(c) ? double_size_ : size_, triangles_of(c), context);
  });
  observe("field-points");
}

void CellMesher::make_quads() {
  if (options_.method == Method::QMorph) merge();
  if (!halved_.empty()) halve();
  observe("before-smoothing");
}

void CellMesher::merge() {
  std::vector<std::pair<std::string_view, IdVector<CellId, WorkMesh>>> seen;
  if (observe_) seen = {{"first-layer", parts_}, {"half-way", parts_}};
  run("qmorph", [&](CellId c, Context& context) {
    if (is_halved(c)) return;
    const auto keep = [&](std::string_view name, const WorkMesh& now) {
      for (auto& [event, parts] : seen)
        if (event == name) parts[c] = now;
    };
    counts_[c] = merge_to_quads(parts_[c], size_, {.lines = options_.lines}, keep, context);
  });
  for (const auto& [event, parts] : seen) observe_(event, joined(parts));
}

void CellMesher::halve() {
  if (options_.method != Method::Split)
    run("pair", [&](CellId c, Context& context) {
      if (is_halved(c)) pair_triangles(parts_[c], context);
    });
  observe("before-halving");
  run("halve", [&](CellId c, Context& context) {
    if (!is_halved(c)) return;
    quadline::halve(parts_[c], domain_, context);
    if (fallen_back_.contains(c)) raw_[c] = parts_[c];
  });
}

void CellMesher::clean_up() {
  run("clean-up", [&](CellId c, Context& context) {
    starts_[c] = fingerprint(parts_[c]);
    if (take_from_cache(c)) return;
    if (fallen_back_.contains(c)) freeze_thin_quads(parts_[c]);
    quadline::clean_up(parts_[c], size_, templates_, context);
    keep_in_cache(c);
  });
}

void CellMesher::clean_up_again(const CellSet& cells, const std::function<void(WorkMesh&)>& freeze) {
  run("clean-up", [&](CellId c, Context& context) {
    if (!cells.contains(c)) return;
    parts_[c] = raw_[c];
    freeze(parts_[c]);
    quadline::clean_up(parts_[c], size_, templates_, context);
  });
}

// No triangles win everywhere. Where the first leave something to wish for, others may do better.
void CellMesher::try_triangles() {
  if (options_.triangles != Triangles::Both) return;
  for (const Retry& other : kRetries) other_sizes_.push_back(size_.scaled(other.spacing));
  clock_.run("other triangles", [&] {
    for_each_cell("other triangles", weights(), context_, [&](CellId c, Context& context) {
      if (is_halved(c) || is_done_[c] || plan_.is_changed(c)) return;
      if (troubles_[c] || is_improvable(parts_[c])) try_triangles_of(c, context);
      if (!troubles_[c]) keep_in_cache(c);
    });
  });
}

// Most models need one attempt, and no memory for a second: the first fills no cache.
bool CellMesher::take_from_cache(CellId c) {
  if (plan_.is_first()) return false;
  const CellCache::Entry* known = cache_.find(c, starts_[c]);
  if (!known) return false;
  parts_[c] = known->mesh;
  counts_[c] = known->counts;
  is_done_[c] = 1;
  return true;
}

void CellMesher::keep_in_cache(CellId c) {
  if (!plan_.is_first()) cache_.keep(c, {starts_[c], parts_[c], counts_[c]});
}

// In small cells different triangles often give the same quads, which need not be cleaned up again.
void CellMesher::try_triangles_of(CellId c, Context& context) {
  std::vector<std::uint64_t> seen{starts_[c]};
  for (std::size_t i = 0; i < kRetries.size(); ++i) {
    Context part = part_of_tries(context, i);
    try {
      WorkMesh other = triangulated(c, part);
      insert_field_points(other, other_sizes_[i], kRetries[i].triangles, part);
      const MorphCounts counts = merge_to_quads(other, size_, {.lines = options_.lines}, {}, part);
      const std::uint64_t start = fingerprint(other);
      if (std::find(seen.begin(), seen.end(), start) != seen.end()) continue;
      seen.push_back(start);
      quadline::clean_up(other, size_, templates_, part);
      if (!troubles_[c] && cell_cost(other) >= cell_cost(parts_[c])) continue;
      parts_[c] = std::move(other);
      counts_[c] = counts;
      troubles_[c].reset();
    } catch (const InternalError&) {
      continue;  // what is there stays
    }
    if (!is_improvable(parts_[c])) return;
  }
}

WorkMesh CellMesher::triangulated(CellId c, Context& context) const {
  WorkMesh part = (is_halved(c) ? *of_halved_ : *of_whole_).of(c);
  triangulate(part, domain_, context);
  part.keep_cell(c);
  return part;
}

Triangles CellMesher::triangles_of(CellId c) const {
  const bool is_front = options_.triangles != Triangles::Delaunay;
  return is_front != plan_.rung(c).other_triangles ? Triangles::Front : Triangles::Delaunay;
}

WorkMesh CellMesher::cleaned_mesh() {
  WorkMesh whole = mesh();
  if (fallen_back_.empty()) parts_.clear();
  return whole;
}

std::vector<Trouble> CellMesher::troubles() const {
  std::vector<Trouble> found;
  for (const std::optional<Trouble>& trouble : troubles_)
    if (trouble) found.push_back(*trouble);
  return found;
}

template <class Work>
void CellMesher::run(const char* stage, Work work) {
  clock_.run(stage, [&] {
    for_each_cell(stage, weights(), context_, [&](CellId c, Context& context) {
      if (troubles_[c]) return;
      try {
        work(c, context);
      } catch (const InternalError& error) {
        note(c, error);
      }
    });
  });
}

void CellMesher::note(CellId c, const InternalError& error) {
  const Domain::Curve& curve = domain_.curves[domain_.cells[c].walks[0][0].curve];
  troubles_[c] = {c, error.what(), error.where().point.value_or(curve.piece.a)};
  parts_[c] = WorkMesh();
  counts_[c] = {};
}

void CellMesher::observe(std::string_view name) const {
  if (observe_) observe_(name, mesh());
}

MorphCounts CellMesher::morph_counts() const {
  MorphCounts sum;
  for (const MorphCounts& counts : counts_) sum += counts;
  return sum;
}

// The work of a cell: its faces, or before there are any, its segments.
IdVector<CellId, double> CellMesher::weights() const {
  IdVector<CellId, double> weights;
  for (std::size_t i = 0; i < parts_.count(); ++i) {
    const CellId c(i);
    const std::size_t n = parts_[c].topo().face_count();
    weights.push_back(static_cast<double>(n > 0 ? n : of_whole_->count(c) + 1));
  }
  return weights;
}

}  // namespace quadline
