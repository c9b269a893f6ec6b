#pragma once

#include <cstdint>
#include <vector>

#include "domain/domain.hpp"

namespace quadline {

/// Knows how far places on the curves are from each other along the boundary of a cell.
class WalkPlaces {
 public:
  explicit WalkPlaces(const Domain& domain);

  /// The way along the boundary from arc length sa of curve a to sb of b, each on its side, is so short beside the size
  /// of the cell that the two places belong to a corner: a wedge between curves that meet, no gap.
  bool is_wedge(CurveId a, bool a_left, double sa, CurveId b, bool b_left, double sb, double size) const;

 private:
  /// A curve seen from one side, as a part of the walk round the cell on that side.
  struct Side {
    std::uint32_t walk = UINT32_MAX;
    double start = 0;  ///< length of the walk before it
  };

  double place(CurveId c, bool is_left, double s) const;

  const Domain& domain_;
  std::vector<Side> sides_;  ///< 2 * curve + reversed
  std::vector<double> walk_length_;
};

inline CellId cell_on(const Domain::Curve& curve, bool is_left) { return is_left ? curve.left : curve.right; }

inline bool share_vertex(const Domain::Curve& p, const Domain::Curve& q) {
  return p.tail == q.tail || p.tail == q.head || p.head == q.tail || p.head == q.head;
}

}  // namespace quadline
