#pragma once

#include "mesh/work_mesh.hpp"

namespace quadline {

/// Puts meshes of single cells together at the nodes that they share on curves. What is frozen stays so.
///
/// @pre  nodes of two parts at one place of a curve have the same tag, but for its kind. Where two parts have other
///       nodes on a curve between them, the mesh has a crack there, and the constraints of one side.
/// Cost O(n log n).
WorkMesh joined(const IdVector<CellId, const WorkMesh*>& parts);

}  // namespace quadline
