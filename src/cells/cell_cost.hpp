#pragma once

#include "mesh/work_mesh.hpp"

namespace quadline {

/// What is wrong with the quads of one cell: its irregular nodes plus a tenth of the sum of 1 - beta; a quad that is
/// not convex is worse than all that. O(n).
double cell_cost(const WorkMesh& part);

/// A cell with nodes of too many and nodes of too few quads: some of them might cancel, in another mesh of the cell.
/// (The sum of the differences is given by the corners and holes of a cell, so nodes of one kind alone have to be.)
/// A large cell is none: there luck evens out. O(n).
bool is_improvable(const WorkMesh& part);

}  // namespace quadline
