#pragma once

#include "geom/angles.hpp"

namespace quadline {

// What counts as a bad quad, in one place: stages that judge by the same words judge by the same figures. Scaled
// Jacobians are least sines of a corner, signed.

/// Below it the verifier calls a quad flat: of no use to a solver, whatever rounding makes of it.
inline constexpr double kFlatJacobian = 1e-6;

/// Below it clean-up and untangling call a quad or a star broken, and mend it at any price: it is not convex, or so
/// nearly flat that the next step may turn it over.
inline constexpr double kBrokenJacobian = 0.02;

/// Below it a quad is thin: sound, but better cut into two triangles where it can still be made anew.
inline constexpr double kThinJacobian = 0.05;

/// Smoothing raises what is below it, and takes nothing that was better to below it: a corner of 57 degrees.
inline constexpr double kGoodJacobian = 0.84;

/// A wider corner at a node that stays makes a degenerate quad: no smoothing opens it.
inline constexpr Angle kWidestCorner = degrees(165);

}  // namespace quadline
