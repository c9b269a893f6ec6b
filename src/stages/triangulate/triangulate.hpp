#pragma once

#include "domain/domain.hpp"
#include "mesh/work_mesh.hpp"
#include "quadline/context.hpp"

namespace quadline {

/// Constrained Delaunay triangulation of the nodes and segments of the mesh.
///
/// Incremental insertion in spatial order with Lawson's swaps, segments recovered by edge swaps [Sloan1993], exact
/// predicates. Four nodes of a box far round the domain are added, so that the triangulation is convex and every walk
/// ends; faces outside the domain have no cell, until `drop_outside` takes them and the box away.
///
/// @pre   no two segments cross, no node lies inside another's segment (up to rounding: a node within rounding of a
///        segment is handled).
/// @post  every segment is an edge with its curve; every face inside has its cell; Delaunay but for constraints.
/// Cost O(n log n).
void triangulate(WorkMesh& mesh, const Domain& domain, Context& context);

}  // namespace quadline
