#pragma once

#include <vector>

#include "domain/domain.hpp"

namespace quadline {

/// How many quads fit into the corner before each curve of a walk, by its angle.
std::vector<int> quads_along(const Domain& domain, const std::vector<DirectedCurve>& walk);

/// Right angles that a walk turns by to the left, as its quads count them: 4 round a rectangle, 6 round a hexagon.
int turns(const std::vector<int>& quads);

}  // namespace quadline
