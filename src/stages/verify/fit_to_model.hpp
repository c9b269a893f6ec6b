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

/// The domain with the ends of the arcs of every whole circle at the nearest nodes of the mesh on it, where it has two:
/// nothing of the model is there, and a mesh need not have nodes just east and west of a centre.
/// Cost O((n + m) log n) for n nodes and m nodes near circles.
Domain with_circles_turned_to(const Mesh& mesh, Domain domain);

}  // namespace quadline
