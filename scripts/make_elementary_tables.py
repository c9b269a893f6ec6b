#!/usr/bin/env python3
"""Writes src/base/elementary_tables.hpp, the constants of the core's elementary functions; needs mpmath.

Every polynomial is a Chebyshev fit, which is within a few per cent of the minimax polynomial; every table has the
values to twice the precision of a double. `--check` compares with the file that stands there.
"""
import os
import sys

import mpmath as mp

mp.mp.prec = 400
FILE = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "src/base/elementary_tables.hpp")


def rounded(x, bits=53):
    """The nearest number of so many bits."""
    with mp.workprec(bits):
        return +mp.mpf(x)


def on_grid(x, exponent):
    """The nearest multiple of a power of two."""
    return mp.ldexp(mp.nint(mp.ldexp(mp.mpf(x), -exponent)), exponent)


def parts(x, bits):
    """x as a sum: parts of so many bits each, the last one of a double's."""
    result = []
    for n in bits:
        result.append(rounded(x, n))
        x -= result[-1]
    return result + [rounded(x)]


def pair(x, exponent=None):
    high = rounded(x) if exponent is None else on_grid(x, exponent)
    return high, rounded(x - high)


def fit(series, lo, hi, n):
    """Coefficients, constant first, of n terms for the function with the given power series (a function of k)."""
    f = lambda z: mp.fsum(series(k) * z**k for k in range(60))
    coefficients, error = mp.chebyfit(f, [mp.mpf(lo), mp.mpf(hi)], n, error=True)
    return [rounded(c) for c in reversed(coefficients)], error


def number(x):
    return float(x).hex() if x else "0.0"


def line(values):
    return ", ".join(number(v) for v in values)


def text():
    pi, ln2 = mp.pi(), mp.log(2)
    out = ["// Made by scripts/make_elementary_tables.py; not to be edited.", "#pragma once", "", "#include <array>", "",
           "namespace quadline::tables {", "", "/// A value to twice the precision of a double: high + low.",
           "struct Pair {", "  double high, low;", "};", ""]

    def constant(comment, name, value):
        out.extend(["/// %s" % comment, "constexpr double %s = %s;" % (name, number(value)), ""])

    def array(comment, name, values):
        out.extend(["/// %s" % comment, "constexpr std::array<double, %d> %s{%s};" % (len(values), name, line(values)), ""])

    def polynomial(comment, name, series, lo, hi, n):
        values, error = fit(series, lo, hi, n)
        array("%s; off by no more than 2^%d" % (comment, mp.floor(mp.log(error, 2)) + 1), name, values)

    def table(comment, name, values):
        out.append("/// %s" % comment)
        out.append("constexpr std::array<Pair, %d> %s{{%s}};" % (
            len(values), name, ", ".join("{%s}" % line(v) for v in values)))
        out.append("")

    constant("2 / pi", "kQuartersPerRadian", rounded(2 / pi))
    array("pi / 2 as a sum; products of the first three with whole numbers below 2^20 are exact", "kQuarter",
          parts(pi / 2, [33, 33, 33]))
    polynomial("(sin(r) - r) / r^3, of r^2 up to (1 / 8)^2", "kSine",
               lambda k: mp.mpf(-1)**(k + 1) / mp.factorial(2 * k + 3), 0, mp.mpf(1) / 8**2, 4)
    polynomial("(cos(r) - 1) / r^2, of r^2 up to (1 / 63)^2", "kCosine",
               lambda k: mp.mpf(-1)**(k + 1) / mp.factorial(2 * k + 2), 0, mp.mpf(1) / 63**2, 3)
    table("sin(i / 32)", "kSineOf", [pair(mp.sin(mp.mpf(i) / 32)) for i in range(26)])
    table("cos(i / 32)", "kCosineOf", [pair(mp.cos(mp.mpf(i) / 32)) for i in range(26)])
    table("pi / 2 and pi", "kQuarterTurns", [pair(pi / 2), pair(pi)])
    table("arctan(i / 16)", "kArcTangentOf", [pair(mp.atan(mp.mpf(i) / 16)) for i in range(17)])
    polynomial("(arctan(u) - u) / u^3, of u^2 up to (1 / 31)^2", "kArcTangent",
               lambda k: mp.mpf(-1)**(k + 1) / (2 * k + 3), 0, mp.mpf(1) / 31**2, 4)
    high, low = pair(ln2, -42)
    out.append("/// log(2); the high part, like those of the table below, is a multiple of 2^-42: whole multiples up to")
    out.append("/// 1100 add up to a double without rounding")
    out.append("constexpr Pair kLogOf2{%s};" % line([high, low]))
    out.append("")
    table("log(1 + i / 32)", "kLogarithmOf", [pair(mp.log(1 + mp.mpf(i) / 32), -42) for i in range(33)])
    polynomial("(artanh(s) - s) / s^3, of s^2 up to (1 / 30)^2", "kArtanh",
               lambda k: mp.mpf(1) / (2 * k + 3), 0, mp.mpf(1) / 30**2, 5)
    constant("32 / log(2)", "kStepsPerUnit", rounded(32 / ln2))
    array("log(2) / 32 as a sum; products of the first with whole numbers below 2^17 are exact", "kStep",
          parts(ln2 / 32, [36]))
    polynomial("(exp(r) - 1 - r) / r^2, of r up to log(2) / 64 either way", "kExponential",
               lambda k: 1 / mp.factorial(k + 2), -ln2 / 63, ln2 / 63, 5)
    table("2^(i / 32)", "kPowerOf2", [pair(mp.mpf(2)**(mp.mpf(i) / 32)) for i in range(32)])
    out.extend(["}  // namespace quadline::tables", ""])
    return "\n".join(out)


def main():
    # Without white space, which clang-format puts where it likes.
    if "--check" in sys.argv:
        with open(FILE, encoding="utf-8") as there:
            same = "".join(there.read().split()).replace("///", "") == "".join(text().split()).replace("///", "")
        print("the tables are those of this script" if same else "the tables are not those of this script")
        return 0 if same else 1
    with open(FILE, "w", encoding="utf-8") as there:
        there.write(text())
    return 0


if __name__ == "__main__":
    sys.exit(main())
