#pragma once

#include "domain/cell_set.hpp"
#include "mesh/work_mesh.hpp"

namespace quadline {

/// Cells with nodes of too many and nodes of too few quads: some of them might cancel, in another mesh of the cell.
/// (The sum of the differences is given by the corners and holes of a cell, so nodes of one kind alone have to be.)
/// Large cells are left out: there luck evens out. So are those of `but`.
CellSet improvable_cells(const WorkMesh& mesh, const CellSet& but);

/// Makes all other cells outside; `WorkMesh::drop_outside` removes them.
void keep_cells(WorkMesh& mesh, const CellSet& cells);

/// The cells where `other` is better: where the number of irregular nodes plus a tenth of the sum of 1 - beta is less.
/// A quad that is not convex is worse than all that. @param other  may have some of the cells only.
CellSet better_cells(const WorkMesh& mesh, const WorkMesh& other);

/// The mesh with the faces of `other` in some cells.
///
/// @pre  quads only; where `other` has cells, both have the same nodes on the curves.
/// Cost O(n log n).
WorkMesh joined(const WorkMesh& mesh, const WorkMesh& other, const CellSet& of_other);

}  // namespace quadline
