#pragma once

#include <string>
#include <vector>

#include "base/stage_clock.hpp"
#include "cells/cell_cache.hpp"
#include "cells/fallback_plan.hpp"
#include "cells/trouble.hpp"
#include "quadline/context.hpp"
#include "quadline/generate.hpp"

namespace quadline {

/// A mesh, and where it breaks the promise.
struct Attempt {
  MeshResult result;              ///< its report holds what the mesh is like, and the cells not meshed as asked
  std::vector<Trouble> troubles;  ///< where `result.failure` is set; empty: no cell is to blame
  std::string too_many;           ///< not empty: more quads than allowed, and why; there is no mesh
};

/// Once through the stages after arrange, every cell as the plan says. Stands in generate.cpp, so that the whole
/// pipeline can be read there at once.
///
/// @param cache  of earlier attempts, of as many cells as the domain has.
/// @throws Cancelled when `context` asks for it; other errors of the stages are failures of the attempt.
Attempt attempt_mesh(const FallbackPlan& plan, const Options& options, CellCache& cache, StageClock& clock,
                     Context& context);

}  // namespace quadline
