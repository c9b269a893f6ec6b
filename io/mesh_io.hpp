#pragma once

#include <filesystem>

#include "quadline/mesh.hpp"
#include "quadline/quality.hpp"

namespace quadline {

/// Writes a mesh; the format follows the extension: .vtu, .msh, .inp, .svg or .json.
///
/// The file is written beside its target and renamed, so that a failure leaves what stood there.
///
/// @throws InputError   the extension is unknown.
/// @throws OutputError  the file cannot be written; what stood there before still stands.
void write_mesh(const Mesh& mesh, const std::filesystem::path& file);

/// Reads a mesh: .vtu, .vtk, .msh (2.2 and 4.1, text and binary), .inp or .json, told apart by what the file holds.
///
/// Quads and triangles are kept, turned over where the mesh is seen from below; two-node elements become curves where
/// they are named; names of regions, curves and node sets are restored as far as the format has them.
/// @throws InputError  the file cannot be read or holds no mesh in a plane z = constant.
Mesh read_mesh(const std::filesystem::path& file);

/// True where `write_mesh` knows the extension.
bool is_mesh_format(const std::filesystem::path& file);

}  // namespace quadline
