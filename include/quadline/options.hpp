#pragma once

#include <functional>
#include <limits>
#include <optional>
#include <string>

#include "quadline/criteria.hpp"
#include "quadline/point.hpp"

namespace quadline {

/// The values that a number may have, always finite ones.
struct Range {
  double low = 0;
  double high = std::numeric_limits<double>::max();
  bool is_above = false;  ///< `low` itself is none of them

  constexpr bool contains(double x) const {  // false for what is no number
    return (is_above ? x > low : x >= low) && x <= high && x <= std::numeric_limits<double>::max();
  }
  /// "a number above 1 and up to 1e+06".
  std::string text() const;
};

constexpr Range kLengthRange{.is_above = true};                         ///< of sizes and of the tolerance, model units
constexpr Range kEdgesPerCircleRange{.low = 4, .high = 1e4};            ///< Options::edges_per_circle
constexpr Range kGrowthRange{.low = 1, .high = 1e6, .is_above = true};  ///< Options::growth
constexpr Range kMaxQuadsRange{.low = 1, .high = 1e9};                  ///< Options::max_quads; ids have 32 bits

/// Which half-edges of a line constraint start in the front.
enum class LineFronts {
  OneSided,  ///< the paper's rule: the left side first, which turns the open line into a closed loop
  TwoSided,  ///< both sides at once
};

/// Who makes the triangles that Q-Morph merges.
enum class Triangles {
  Delaunay,  ///< edges subdivided after the local size (Borouchaki and George 1997)
  Front,     ///< an advancing front of triangles
  Both,      ///< Front; where nodes of too many and of too few quads are left in a cell, the best of several
};

/// How the triangles become quads.
enum class Method {
  Layout,  ///< grids with rings round holes where a cell takes them, Q-Morph elsewhere
  QMorph,  ///< an advancing front [Owen1999, Lee2003]
  Merge,   ///< pairs at twice the size, the best first; then all elements are halved [Lo1989, Rank1993]
  Split,   ///< triangles at twice the size, each halved into three quads
};

/// What the caller may choose. The defaults suit every model; `check` refuses what makes no sense.
struct Options {
  /// Target edge length instead of the model's, model units; in kLengthRange. Default: the model's.
  std::optional<double> size{};
  /// Target edge length at a place, model units; in kLengthRange and four tolerances at least. The least of it and of
  /// what the model asks for holds, graded by `growth`. Called in the domain's box, in holes too, by one thread in an
  /// order that is always the same: the same place must give the same length. Default: none. docs/sizing.md has its
  /// limits.
  std::function<double(Point)> size_at{};
  /// At least so many edges on a full turn of a curve, in kEdgesPerCircleRange; on circles small beside the sizes down
  /// to half of it.
  double edges_per_circle = 16;
  /// Points nearer than this are one, and points within half of it of a curve lie on it; model units, in kLengthRange,
  /// at most a quarter of the least size. Default: 8e-7 of the diagonal of the outer loops, or 1e-3 of the least size
  /// where that is less.
  std::optional<double> tolerance{};
  double growth = 1.3;  ///< largest ratio of the sizes of neighbouring edges, in kGrowthRange
  LineFronts lines = LineFronts::TwoSided;
  Triangles triangles = Triangles::Both;
  Method method = Method::Layout;
  /// Limits that smoothing works towards, where it can without harm, each in the range of its `criteria_fields()`.
  /// Default: none.
  std::optional<Criteria> criteria{};
  /// Fall-backs that are expected to need more quads are left out, and what needs more all the same is no result. In
  /// kMaxQuadsRange.
  double max_quads = 50e6;
};

/// Checks that every number has a value that makes sense: `generate` and all that takes options begins with it.
/// @throws InputError  (InvalidOption) names the option, what it is, and what was expected.
void check(const Options& options);

}  // namespace quadline
