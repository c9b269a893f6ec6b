#pragma once

#include <optional>

#include "domain/domain.hpp"
#include "geom/element.hpp"
#include "quadline/context.hpp"
#include "quadline/failure.hpp"
#include "quadline/mesh.hpp"

namespace quadline {

/// Counter-clockwise, strictly convex (exactly), and not so flat that it is of no use to a solver.
bool is_sound(const QuadPoints& quad);

/// Checks every promise on the flat mesh, without the connectivity that made it.
///
/// All quads, counter-clockwise, strictly convex; conforming (an edge has two faces, or one on the boundary); the area
/// is the domain's; every curve is covered by mesh edges from end to end, in order, with its nodes on it; every vertex
/// and point constraint is a node.
///
/// @return  the first broken promise; empty when all are kept. Cost O(n log n).
std::optional<Failure> verify(const Mesh& mesh, const Domain& domain, Context& context);

}  // namespace quadline
