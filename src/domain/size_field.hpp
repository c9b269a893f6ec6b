#pragma once

#include <cstdint>
#include <vector>

#include "domain/domain.hpp"
#include "quadline/context.hpp"
#include "quadline/options.hpp"

namespace quadline {

/// Target edge length h over the plane, graded: |h(p) - h(q)| <= g |p - q|.
class SizeField {
 public:
  /// Target edge length at p, model units, > 0. O(log n).
  double at(Point) const { return size_; }

  /// The least number of edges that shows the bend of a piece: 1 where it is straight.
  std::uint32_t least_edges(const CurvePiece& piece) const;

 private:
  friend SizeField make_size_field(const Domain& domain, const Options& options, Context& context);
  double size_ = 0;
};

/// Size field from the sizes of the model, lines, points and regions, from the curvature and the gaps of the domain.
SizeField make_size_field(const Domain& domain, const Options& options, Context& context);

}  // namespace quadline
