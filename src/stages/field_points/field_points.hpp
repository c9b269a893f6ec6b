#pragma once

#include "domain/size/size_field.hpp"
#include "mesh/work_mesh.hpp"
#include "quadline/context.hpp"
#include "quadline/options.hpp"

namespace quadline {

/// Fills the cells with nodes at the distance of the local size; the triangulation stays constrained Delaunay.
///
/// @param triangles  Delaunay: edges subdivided after the local size, filtered, inserted, until no edge is too long
///                   [BorouchakiGeorge1997]; Front, Both: an advancing front from the constraints inwards.
/// @post  no face outside the domain is left, no constraint was split.
/// Cost O(n log n).
void insert_field_points(WorkMesh& mesh, const SizeField& size, Triangles triangles, Context& context);

}  // namespace quadline
