#pragma once

#include "mesh/work_mesh.hpp"
#include "quadline/context.hpp"

namespace quadline {

/// Merges pairs of triangles to quads, the best pairs first; some triangles stay alone.
///
/// Quads that are there stay.
///
/// @post  every new quad is convex; every constraint is an edge still.
/// @throws Cancelled when `context` asks for it.
/// Cost O(n log n). Source: [Lo1989, Rank1993].
/// Limits: greedy, so that more triangles stay than with the best matching.
void pair_triangles(WorkMesh& mesh, Context& context);

}  // namespace quadline
