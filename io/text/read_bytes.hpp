#pragma once

#include <filesystem>
#include <string>

namespace quadline {

/// The bytes of a whole file.
/// @throws InputError  it cannot be read: says why.
std::string read_bytes(const std::filesystem::path& file);

}  // namespace quadline
