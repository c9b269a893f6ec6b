#pragma once

#include "domain/domain.hpp"
#include "domain/symmetry/symmetries.hpp"
#include "mesh/work_mesh.hpp"

namespace quadline {

/// Where a symmetry of the domain takes the nodes of its mesh, by the connectivity: from the nodes on curves, which
/// go to their like in order, on whole circles by place, over the edges of the faces. Invalid where the mesh is not
/// symmetric. O(n log n).
IdVector<NodeId, NodeId> images_of(const WorkMesh& mesh, const Domain& domain, const Symmetry& symmetry);

}  // namespace quadline
