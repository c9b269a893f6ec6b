#pragma once

#include <cstdint>
#include <vector>

#include "quadline/point.hpp"

namespace quadline {

/// Order of the points along a Hilbert curve over their box: near in the order is near in the plane.
std::vector<std::uint32_t> hilbert_order(const std::vector<Point>& points);

/// Order for an incremental triangulation: rounds of doubling size, points falling into them as by chance, each round
/// in Hilbert order [Amenta2003]. Without the rounds, points that stand in rows would cost quadratic time.
std::vector<std::uint32_t> insertion_order(const std::vector<Point>& points);

}  // namespace quadline
