#pragma once

#include <array>

#include "geom/element.hpp"
#include "quadline/criteria.hpp"

namespace quadline {

/// What the limits look at in one quad, each value in the place of its limit; those that are not set may be empty.
/// @param size    target sizes at its sides.
/// @param growth  its greatest ratio to a neighbour, which the quad by itself does not tell.
Criteria criteria_values(const Criteria& limits, const QuadPoints& p, const std::array<double, 4>& size, double growth);

/// How far one quad is beyond the limits, each relative to its limit, all together: 0 where it keeps them. Growth is
/// not looked at.
/// @param size  target size at the quad.
double criteria_excess(const Criteria& criteria, const QuadPoints& p, double size);

}  // namespace quadline
