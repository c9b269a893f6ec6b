#pragma once

#include "domain/size_field.hpp"
#include "mesh/work_mesh.hpp"
#include "quadline/context.hpp"

namespace quadline {

/// Topological clean-up: local edits that bring the valences nearer to the ideal [Canann1998, Kinney1997].
///
/// @pre, @post  quads only; every constraint is an edge.
void clean_up(WorkMesh& mesh, const SizeField& size, Context& context);

}  // namespace quadline
