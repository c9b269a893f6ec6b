#pragma once

#include <optional>
#include <string>
#include <vector>

#include "domain/domain.hpp"
#include "mesh/work_mesh.hpp"

namespace quadline {

/// A cell where a mesh breaks the promise.
struct Trouble {
  CellId cell;
  std::string reason;  ///< one line
  Point at;
  bool is_thin = false;  ///< a quad there is so thin that the drawing must be: only halving helps
  bool is_grid = false;  ///< its planned grid does not come out: without it, it may
};

/// The cells where a quad is not sound or a triangle is left, each with the first such place; in the order of the
/// cells.
std::vector<Trouble> unsound_cells(const WorkMesh& mesh);

/// The cells at a place: those beside the curves within the tolerance of it, else the one that holds it; all cells
/// where there is none, or the place is unknown.
std::vector<Trouble> troubles_at(const Domain& domain, std::optional<Point> place, const std::string& reason);

}  // namespace quadline
