#pragma once

#include <filesystem>
#include <vector>

namespace quadline {

/// The file is what standard output goes to.
bool is_standard_output(const std::filesystem::path& file);

/// One file under two names: by links, or by spelling where it is not there yet. Devices other than standard output
/// take anything, and are no files.
bool is_same_file(const std::filesystem::path& a, const std::filesystem::path& b);

/// The files that a model is read from: its own, and the vertices of a .poly.
std::vector<std::filesystem::path> files_of_model(const std::filesystem::path& model);

/// @throws InputError  `output` is one of the files that are read.
void refuse_overwriting(const std::filesystem::path& output, const std::vector<std::filesystem::path>& inputs);

}  // namespace quadline
