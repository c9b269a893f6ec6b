#pragma once

#include <cstdint>

#include "domain/domain.hpp"

namespace quadline {

/// What one curve wants.
struct CountWish {
  double length = 1;        ///< number of edges by the sizes alone, > 0
  std::uint32_t least = 1;  ///< never fewer
};

/// Numbers of edges on the curves, such that every cell has an even number round it (a line inside it counts twice).
///
/// A labelling of the vertices with 0 and 1 makes each curve's count odd exactly where the labels of its ends differ;
/// every cell is even then, whatever the labels. They are chosen so that the counts differ least from the wishes:
/// a spanning forest of the curves that care most, then flips of one or two labels while they gain.
/// Near-linear in the number of curves.
IdVector<CurveId, std::uint32_t> choose_counts(const Domain& domain, const IdVector<CurveId, CountWish>& wishes);

/// The count of the given parity (0 or 1) that suits the wish best, by the ratio of the two.
std::uint32_t best_count(const CountWish& wish, std::uint32_t parity);

/// What a count costs: 0 where it is as wished, (n - l)^2 / (n l) else, which is about ln(n / l)^2.
double count_cost(const CountWish& wish, std::uint32_t count);

}  // namespace quadline
