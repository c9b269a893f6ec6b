#pragma once

#include <string>
#include <string_view>

#include "quadline/mesh.hpp"
#include "quadline/model.hpp"

namespace quadline {

// The library quadline::json: models and meshes as JSON in memory, with no file opened and no other library needed.

/// Reads a model from the JSON of model v1 (schema/model.schema.json). Numbers are checked to be numbers, not to
/// make sense: that is for `generate`. Model::size is 0 where none is given.
/// @param file  what messages call the text.
/// @throws InputError  (FileSyntax) with the JSON path, or line and column where the text is no JSON.
Model read_model_json(std::string_view text, const std::string& file = {});

/// The whole Mesh as JSON, "quadline-mesh" version 1 (docs/output.md).
/// @pre  the arrays fit each other.
std::string to_mesh_json(const Mesh& mesh);

/// Reads such a mesh back, as it was.
/// @param file  what messages call the text.
/// @throws InputError  (FileSyntax) with the JSON path, or line and column where the text is no JSON.
Mesh parse_mesh_json(std::string_view bytes, const std::string& file = {});

}  // namespace quadline
