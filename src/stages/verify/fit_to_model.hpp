#pragma once

#include "domain/domain.hpp"
#include "quadline/mesh.hpp"

namespace quadline {

/// Finds a model's curves and points in a mesh by their place, whatever the mesh calls them: so that `verify` can judge
/// meshes from files, which lose directions and names, and of other programs.
///
/// @return  the mesh with the curves and node sets of the domain, as far as there are nodes and edges for them; nodes
///          within the tolerance of a vertex are moved onto it.
/// Cost O((n + m) log n) for n nodes and m nodes on curves.
Mesh fit_to_model(Mesh mesh, const Domain& domain);

}  // namespace quadline
