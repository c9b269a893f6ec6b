// The elementary functions beside MPFR's, which rounds correctly.
#include "base/elementary.hpp"

#include <gtest/gtest.h>
#include <mpfr.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>

#include "quadline/errors.hpp"

namespace quadline {

namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kError = 0.8;  // ulps; below it, and above what was measured
constexpr int kMany = 10'000;

// A number of many more digits than a double's.
class Exact {
 public:
  explicit Exact(double x) { mpfr_init2(value_, 200), mpfr_set_d(value_, x, MPFR_RNDN); }
  ~Exact() { mpfr_clear(value_); }
  Exact(const Exact&) = delete;
  Exact& operator=(const Exact&) = delete;
  mpfr_ptr get() { return value_; }

  // Distance of `x` from this number in the distance of neighbouring doubles here.
  double ulps_to(double x) {
    const double nearest = std::fabs(mpfr_get_d(value_, MPFR_RNDZ));
    const double ulp = std::nextafter(nearest, kInfinity) - nearest;
    mpfr_sub_d(value_, value_, x, MPFR_RNDN);
    return std::fabs(mpfr_get_d(value_, MPFR_RNDN)) / ulp;
  }

 private:
  mpfr_t value_;
};

using Function = double (*)(double);
using ExactFunction = int (*)(mpfr_ptr, mpfr_srcptr, mpfr_rnd_t);

double error_of(Function f, ExactFunction exact, double x) {
  Exact value(x);
  exact(value.get(), value.get(), MPFR_RNDN);
  return value.ulps_to(f(x));
}

double arc_tangent_error(double y, double x) {
  Exact value(y), other(x);
  mpfr_atan2(value.get(), value.get(), other.get(), MPFR_RNDN);
  return value.ulps_to(arc_tangent(y, x));
}

// splitmix64
class Draw {
 public:
  std::uint64_t bits() {
    std::uint64_t z = state_ += 0x9e3779b97f4a7c15;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
    z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
    return z ^ (z >> 31);
  }
  double between(double lo, double hi) { return lo + (hi - lo) * static_cast<double>(bits() >> 11) * 0x1p-53; }
  // Of any exponent in the range, and either sign.
  double of_exponent(double lo, double hi) {
    return std::ldexp(between(1, 2), static_cast<int>(between(lo, hi))) * (bits() % 2 == 0 ? 1 : -1);
  }

 private:
  std::uint64_t state_ = 1;
};

}  // namespace

TEST(Elementary, SineAndCosineAreWithinTheirError) {
  Draw draw;
  double worst = 0;
  const auto look = [&](double x) {
    worst = std::max({worst, error_of(sine, mpfr_sin, x), error_of(cosine, mpfr_cos, x)});
  };
  for (int i = 0; i < kMany; ++i) {
    look(draw.between(-7, 7));
    look(draw.between(-1e6, 1e6));
    look(draw.of_exponent(-1000, 19));
  }
  EXPECT_LT(worst, kError);
}

// Where the reduction cancels most: the doubles nearest to multiples of a quarter turn, and their neighbours.
TEST(Elementary, SineAndCosineAreWithinTheirErrorNearMultiplesOfAQuarterTurn) {
  double worst = 0;
  for (int n = 1; n < 600'000; n += n < 2000 ? 1 : 37) {
    const double x = n * (kPi / 2), y = n * (kPi / 4);
    for (const double a : {x, std::nextafter(x, 0), std::nextafter(x, 1e9), y})
      worst = std::max({worst, error_of(sine, mpfr_sin, a), error_of(cosine, mpfr_cos, -a)});
  }
  EXPECT_LT(worst, kError);
}

TEST(Elementary, SineAndCosineAtZeroAndOutsideTheirRange) {
  EXPECT_EQ(sine(0), 0);
  EXPECT_EQ(cosine(0), 1);
  EXPECT_EQ(sine(5e-324), 5e-324);
  EXPECT_EQ(sine(kPi / 2), 1);
  EXPECT_EQ(cosine(kPi), -1);
  EXPECT_TRUE(std::isnan(sine(std::nan(""))));
  EXPECT_TRUE(std::isnan(cosine(std::nan(""))));
  EXPECT_THROW(sine(1.1e6), InternalError);
  EXPECT_THROW(cosine(-kInfinity), InternalError);
}

TEST(Elementary, ArcTangentIsWithinItsError) {
  Draw draw;
  double worst = 0;
  for (int i = 0; i < kMany; ++i) {
    const double y = draw.between(-1, 1), x = draw.between(-1, 1);
    worst = std::max({worst, arc_tangent_error(y, x), arc_tangent_error(y * 0x1p1000, x * 0x1p1000),
                      arc_tangent_error(y * 0x1p-1000, x * 0x1p-1000)});
    worst = std::max(worst, arc_tangent_error(draw.of_exponent(-400, 400), draw.of_exponent(-400, 400)));
    worst = std::max(worst, arc_tangent_error(draw.of_exponent(-40, 3), draw.of_exponent(-3, 3)));
  }
  for (int i = -200; i <= 200; ++i)  // between two entries of the table
    for (const double off : {-1e-15, 0.0, 1e-15})
      worst = std::max({worst, arc_tangent_error(i / 32.0 + off, 1), arc_tangent_error(1, i / 32.0 + off)});
  EXPECT_LT(worst, 1.01);
}

