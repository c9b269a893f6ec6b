#pragma once

#include <cstdint>
#include <vector>

#include "quadline/mesh.hpp"
#include "quality/mesh_sides.hpp"

namespace quadline {

/// 1 for every irregular node: an inner one without four faces, one on a curve with a wedge that does not hold
/// round(angle / 90) faces (within 2 degrees of a rounding limit either number is right).
/// @param sides  sorted_sides(mesh)
/// Cost O(sides log curve edges).
std::vector<std::uint8_t> irregular_nodes(const Mesh& mesh, const std::vector<Side>& sides);

}  // namespace quadline
