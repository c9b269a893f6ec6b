#pragma once

#include <filesystem>

#include "quadline/model.hpp"

namespace quadline {

/// Reads a model; the format follows the extension: .json (model v1) or .poly (Triangle).
///
/// @throws InputError  the file cannot be read or is wrong; names the file, the JSON path or line, and the coordinates.
Model read_model(const std::filesystem::path& file);

}  // namespace quadline
