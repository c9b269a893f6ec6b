#pragma once

#include "domain/size/size_field.hpp"
#include "mesh/work_mesh.hpp"
#include "quadline/context.hpp"
#include "stages/cleanup/templates.hpp"

namespace quadline {

/// Topological clean-up: local edits that bring the number of quads round each node nearer to the ideal.
///
/// Constraint edges stay, and so do the nodes on curves, where they are. Free nodes are moved, made and removed. Takes
/// inverted and concave quads, and doublets. Ends compact.
///
/// @param size       target edge lengths, which the edits respect.
/// @param templates  what cavities are filled with: only read, so one will do for all meshes and threads.
/// @pre   quads only; every constraint is an edge.
/// @post  the same; every edit has lowered the sum of the valence costs and of what is not convex.
/// @throws Cancelled when `context` asks for it: the mesh is sound then, but not compact.
/// Cost O(n log n). Limits: the numbers of edges along curves are given, so irregular nodes that they force remain.
/// Source: [Kinney1997, Canann1998, Bunin2006, Reberol2021]; docs/clean-up.md says where we differ.
void clean_up(WorkMesh& mesh, const SizeField& size, const cleanup::TemplateTable& templates, Context& context);

}  // namespace quadline
