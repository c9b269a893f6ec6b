#pragma once

#include <filesystem>
#include <optional>

#include "quadline/model.hpp"

namespace quadline {

/// Reads a model; the format follows the extension: .json (model v1) or .poly (Triangle).
///
/// @param size  a target size that the caller has, model units: the largest areas of a .poly give way to it.
/// @throws InputError  the file cannot be read or is wrong; names the file, the JSON path or line, and the coordinates.
Model read_model(const std::filesystem::path& file, std::optional<double> size = {});

}  // namespace quadline
