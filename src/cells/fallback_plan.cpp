#include "cells/fallback_plan.hpp"

#include <algorithm>
#include <utility>

#include "cells/quad_limit.hpp"
#include "cells/rehearsal.hpp"
#include "cells/thin_quads.hpp"
#include "domain/symmetry/cut_at_axes.hpp"

namespace quadline {

namespace {

constexpr std::size_t kMostAttempts = 24;
constexpr std::size_t kMostGridFailures = 2;  // attempts with a planned grid that did not come out

double area_of(const WorkMesh& mesh, FaceId f) {
  const QuadPoints p = mesh.quad_points(f);
  return 0.5 * cross(p[2] - p[0], p[3] - p[1]);
}

// The middle of the largest quad of each cell.
IdVector<CellId, Point> places_in_cells(const WorkMesh& mesh, std::size_t n_cells) {
  IdVector<CellId, FaceId> largest(n_cells);
  for (const FaceId f : mesh.topo().faces()) {
    FaceId& best = largest[mesh.cell(f)];
    if (!best.valid() || area_of(mesh, f) > area_of(mesh, best)) best = f;
  }
  IdVector<CellId, Point> places(n_cells);
  for (std::size_t i = 0; i < n_cells; ++i)
    if (largest[CellId(i)].valid()) places[CellId(i)] = centre_of(mesh, largest[CellId(i)]);
  return places;
}

CellSet planned(const GridPlans& plans) {
  CellSet cells;
  for (std::size_t i = 0; i < plans.cells.count(); ++i)
    if (plans.cells[CellId(i)]) cells.insert(CellId(i));
  return cells;
}

bool is_halving(Method method) { return method == Method::Merge || method == Method::Split; }

// Where edges are halved a half of an arc would have to have an even number too.
void insert_beside_given(const Domain& domain, CellSet& cells) {
  for (const Domain::Curve& curve : domain.curves)
    for (const CellId c : {curve.left, curve.right})
      if (c.valid() && curve.edges % 4 != 0) cells.insert(c);
}

}  // namespace

FallbackPlan::FallbackPlan(Domain model, const Options& options, const Context& context, bool may_cut)
    : model_(std::move(model)), options_(options) {
  if (QuadLimit(options).refuse_expected(model_).empty()) {
    lay_out(context, may_cut);
  } else {
    domain_ = model_;
  }
  if (!options.size_at) symmetries_ = find_symmetries(domain_);
  rung_.assign(domain_.cells.count(), 0);
  why_.assign(domain_.cells.count(), {});
  for (const Domain::Cell& cell : domain_.cells) asked_.cells.push_back(cell.size);
  for (const Domain::Curve& curve : domain_.curves) asked_.curves.push_back(curve.size);
  for (const Domain::PointUse& point : domain_.points) asked_.points.push_back(point.size);
}

// Cells that are to become grids come out symmetric as they are, and stay whole. In the model too their circles are
// turned, as the mesh will be held against it. The paper's method knows no cuts.
void FallbackPlan::lay_out(const Context& context, bool may_cut) {
  Rehearsal rehearsal(context);
  const auto plan = [&](Domain& domain) {
    grids_ = plan_grids(domain, options_, [&](const Domain& turned, CellId c, const GridProposal& proposal) {
      return rehearsal.cost(turned, c, proposal);
    });
  };
  plan(model_);
  const bool cuts = may_cut && options_.method != Method::QMorph && !options_.size_at;
  CellSet whole = planned(grids_);
  if (is_halving(options_.method)) insert_beside_given(model_, whole);
  domain_ = cuts ? cut_at_axes(model_, whole) : model_;
  if (is_cut()) plan(domain_);  // curves got other numbers, and parts of cells may suit
}

Recipe FallbackPlan::recipe(CellId c) const {
  const bool is_front = options_.triangles != Triangles::Delaunay;
  Recipe recipe;
  recipe.method = options_.method == Method::Layout ? Method::QMorph : options_.method;
  if (!grids_.cells.empty() && grids_.cells[c]) recipe.grid = grids_.cells[c]->plan;
  if (recipe.grid.rings > 0) recipe.method = Method::QMorph;
  recipe.may_grid = (options_.method == Method::Layout || recipe.grid.rings > 0) && !is_changed(c);
  recipe.triangles = is_front != rung(c).other_triangles ? Triangles::Front : Triangles::Delaunay;
  recipe.lines = options_.lines;
  recipe.keeps_thin_quads = rung(c).is_halved;
  if (rung(c).is_halved && recipe.method == Method::QMorph) recipe.method = Method::Merge;
  recipe.may_retry = recipe.method == Method::QMorph && options_.triangles == Triangles::Both && !is_changed(c);
  return recipe;
}

bool FallbackPlan::advance(const std::vector<Trouble>& troubles) {
  if (++attempts_ > kMostAttempts) return false;
  std::vector<std::size_t> next;
  for (const Trouble& t : troubles)
    next.push_back(std::max(rung_[t.cell] + 1, t.is_thin || is_beside_halved(t.cell) ? kFirstHalving : 0));
  bool advanced = false;
  CellSet dropped;
  for (std::size_t i = 0; i < troubles.size(); ++i) {
    const CellId c = troubles[i].cell;
    if (troubles[i].is_grid) {
      dropped.insert(c);
      for (const Symmetry& symmetry : symmetries_) dropped.insert(symmetry.cells[c]);
      advanced = true;
      continue;
    }
    if (next[i] == std::size(kRungs)) continue;
    rung_[c] = next[i];
    dropped.insert(c);
    if (why_[c].empty()) why_[c] = troubles[i].reason;
    advanced = true;
    for (const Symmetry& symmetry : symmetries_) {
      const CellId image = symmetry.cells[c];
      rung_[image] = std::max(rung_[image], next[i]);
      dropped.insert(image);
      if (why_[image].empty()) why_[image] = troubles[i].reason;
    }
  }
  // A grid that is dropped changes the counts beside it, and so may cost the next one its own: that ends here.
  const bool is_grid = std::any_of(troubles.begin(), troubles.end(), [](const Trouble& t) { return t.is_grid; });
  if (is_grid && ++grid_failures_ > kMostGridFailures)
    for (std::size_t i = 0; i < grids_.cells.count(); ++i)
      if (const auto& grid = grids_.cells[CellId(i)]; grid && grid->plan.rings == 0) dropped.insert(CellId(i));
  if (!dropped.empty()) grids_.drop(dropped, domain_);
  if (advanced) set_sizes();
  return advanced;
}

CellSet FallbackPlan::halved_cells() const {
  CellSet cells;
  for (std::size_t i = 0; i < rung_.count(); ++i)
    if (const CellId c(i); recipe(c).method != Method::QMorph) cells.insert(c);
  return cells;
}

bool FallbackPlan::any_halved() const {
  return std::any_of(rung_.begin(), rung_.end(), [](std::size_t rung) { return kRungs[rung].is_halved; });
}

bool FallbackPlan::is_beside_halved(CellId c) const {
  for (const std::vector<DirectedCurve>& walk : domain_.cells[c].walks)
    for (const DirectedCurve& d : walk) {
      const Domain::Curve& curve = domain_.curves[d.curve];
      const CellId beside = d.reversed ? curve.left : curve.right;
      if (beside.valid() && beside != c && rung(beside).is_halved) return true;
    }
  return false;
}

// Always from the sizes as asked: rungs are no factors on each other.
void FallbackPlan::set_sizes() {
  const auto factor = [&](CellId c) { return c.valid() ? rung(c).refinement : 1; };
  IdVector<VertexId, double> at_vertex(domain_.vertices.count(), 1);
  for (std::size_t i = 0; i < domain_.cells.count(); ++i) {
    Domain::Cell& cell = domain_.cells[CellId(i)];
    cell.size = asked_.cells[i] * factor(CellId(i));
    for (const VertexId v : cell.lone_points) at_vertex[v] = factor(CellId(i));
  }
  for (std::size_t i = 0; i < domain_.curves.count(); ++i) {
    Domain::Curve& curve = domain_.curves[CurveId(i)];
    const double least = std::min(factor(curve.left), factor(curve.right));
    curve.size = asked_.curves[i] * least;
    for (const VertexId v : {curve.tail, curve.head}) at_vertex[v] = std::min(at_vertex[v], least);
  }
  for (std::size_t i = 0; i < domain_.points.size(); ++i)
    domain_.points[i].size = asked_.points[i] * at_vertex[domain_.points[i].vertex];
}

std::string FallbackPlan::name_of(CellId c) const {
  return "a cell of region '" + domain_.regions[domain_.cells[c].region] + "'";
}

void FallbackPlan::append_ringless(std::vector<Finding>& findings) const {
  for (std::size_t i = 0; i < domain_.cells.count(); ++i) {
    const Domain::Cell& cell = domain_.cells[CellId(i)];
    if (cell.rings == 0 || grids_.cells[CellId(i)]) continue;
    const CurveId inner = cell.walks[1][0].curve;
    const auto path = std::find_if(domain_.paths.begin(), domain_.paths.end(), [&](const Domain::Path& p) {
      return std::any_of(p.curves.begin(), p.curves.end(), [&](DirectedCurve d) { return d.curve == inner; });
    });
    findings.push_back({"'" + path->name +
                            "' gets no rings: its edges are not those of the circle round them; ask for " +
                            "another number of edges",
                        path->where, domain_.curves[inner].piece.a, true});
  }
}

std::vector<Finding> FallbackPlan::findings(const WorkMesh& mesh) const {
  std::vector<Finding> found;
  append_ringless(found);
  if (std::all_of(rung_.begin(), rung_.end(), [](std::size_t rung) { return rung == 0; })) return found;
  const IdVector<CellId, Point> places = places_in_cells(mesh, rung_.count());
  for (std::size_t i = 0; i < rung_.count(); ++i) {
    const CellId c(i);
    if (rung_[c] == 0) continue;
    found.push_back({name_of(c) + " is meshed " + rung(c).what + ", because as asked " + why_[c], {}, places[c]});
  }
  return found;
}

std::vector<Finding> FallbackPlan::failures(const std::vector<Trouble>& troubles) const {
  std::vector<Finding> found;
  for (const Trouble& t : troubles)
    found.push_back({name_of(t.cell) + " has no valid mesh, whatever was tried: " + t.reason, {}, t.at});
  return found;
}

}  // namespace quadline
