#pragma once

#include <string>

#include "quadline/criteria.hpp"

namespace quadline {

/// What fails of the limits called `name`: a line for each limit, and one for each of its worst quads.
std::string criteria_table(const std::string& name, const CriteriaResult& result);

}  // namespace quadline