TEST(Elementary, ArcTangentIsExactOnAxesAndDiagonals) {
  for (const double a : {5e-324, 1e-300, 0.3, 1.0, 7e5, 1e300, 1.7e308}) {
    EXPECT_EQ(arc_tangent(0, a), 0);
    EXPECT_EQ(arc_tangent(0, -a), kPi);
    EXPECT_EQ(arc_tangent(-0.0, -a), -kPi);
    EXPECT_EQ(arc_tangent(a, 0), kPi / 2);
    EXPECT_EQ(arc_tangent(-a, 0), -kPi / 2);
    EXPECT_EQ(arc_tangent(a, a), kPi / 4);
    EXPECT_EQ(arc_tangent(-a, a), -kPi / 4);
    EXPECT_EQ(arc_tangent(a, -a), 3 * kPi / 4);
    EXPECT_EQ(arc_tangent(-a, -a), -3 * kPi / 4);
  }
}

TEST(Elementary, ArcTangentAtZerosAndInfinities) {
  for (const double y : {0.0, -0.0})
    for (const double x : {0.0, -0.0}) {
      EXPECT_EQ(arc_tangent(y, x), std::atan2(y, x));
      EXPECT_EQ(std::signbit(arc_tangent(y, x)), std::signbit(y));
    }
  EXPECT_EQ(arc_tangent(1, kInfinity), 0);
  EXPECT_EQ(arc_tangent(-1, -kInfinity), -kPi);
  EXPECT_EQ(arc_tangent(kInfinity, 1), kPi / 2);
  EXPECT_TRUE(std::isnan(arc_tangent(kInfinity, kInfinity)));
  EXPECT_TRUE(std::isnan(arc_tangent(std::nan(""), 1)));
  EXPECT_TRUE(std::isnan(arc_tangent(1, std::nan(""))));
  EXPECT_TRUE(std::isnan(arc_tangent(0, std::nan(""))));
}

TEST(Elementary, LogarithmIsWithinItsError) {
  Draw draw;
  double worst = 0;
  const auto look = [&](double x) { worst = std::max(worst, error_of(logarithm, mpfr_log, x)); };
  for (int i = 0; i < kMany; ++i) {
    look(draw.between(0, 3));
    look(draw.between(0.9, 1.1));
    look(1 + draw.of_exponent(-50, -4));
    look(std::fabs(draw.of_exponent(-1022, 1024)));
    look(static_cast<double>(draw.bits() >> 20) * 5e-324);
  }
  for (const double x : {1 - 0.0625, 1 + 0.0625, 5e-324, std::numeric_limits<double>::max()}) {
    look(x);
    look(std::nextafter(x, 0.5));
    look(std::nextafter(x, 2));
  }
  EXPECT_LT(worst, kError);
}

TEST(Elementary, LogarithmOfOneIsZeroAndOfNoPositiveNumberNone) {
  EXPECT_EQ(logarithm(1), 0);
  EXPECT_EQ(logarithm(2), std::numbers::ln2);
  EXPECT_EQ(logarithm(0), -kInfinity);
  EXPECT_EQ(logarithm(kInfinity), kInfinity);
  EXPECT_TRUE(std::isnan(logarithm(-1)));
  EXPECT_TRUE(std::isnan(logarithm(std::nan(""))));
}

TEST(Elementary, ExponentialIsWithinItsError) {
  Draw draw;
  double worst = 0;
  const auto look = [&](double x) { worst = std::max(worst, error_of(exponential, mpfr_exp, x)); };
  for (int i = 0; i < kMany; ++i) {
    look(draw.between(-2, 2));
    look(draw.between(-708, 709.78));
    look(draw.of_exponent(-60, 0));
  }
  EXPECT_LT(worst, kError);
  for (int i = 0; i < kMany / 10; ++i) look(draw.between(-745, -708));  // rounded twice where doubles thin out
  EXPECT_LE(worst, 1);
}

TEST(Elementary, ExponentialOfZeroIsOneAndEndsAtTheRangeOfDoubles) {
  EXPECT_EQ(exponential(0), 1);
  EXPECT_EQ(exponential(-0.0), 1);
  EXPECT_EQ(exponential(1), std::numbers::e);
  EXPECT_EQ(exponential(709.78271289338397), std::exp(709.78271289338397));
  EXPECT_EQ(exponential(709.7827128933841), kInfinity);
  EXPECT_EQ(exponential(kInfinity), kInfinity);
  EXPECT_EQ(exponential(-kInfinity), 0);
  EXPECT_TRUE(std::isnan(exponential(std::nan(""))));
}

// The same bits on every machine, compiled by any compiler: the bits of many results, mixed.
TEST(Elementary, GivesTheSameBitsEverywhere) {
  Draw draw;
  std::uint64_t all = 0;
  const auto add = [&](double x) { all = std::rotl(all, 5) ^ std::bit_cast<std::uint64_t>(x); };
  for (int i = 0; i < kMany; ++i) {
    const double x = draw.between(-10, 10), y = draw.between(-10, 10);
    add(sine(x)), add(cosine(x)), add(arc_tangent(y, x)), add(logarithm(std::fabs(x))), add(exponential(x));
  }
  EXPECT_EQ(all, 8423492705428365491u);
}

}  // namespace quadline
