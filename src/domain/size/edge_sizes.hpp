#pragma once

#include <vector>

#include "domain/size/size_field.hpp"
#include "quadline/mesh.hpp"

namespace quadline {

/// Target sizes at the middles of the edges, in the order of `edges_of(mesh)`.
std::vector<double> edge_sizes(const Mesh& mesh, const SizeField& size);

}  // namespace quadline
