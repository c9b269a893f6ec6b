#include "cells/trouble.hpp"

#include <algorithm>

#include "base/constants.hpp"
#include "cells/thin_quads.hpp"
#include "domain/cell_locator.hpp"
#include "domain/cell_set.hpp"

namespace quadline {

namespace {

constexpr double kThinShape = 0.03;  // least over greatest distance between two corners of a quad

bool is_thin(const WorkMesh& mesh, FaceId f) {
  const Polygon p = mesh.topo().polygon(f);
  double least2 = kInfinity, most2 = 0;
  for (int i = 0; i < p.n; ++i)
    for (int k = 0; k < i; ++k) {
      const double apart2 = norm2(mesh.point(p.nodes[i]) - mesh.point(p.nodes[k]));
      least2 = std::min(least2, apart2);
      most2 = std::max(most2, apart2);
    }
  return least2 < kThinShape * kThinShape * most2;
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

}  // namespace quadline
