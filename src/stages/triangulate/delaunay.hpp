#pragma once

#include <vector>

#include "mesh/work_mesh.hpp"

namespace quadline {

/// Finds the triangle that holds p by a walk from `near`, with exact orientation tests [Devillers2002].
///
/// @pre  the mesh is a convex triangulation (box included) that holds p.
/// @return  the triangle; p may lie on its rim.
FaceId locate(const WorkMesh& mesh, Point p, FaceId near);

/// Inserts a free node at p and restores the constrained Delaunay property by swaps; constraints stay.
///
/// @return  the node; invalid, and nothing changed, where p lies on a constraint edge or on a node.
NodeId insert_point(WorkMesh& mesh, Point p, FaceId near);

/// Swaps the edges of `suspects` and what follows from it until all are locally Delaunay or constraints [Lawson1977].
void restore_delaunay(WorkMesh& mesh, std::vector<EdgeId>& suspects);

}  // namespace quadline
