#pragma once

#include <cstdint>
#include <limits>
#include <numbers>

namespace quadline {

inline constexpr double kInfinity = std::numeric_limits<double>::infinity();
inline constexpr double kFullTurn = 2 * std::numbers::pi;  ///< radians
inline constexpr double kDegreesPerRadian = 180 / std::numbers::pi;
inline constexpr std::uint32_t kNone = UINT32_MAX;  ///< the index of no element

}  // namespace quadline
