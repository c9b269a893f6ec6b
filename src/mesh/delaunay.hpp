#pragma once

#include <vector>

#include "mesh/work_mesh.hpp"

namespace quadline {

/// Finds the triangle that holds p by a walk from `near`, with exact orientation tests [Devillers2002].
///
/// @pre  the mesh is a convex triangulation (box included) that holds p.
/// @return  the triangle; p may lie on its rim.
FaceId locate(const WorkMesh& mesh, Point p, FaceId near);

/// Inserts the isolated node v into the triangle `f` that holds it, and restores the constrained Delaunay property by
/// swaps; constraints stay.
///
/// @return  false, and nothing changed, where v lies on a constraint edge or on another node.
bool insert_node(WorkMesh& mesh, NodeId v, FaceId f);

/// Swaps the edges of `suspects`, and what follows from it, until all are locally Delaunay, constraints, or edges of
/// quads [Lawson1977]. Ties stay as they are. `suspects` is empty afterwards.
void restore_delaunay(WorkMesh& mesh, std::vector<EdgeId>& suspects);

}  // namespace quadline
