#pragma once

#include <vector>

#include "domain/domain.hpp"
#include "mesh/work_mesh.hpp"
#include "quadline/context.hpp"

namespace quadline {

/// Halves every edge of a mesh of triangles and quads: a quad becomes four, a triangle three round its centroid.
///
/// The middle of an edge on a curve lies on the curve. Quads that are not convex, or nearly so, are cut into two
/// triangles first, where a diagonal lies inside.
///
/// @pre   every constraint is an edge between nodes of its curve.
/// @post  quads only, edges half as long, conforming whatever the number of edges round the cells. All are convex where
///        the curves do not bend much over an edge; ends compact.
/// @throws Cancelled when `context` asks for it.
/// Cost O(n log n). Source: [Rank1993].
void halve(WorkMesh& mesh, const Domain& domain, Context& context);

/// Halves the segments of some curves, before there are faces: with the very nodes that `halve` puts there.
void halve_segments(WorkMesh& mesh, const Domain& domain, const std::vector<CurveId>& curves);

}  // namespace quadline
