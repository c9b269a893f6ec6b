// Argument reduction by sums of constants after [CodyWaite1980], tables and short polynomials after [Tang1989] for the
// exponential, [Tang1990] for the logarithm and [Tang1991] for the sine; sums that keep their rounding errors after
// [Knuth1997]. We differ: the arc tangent is looked up and reduced by both of its arguments, before any quotient is
// rounded, and near 1 the logarithm takes from x - 1, which is exact, what its series lacks. No fused multiplication:
// not every processor has it.
#include "base/elementary.hpp"

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "base/check.hpp"
#include "base/elementary_tables.hpp"

namespace quadline {

namespace {

using tables::Pair;

constexpr double kLargestAngle = 1e6;  // below 2^20 quarter turns
constexpr double kTiny = 0x1p-28;      // of which the square is no longer seen beside 1

// a + b with its rounding error [Knuth1997].
Pair sum(double a, double b) {
  const double s = a + b, part = s - a;
  return {s, (a - (s - part)) + (b - part)};
}

// The same where |a| >= |b|.
Pair ordered_sum(double a, double b) {
  const double s = a + b;
  return {s, b - (s - a)};
}

template <std::size_t N>
double polynomial(const std::array<double, N>& c, double x) {
  double value = c[N - 1];
  for (std::size_t i = N - 1; i-- > 0;) value = value * x + c[i];
  return value;
}

// Whole quarter turns, and what is left of the angle: at most an eighth of a turn either way, and its rounding error.
struct Reduced {
  int quarters;
  Pair rest;
};

Reduced reduced(double angle) {
  QUADLINE_CHECK(!(std::fabs(angle) > kLargestAngle));
  if (!(std::fabs(angle) > 0.785)) return {0, {angle, 0}};
  const double n = std::floor(angle * tables::kQuartersPerRadian + 0.5);
  const auto& quarter = tables::kQuarter;
  const Pair first = sum(angle - n * quarter[0], -(n * quarter[1]));  // both products and the difference are exact
  const Pair second = sum(first.high, -(n * quarter[2]));
  const Pair rest = ordered_sum(second.high, first.low + (second.low - n * quarter[3]));
  return {static_cast<int>(n), rest};
}

// The nearest whole part of 1 / 32, at which sine and cosine are known, and what is left.
struct Near {
  std::size_t i;
  double rest, sine_of_rest, cosine_less_1;
  Near(double size, double low) {
    const double n = size > 0x1p-6 ? std::floor(32 * size + 0.5) : 0;
    i = static_cast<std::size_t>(n);
    rest = (size - n / 32) + low;
    const double z = rest * rest;
    sine_of_rest = rest + rest * z * polynomial(tables::kSine, z);
    cosine_less_1 = z * polynomial(tables::kCosine, z);
  }
};

double sine_of(const Pair& r) {
  const double size = std::fabs(r.high), z = size * size;
  if (!(size > 0.125)) return r.high + (r.low + r.high * z * polynomial(tables::kSine, z));
  const Near near(size, r.high < 0 ? -r.low : r.low);
  const Pair &s = tables::kSineOf[near.i], &c = tables::kCosineOf[near.i];
  return std::copysign(s.high + (s.low + (c.high * near.sine_of_rest + s.high * near.cosine_less_1)), r.high);
}

double cosine_of(const Pair& r) {
  const Near near(std::fabs(r.high), r.high < 0 ? -r.low : r.low);
  const Pair &s = tables::kSineOf[near.i], &c = tables::kCosineOf[near.i];
  return c.high + (c.low + (c.high * near.cosine_less_1 - s.high * near.sine_of_rest));
}

// Sine of an angle that so many quarter turns were taken from.
double sine_after(int quarters, const Pair& rest) {
  const double value = quarters % 2 == 0 ? sine_of(rest) : cosine_of(rest);
  return quarters & 2 ? -value : value;
}

// The upper half of a double's digits: products with numbers of few digits are exact.
double upper_half(double x) {
  return std::bit_cast<double>(std::bit_cast<std::uint64_t>(x) & ~((std::uint64_t{1} << 27) - 1));
}

// arctan(low / high), 0 <= low <= high.
Pair arc_tangent_of_ratio(double low, double high) {
  const double ratio = high == 0 ? 0 : low / high;
  if (!(ratio > kTiny)) return {ratio, 0};
  // The two are of like magnitude: away from the ends of the range a power of two changes nothing.
  const double scale = high > 0x1p900 ? 0x1p-200 : high < 0x1p-700 ? 0x1p200 : 1;
  low *= scale, high *= scale;
  const double i = std::floor(16 * ratio + 0.5), c = i / 16;
  // arctan(low / high) = arctan(c) + arctan((low - c high) / (high + c low)), where both products are exact
  const double front = upper_half(high), back = high - front;
  const double u = ((low - c * front) - c * back) / (high + c * low), z = u * u;
  const Pair& at_c = tables::kArcTangentOf[static_cast<std::size_t>(i)];
  const Pair start = ordered_sum(at_c.high, u);  // exactly u where c is 0
  return {start.high, start.low + (at_c.low + u * z * polynomial(tables::kArcTangent, z))};
}

Pair difference(const Pair& a, const Pair& b) {
  const Pair d = ordered_sum(a.high, -b.high);
  return {d.high, d.low + (a.low - b.low)};
}

// log((1 + s) / (1 - s)) - 2 s.
double beyond_linear(double s) {
  const double z = s * s;
  return 2 * s * z * polynomial(tables::kArtanh, z);
}

}  // namespace

double sine(double angle_rad) {
  const Reduced r = reduced(angle_rad);
  return sine_after(r.quarters, r.rest);
}

double cosine(double angle_rad) {
  const Reduced r = reduced(angle_rad);
  return sine_after(r.quarters + 1, r.rest);
}

double arc_tangent(double y, double x) {
  const double across = std::fabs(y), along = std::fabs(x);
  const bool is_steep = across > along;
  Pair angle = is_steep ? arc_tangent_of_ratio(along, across) : arc_tangent_of_ratio(across, along);
  if (is_steep) angle = difference(tables::kQuarterTurns[0], angle);
  if (std::signbit(x)) angle = difference(tables::kQuarterTurns[1], angle);
  return std::copysign(angle.high + angle.low, y);
}

double logarithm(double x) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  if (!(x > 0)) return x == 0 ? -kInfinity : std::numeric_limits<double>::quiet_NaN();
  if (x == kInfinity) return x;
  if (std::fabs(x - 1) < 0.0625) {
    // With f = x - 1 and s = f / (2 + f): log(x) = 2 s + ..., and 2 s = f - s f.
    const double f = x - 1, s = f / (2 + f);
    return f - (s * f - beyond_linear(s));
  }
  constexpr double kLeastNormal = std::numeric_limits<double>::min();
  constexpr std::uint64_t kFraction = (std::uint64_t{1} << 52) - 1, kOne = std::bit_cast<std::uint64_t>(1.0);
  const bool is_subnormal = x < kLeastNormal;
  const auto bits = std::bit_cast<std::uint64_t>(is_subnormal ? x * 0x1p54 : x);
  const double k = static_cast<double>(bits >> 52) - (is_subnormal ? 1023 + 54 : 1023);
  const double m = std::bit_cast<double>((bits & kFraction) | kOne);  // x = 2^k m, 1 <= m < 2
  const double i = std::floor(32 * (m - 1) + 0.5), near = 1 + i / 32;
  const double s = (m - near) / (m + near);
  const Pair& at_near = tables::kLogarithmOf[static_cast<std::size_t>(i)];
  const double high = k * tables::kLogOf2.high + at_near.high, low = k * tables::kLogOf2.low + at_near.low;
  return high + (2 * s + (beyond_linear(s) + low));
}

double exponential(double x) {
  if (x > 710) return std::numeric_limits<double>::infinity();
  if (x < -746) return 0;
  if (std::isnan(x)) return x;
  const double n = std::floor(x * tables::kStepsPerUnit + 0.5);
  const double r = (x - n * tables::kStep[0]) - n * tables::kStep[1];
  const int steps = static_cast<int>(n);  // of 2^(1 / 32)
  const Pair& power = tables::kPowerOf2[static_cast<std::size_t>(steps & 31)];
  const double beyond = r + r * r * polynomial(tables::kExponential, r);
  return std::ldexp(power.high + (power.low + power.high * beyond), steps >> 5);
}

}  // namespace quadline
