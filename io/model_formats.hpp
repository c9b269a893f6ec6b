#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "quadline/json.hpp"
#include "quadline/model.hpp"

namespace quadline {

// The formats of `read_model`, from memory; JSON stands in quadline/json.hpp. docs/input.md describes them.

/// Triangle's planar straight-line graph. Its boundary loops become outer loops and holes, all other
/// segments lines; it has no target size, so Model::size is 0.
/// @param file  beside it stands the .node file, where the vertices are not in the text.
/// @throws InputError  with the line.
Model read_model_poly(std::string_view text, const std::filesystem::path& file);

}  // namespace quadline
