#pragma once

#include "quality/limits.hpp"
#include "stages/smooth/progress.hpp"
#include "stages/smooth/smooth.hpp"
#include "stages/smooth/stars.hpp"

namespace quadline::smoothing {

/// Every step may lower the least sine of a star to this, if it was better; squared.
constexpr double kFloor2 = kGoodJacobian * kGoodJacobian;

// The steps of smoothing, in their order.

/// [Lee2003 section 6]: a node goes to the centroid of its neighbours if that does not harm its worst element.
void laplacian(Stars& stars, const SmoothOptions& options, const Progress& progress);

/// Makes corners convex that are not, by a barrier that lets them pass through zero [Garanzha2021].
void untangle(Stars& stars, const SmoothOptions& options, const Progress& progress);

/// Minimises the inverse mean ratio of the corners [Knupp2000], then a high power of it where a corner is poor.
void optimize(Stars& stars, const SmoothOptions& options, const Progress& progress);

/// Raises the least sine round nodes where it is below the floor.
void raise_least_sine(Stars& stars, const SmoothOptions& options, const Progress& progress);

/// Raises the geometric mean of beta, and makes edges that follow each other equal.
void raise_beta(Stars& stars, const SmoothOptions& options, const Progress& progress);

/// Moves nodes where quads fail the caller's criteria, so that they fail them by less, or not at all.
void meet_criteria(Stars& stars, const SmoothOptions& options, const Progress& progress);

}  // namespace quadline::smoothing
