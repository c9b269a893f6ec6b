#pragma once

#include <vector>

#include "domain/domain.hpp"
#include "quadline/mesh.hpp"
#include "quadline/report.hpp"

namespace quadline {

/// Appends a finding for each circle that has another number of edges than it asks for: where cells are halved the
/// number must be a multiple of four, and beside other curves short chords may have to be halved.
/// @pre the mesh has the paths of the domain.
void append_missed_edges(const Domain& domain, const Mesh& mesh, std::vector<Finding>& findings);

}  // namespace quadline
