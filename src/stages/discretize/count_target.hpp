#pragma once

#include <cstdint>

#include "base/id.hpp"

namespace quadline {

/// What one curve wants.
struct CountTarget {
  double length = 1;        ///< number of edges by the sizes alone, > 0
  std::uint32_t least = 1;  ///< never fewer
  bool is_halved = false;   ///< its edges come in pairs, each made of one
  CurveId twin{};           ///< the other half of a circle, which gets the same count; invalid: none
  bool is_wished = false;   ///< for a grid, which needs just the length: another count costs so much more

  /// An odd number will not do. A circle with a multiple of four suits the rows round it.
  bool is_even() const { return is_halved || twin.valid(); }
};

/// The count of the given parity (0 or 1) that suits the target best, by the ratio of the two.
std::uint32_t best_count(const CountTarget& target, std::uint32_t parity);

/// What a count costs: 0 where it is as the target, (n - l)^2 / (n l) else, which is about ln(n / l)^2.
double count_cost(const CountTarget& target, std::uint32_t count);

}  // namespace quadline
