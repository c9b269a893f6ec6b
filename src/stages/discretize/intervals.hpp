#pragma once

#include <cstdint>

#include "domain/domain.hpp"
#include "stages/discretize/count_target.hpp"

namespace quadline {

/// Numbers of edges on the curves, such that every cell has an even number round it (a line inside it counts twice),
/// at least four; eight where all its curves must be even.
///
/// Opposite sides of submappable faces get equal counts where their targets are close; else the counts differ as little
/// from the targets as evenness allows. No count falls below its target by more than the factor `kMostCoarsened`.
/// Near-linear in the number of curves.
IdVector<CurveId, std::uint32_t> choose_counts(const Domain& domain, IdVector<CurveId, CountTarget> targets);

}  // namespace quadline
