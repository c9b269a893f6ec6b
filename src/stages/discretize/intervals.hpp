#pragma once

#include <cstdint>

#include "domain/domain.hpp"
#include "stages/discretize/count_wish.hpp"

namespace quadline {

/// Numbers of edges on the curves, such that every cell has an even number round it (a line inside it counts twice),
/// at least four; eight where all its curves must be even.
///
/// Opposite sides of bays get equal counts where their wishes are close; else the counts differ as little from the
/// wishes as evenness allows. No count falls below its wish by more than the factor `kMostCoarsened`. Near-linear in
/// the number of curves.
IdVector<CurveId, std::uint32_t> choose_counts(const Domain& domain, IdVector<CurveId, CountWish> wishes);

}  // namespace quadline
