#pragma once

#include "domain/domain.hpp"
#include "search/box_tree.hpp"

namespace quadline {

/// Distance from p along the unit vector d to the first meeting with a piece, p itself left out; infinity where there
/// is none within `reach`.
double ray_distance(Point p, Point d, double reach, const CurvePiece& piece);

std::vector<Box> boxes_of_curves(const Domain& domain);

/// The point p lies on the left of the curve, seen from arc length s of it.
bool is_left_of(const CurvePiece& piece, double s, Point p);

/// Tells in which cell a point off all curves lies.
class CellLocator {
 public:
  explicit CellLocator(const Domain& domain) : domain_(domain), tree_(boxes_of_curves(domain)) {}

  /// Invalid outside the domain. O(log n) where boxes overlap little.
  CellId at(Point p) const;

 private:
  const Domain& domain_;
  BoxTree tree_;
};

}  // namespace quadline
