#pragma once

#include "domain/domain.hpp"
#include "mesh/work_mesh.hpp"
#include "quadline/mesh.hpp"

namespace quadline {

/// The working mesh as flat arrays, with the names of the model: regions, curves, points.
Mesh flatten(const WorkMesh& mesh, const Domain& domain);

}  // namespace quadline
