#include "cells/fallback.hpp"

#include <algorithm>
#include <limits>

#include "cells/thin_quads.hpp"
#include "domain/cell_locator.hpp"
#include "domain/cell_set.hpp"

namespace quadline {

namespace {

constexpr std::size_t kMostAttempts = 24;
constexpr double kThin = 0.03;  // least over greatest distance between two corners of a quad

double area_of(const WorkMesh& mesh, FaceId f) {
  const QuadPoints p = mesh.quad_points(f);
  return 0.5 * cross(p[2] - p[0], p[3] - p[1]);
}

bool is_thin(const WorkMesh& mesh, FaceId f) {
  const Polygon p = mesh.topo().polygon(f);
  double least2 = std::numeric_limits<double>::infinity(), most2 = 0;
  for (int i = 0; i < p.n; ++i)
    for (int k = 0; k < i; ++k) {
      const double apart2 = norm2(mesh.point(p.nodes[i]) - mesh.point(p.nodes[k]));
      least2 = std::min(least2, apart2);
      most2 = std::max(most2, apart2);
    }
  return least2 < kThin * kThin * most2;
}

// The middle of the largest quad of each cell.
IdVector<CellId, Point> places_in_cells(const WorkMesh& mesh, std::size_t n_cells) {
  IdVector<CellId, FaceId> largest(n_cells);
  for (std::size_t i = 0; i < mesh.topo().face_capacity(); ++i) {
    const FaceId f(i);
    if (!mesh.topo().is_live(f)) continue;
    FaceId& best = largest[mesh.cell(f)];
    if (!best.valid() || area_of(mesh, f) > area_of(mesh, best)) best = f;
  }
  IdVector<CellId, Point> places(n_cells);
  for (std::size_t i = 0; i < n_cells; ++i)
    if (largest[CellId(i)].valid()) places[CellId(i)] = centre_of(mesh, largest[CellId(i)]);
  return places;
}

}  // namespace

std::vector<Trouble> unsound_cells(const WorkMesh& mesh) {
  std::vector<Trouble> found;
  for (const FaceId f : unsound_faces(mesh))
    found.push_back({mesh.cell(f), "a quad is not convex, or flat", centre_of(mesh, f), is_thin(mesh, f)});
  std::stable_sort(found.begin(), found.end(), [](const Trouble& t, const Trouble& u) {
    return t.cell != u.cell ? t.cell < u.cell : t.is_thin > u.is_thin;
  });
  const auto is_same = [](const Trouble& t, const Trouble& u) { return t.cell == u.cell; };
  found.erase(std::unique(found.begin(), found.end(), is_same), found.end());
  return found;
}

std::vector<Trouble> troubles_at(const Domain& domain, std::optional<Point> place, const std::string& reason) {
  CellSet cells;
  if (place) {
    for (const Domain::Curve& curve : domain.curves) {
      if (distance(point_at(curve.piece, project(curve.piece, *place)), *place) > domain.tolerance) continue;
      for (const CellId c : {curve.left, curve.right})
        if (c.valid()) cells.insert(c);
    }
    if (cells.empty())
      if (const CellId c = CellLocator(domain).at(*place); c.valid()) cells.insert(c);
  }
  const bool all = cells.empty();
  std::vector<Trouble> troubles;
  for (std::size_t i = 0; i < domain.cells.count(); ++i)
    if (all || cells.contains(CellId(i))) troubles.push_back({CellId(i), reason, place.value_or(domain.box.lo)});
  return troubles;
}

bool FallbackPlan::advance(const std::vector<Trouble>& troubles) {
  if (++attempts_ > kMostAttempts) return false;
  std::vector<std::size_t> next;
  for (const Trouble& t : troubles)
    next.push_back(std::max(rung_[t.cell] + 1, t.is_thin || is_beside_halved(t.cell) ? kFirstHalving : 0));
  bool advanced = false;
  for (std::size_t i = 0; i < troubles.size(); ++i) {
    const CellId c = troubles[i].cell;
    if (next[i] == std::size(kRungs)) continue;
    rung_[c] = next[i];
    if (why_[c].empty()) why_[c] = troubles[i].reason;
    advanced = true;
  }
  return advanced;
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

Domain FallbackPlan::domain() const {
  Domain domain = domain_;
  const auto factor = [&](CellId c) { return c.valid() ? rung(c).refinement : 1; };
  IdVector<VertexId, double> at_vertex(domain.vertices.count(), 1);
  for (std::size_t i = 0; i < domain.cells.count(); ++i) {
    Domain::Cell& cell = domain.cells[CellId(i)];
    cell.size *= factor(CellId(i));
    for (const VertexId v : cell.lone_points) at_vertex[v] = factor(CellId(i));
  }
  for (Domain::Curve& curve : domain.curves) {
    const double least = std::min(factor(curve.left), factor(curve.right));
    curve.size *= least;
    for (const VertexId v : {curve.tail, curve.head}) at_vertex[v] = std::min(at_vertex[v], least);
  }
  for (Domain::PointUse& point : domain.points) point.size *= at_vertex[point.vertex];
  return domain;
}

std::string FallbackPlan::name_of(CellId c) const {
  return "a cell of region '" + domain_.regions[domain_.cells[c].region] + "'";
}

std::vector<Finding> FallbackPlan::findings(const WorkMesh& mesh) const {
  std::vector<Finding> found;
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
