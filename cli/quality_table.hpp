#pragma once

#include <string>
#include <vector>

#include "quadline/quality.hpp"

namespace quadline {

/// The few figures that tell whether a mesh is good, before and after smoothing.
std::string before_and_after(const Quality& before, const Quality& after);

/// Every measure with its percentiles.
std::string quality_table(const Quality& quality);

/// The least scaled Jacobian against what the corners of the model allow; empty where they allow right angles.
std::string corner_line(const std::vector<CellCorner>& corners, const Quality& quality);

/// The lines among the curves, the worst by least beta first; of many the first ten. Empty without lines.
std::string line_table(std::vector<LineQuality> lines);

}  // namespace quadline
