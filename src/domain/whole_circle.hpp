#pragma once

#include <optional>
#include <vector>

#include "domain/domain.hpp"

namespace quadline {

/// A closed walk along one circle, of two arcs whose common ends nothing else meets.
struct WholeCircle {
  Point center{};
  double radius = 0;
};

/// Knows which walks are whole circles, and turns them.
class WholeCircles {
 public:
  explicit WholeCircles(const Domain& domain);

  std::optional<WholeCircle> find(const Domain& domain, const std::vector<DirectedCurve>& walk) const;
  /// Moves the ends of the two arcs to where the direction and its opposite from the centre meet the circle.
  static void turn(Domain& domain, const std::vector<DirectedCurve>& walk, Point direction);
  /// The same with the ends in two directions, which need not be opposite to each other.
  static void turn(Domain& domain, const std::vector<DirectedCurve>& walk, Point tail, Point head);

 private:
  IdVector<VertexId, bool> is_seam_;  ///< two curves meet there and nothing else
};

}  // namespace quadline
