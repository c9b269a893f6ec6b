#pragma once

#include "domain/domain.hpp"
#include "mesh/work_mesh.hpp"

namespace quadline {

/// Fills a disk with a square grid in the middle and rings of quads round it, between the circle and the rim of the
/// grid: four nodes of three quads, opposite to the ends of the two arcs and halfway between.
///
/// @param mesh  nodes and segments of the cell; gets its quads, which may not be sound.
/// @param rings  > 0.
/// @return  false where the edges round the circle are no multiple of four; `mesh` stays as it is.
/// @pre  the cell has one walk, along a whole circle, and nothing inside.
/// Cost O(n) for n quads.
bool fill_disk(WorkMesh& mesh, const Domain& domain, CellId c, int rings);

}  // namespace quadline
