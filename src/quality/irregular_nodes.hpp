#pragma once

#include <cstdint>
#include <vector>

#include "quadline/mesh.hpp"
#include "quality/mesh_edges.hpp"

namespace quadline {

/// 1 for every irregular node: an inner one without four faces, one on a curve with a wedge that does not hold the
/// number of faces that suits it (`quads_off`).
/// @param edges  of the mesh.
/// Cost O(edges).
std::vector<std::uint8_t> irregular_nodes(const Mesh& mesh, const MeshEdges& edges);

}  // namespace quadline
