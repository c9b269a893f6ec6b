#pragma once

#include <vector>

#include "cells/cell_cache.hpp"
#include "cells/fallback.hpp"
#include "domain/domain.hpp"
#include "quadline/context.hpp"
#include "quadline/generate.hpp"

namespace quadline {

/// A mesh, and where it breaks the promise.
struct Attempt {
  MeshResult result;              ///< without its report
  std::vector<Trouble> troubles;  ///< where `result.failure` is set; empty: no cell is to blame
  std::vector<Finding> findings;  ///< the cells that were not meshed as asked
  double too_many = 0;            ///< not 0: so many quads are needed at least, more than allowed; no mesh was made
};

/// Once through the stages, from the size field to the verifier.
///
/// @param plan    how each cell is meshed.
/// @param cache   of earlier attempts, of as many cells as the domain has.
/// @param report  gets the times and the qualities.
/// @throws Cancelled when `context` asks for it; other errors of the stages are failures of the attempt.
Attempt attempt_mesh(const FallbackPlan& plan, const Options& options, CellCache& cache, Report& report,
                     Context& context);

}  // namespace quadline
