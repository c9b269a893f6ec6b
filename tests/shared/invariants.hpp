#pragma once

#include <string>
#include <vector>

#include "quadline/mesh.hpp"
#include "quadline/model.hpp"

namespace quadline {

/// What a mesh owes its model, found again from the flat arrays alone; one line for everything that does not hold.
///
/// Strictly convex quads; every edge between two quads, or on a loop; the loops closed, and around the area of the
/// quads; Euler's formula; lines and arcs covered from end to end, where they are in the domain, by edges along them;
/// named points at their places. For models of an extent near 10 whose loops do not meet.
std::vector<std::string> broken(const Model& model, const Mesh& mesh);

/// Of these what holds of every mesh, wherever loops meet: the quads and the edges.
std::vector<std::string> broken(const Mesh& mesh);

}  // namespace quadline
