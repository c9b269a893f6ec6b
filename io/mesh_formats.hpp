#pragma once

#include <string>
#include <string_view>

#include "quadline/json.hpp"
#include "quadline/mesh.hpp"

namespace quadline {

// The formats of `write_mesh` and `read_mesh`, to and from memory; those of JSON stand in quadline/json.hpp.
// docs/output.md describes them.

std::string to_vtu(const Mesh& mesh);  ///< VTK XML unstructured grid, appended raw, zlib-compressed
std::string to_msh(const Mesh& mesh);  ///< Gmsh 4.1, text
std::string to_inp(const Mesh& mesh);  ///< Abaqus and CalculiX

/// Each reader throws InputError for what it cannot read, with `file` and the line or byte.
/// Memory stays within a fixed multiple of the bytes given, whatever counts they claim.
Mesh parse_vtu(std::string_view bytes, const std::string& file);
Mesh parse_vtk(std::string_view bytes, const std::string& file);  ///< legacy VTK, text and binary: no names
Mesh parse_msh(std::string_view bytes, const std::string& file);  ///< 2.2 and 4.1, text and binary
Mesh parse_inp(std::string_view bytes, const std::string& file);

}  // namespace quadline
