#pragma once

#include <vector>

#include "domain/domain.hpp"
#include "quadline/mesh.hpp"
#include "quadline/report.hpp"

namespace quadline {

/// Appends a finding for each circle that has another number of edges than the model asks for.
/// @pre the mesh has the paths of the domain.
/// O(n) for n curves of the domain.
void append_missed_edges(const Domain& domain, const Mesh& mesh, std::vector<Finding>& findings);

}  // namespace quadline
