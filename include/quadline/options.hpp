#pragma once

#include <optional>

#include "quadline/criteria.hpp"

namespace quadline {

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
  QMorph,  ///< an advancing front [Owen1999, Lee2003]
  Merge,   ///< pairs at twice the size, the best first; then all elements are halved [Lo1989, Rank1993]
  Split,   ///< triangles at twice the size, each halved into three quads
};

/// What the caller may choose. The defaults suit every model.
struct Options {
  std::optional<double> size{};  ///< target edge length instead of the model's, model units, > 0
  /// At least so many edges on a full turn of a curve, >= 4; on circles small beside the sizes down to half of it.
  double edges_per_circle = 16;
  /// Points nearer than this are one, and points within half of it of a curve lie on it; model units, > 0, at most a
  /// quarter of the least size. By default 8e-7 of the diagonal of the outer loops, or 1e-3 of the least size where
  /// that is less.
  std::optional<double> tolerance{};
  double growth = 1.3;  ///< largest ratio of the sizes of neighbouring edges, > 1
  LineFronts lines = LineFronts::TwoSided;
  Triangles triangles = Triangles::Both;
  Method method = Method::QMorph;
  std::optional<Criteria> criteria{};  ///< limits that smoothing works towards, where it can without harm
  /// Fall-backs that are expected to need more quads are left out, and what needs more all the same is no result.
  double max_quads = 50e6;
};

}  // namespace quadline
