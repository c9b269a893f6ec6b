#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "quadline/mesh.hpp"
#include "quadline/quality.hpp"

namespace quadline {

/// A mesh file to write.
struct MeshFile {
  std::filesystem::path path;
  std::string format;  ///< "vtu", "msh", "inp", "svg" or "json"
};

/// "plate.msh": the format follows the extension, in small or capital letters. "msh:/dev/stdout": it is named, for what
/// has no extension. A file whose name starts like that is told by its folder: "./msh:plate.vtu".
/// Nothing where the extension is unknown.
std::optional<MeshFile> find_mesh_file(const std::string& text);

/// As find_mesh_file.
/// @throws InputError  the extension is unknown.
MeshFile mesh_file(const std::string& text);

/// Writes a mesh.
///
/// The file is written beside its target and renamed, so that a failure leaves what stood there.
///
/// @throws OutputError  the file cannot be written; what stood there before still stands.
void write_mesh(const Mesh& mesh, const MeshFile& file);

/// Reads a mesh: .vtu, .vtk, .msh (2.2 and 4.1, text and binary), .inp or .json, told apart by what the file holds.
///
/// Quads and triangles are kept, turned over where the mesh is seen from below; two-node elements become curves where
/// they are named; names of regions, curves and node sets are restored as far as the format has them.
/// @throws InputError  the file cannot be read or holds no mesh in a plane z = constant.
Mesh read_mesh(const std::filesystem::path& file);

}  // namespace quadline
