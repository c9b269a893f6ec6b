#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "quadline/point.hpp"
#include "quadline/report.hpp"

namespace quadline {

/// Prints on standard output.
/// @throws OutputError  it cannot be written.
void print(std::string_view text);

/// Prints "quadline: text" as one line on standard error.
void complain(std::string_view text);

/// Prints what was found, a line each on standard error; of a great many the first ones.
/// @param only_losses  what is in the mesh all the same is passed over.
void print_findings(const std::vector<Finding>& findings, const std::string& file, bool only_losses);

/// "warning: " for what the mesh lacks, "note: " for what was mended.
std::string loudness(const Finding& finding);

/// The number with `digits` digits behind the point.
std::string fixed(double value, int digits);

/// The number with `digits` significant digits at most.
std::string rounded(double value, int digits);

/// "1 hole", "2 holes".
std::string counted(std::size_t n, const char* one, const char* many);

/// A table of text: columns are as wide as their widest cell, the first to the left, the others to the right.
std::string aligned(const std::vector<std::vector<std::string>>& rows);

}  // namespace quadline
