#pragma once

#include <vector>

#include "random_models.hpp"

namespace quadline {

/// Families for the soak: those of `families()`, and wilder ones, of which some models may be refused.
const std::vector<Family>& wild_families();

}  // namespace quadline
