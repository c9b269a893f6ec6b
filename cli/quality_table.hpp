#pragma once

#include <string>

#include "quadline/quality.hpp"

namespace quadline {

/// The few figures that tell whether a mesh is good, before and after smoothing.
std::string before_and_after(const Quality& before, const Quality& after);

/// Every measure with its percentiles.
std::string quality_table(const Quality& quality);

}  // namespace quadline
