#pragma once

#include "domain/domain.hpp"
#include "domain/size/size_field.hpp"
#include "mesh/work_mesh.hpp"

namespace quadline {

/// Whether a cell keeps its grid: all quads are sound and of good shape, as far as the corners of the cell let them,
/// and edges are near the sizes. O(n log n).
bool is_good_grid(const WorkMesh& mesh, const Domain& domain, const SizeField& size);

}  // namespace quadline
