#pragma once

#include <string>
#include <vector>

#include "quadline/criteria.hpp"
#include "quadline/quality.hpp"

namespace quadline {

/// What fails of the limits called `name`: a line for each limit, and one for each of its worst quads.
std::string criteria_table(const std::string& name, const CriteriaResult& result);

/// A line for each of the worst quads, and one before them.
std::string worst_table(const std::vector<WorstQuad>& worst);

}  // namespace quadline
