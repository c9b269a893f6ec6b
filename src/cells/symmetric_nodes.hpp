#pragma once

#include <vector>

#include "domain/domain.hpp"
#include "domain/symmetry/symmetries.hpp"
#include "mesh/work_mesh.hpp"

namespace quadline {

/// Makes the nodes on curves as symmetric as the domain: all curves of an orbit get those of one of them. Round every
/// cell the number of edges stays even.
///
/// With mirror images that one is chosen so that a cell on one side of all axes keeps its curves. In the others, curves
/// come in pairs but for those that an axis crosses in the middle; where the number of edges of these is odd together,
/// each gets an even one. Turns alone know no sides: where they would make a cell odd, all stays as it was.
///
/// @param nodes      as `discretize` gives them.
/// @param is_halved  curves whose edges count as two.
/// Cost O(n log n) for n nodes.
WorkMesh symmetric_nodes(WorkMesh nodes, const Domain& domain, const std::vector<Symmetry>& symmetries,
                         const IdVector<CurveId, bool>& is_halved);

}  // namespace quadline
