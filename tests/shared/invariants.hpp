#pragma once

#include <string>
#include <vector>

#include "quadline/mesh.hpp"
#include "quadline/model.hpp"

namespace quadline {

/// What a mesh owes its model, found again from the flat arrays alone; one line for everything that does not hold.
///
/// Strictly convex quads; every edge between two quads, or on a loop; the loops closed, and around the area of the
/// quads; Euler's formula; lines of straight pieces covered in their full length (where they stay inside) with their
/// nodes on them; named points at their places.
std::vector<std::string> broken(const Model& model, const Mesh& mesh, bool lines_stay_inside);

}  // namespace quadline
