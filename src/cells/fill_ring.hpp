#pragma once

#include "domain/domain.hpp"
#include "mesh/work_mesh.hpp"

namespace quadline {

/// Makes a row of quads of a ring, frozen, between nodes on the same rays.
/// @param mesh  in: the nodes and segments of the cell, no faces.
/// @return  false, and nothing done, where the two circles have different numbers of nodes. O(n).
bool fill_ring(WorkMesh& mesh, const Domain& domain, CellId cell);

}  // namespace quadline
