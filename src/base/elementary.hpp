#pragma once

namespace quadline {

// Elementary functions in sums, products, quotients and exact roundings alone, which IEEE 754 defines to the last bit.
// Those of libm differ between libraries, their versions and processors, and the core promises the same bytes on all.
// Errors stay below 0.8 ulp (the distance of neighbouring doubles at the result), those of the arc tangent below 1.01,
// as the tests measure against MPFR. A NaN gives NaN.

/// Sine of an angle in radians.
/// @pre |angle_rad| <= 1e6, which holds for every turn along a curve; else InternalError.
double sine(double angle_rad);

/// Cosine of an angle in radians.
/// @pre |angle_rad| <= 1e6; else InternalError.
double cosine(double angle_rad);

/// The angle of the vector (x, y) in radians, [-pi, pi]; exact on the axes and diagonals, with the signs of zeros of
/// std::atan2. NaN where both are infinite.
double arc_tangent(double y, double x);

/// Natural logarithm; exactly 0 at 1, minus infinity at 0, NaN below.
double logarithm(double x);

/// e to the power of x; exactly 1 at 0.
double exponential(double x);

}  // namespace quadline
