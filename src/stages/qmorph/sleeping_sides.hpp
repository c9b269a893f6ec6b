#pragma once

#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "mesh/work_mesh.hpp"

namespace quadline {

/// The second sides of line constraints, where quads are formed in one fixed direction only [Lee2003]: a line's right
/// side sleeps as a whole until its left side is meshed, which closes a loop round the line, like that of a hole.
///
/// A line is here one curve inside the cell: a piece between crossings. Sides are known by their nodes, since an edge
/// of a line may be made anew, with another id.
class SleepingSides {
 public:
  /// All second sides sleep. O(n log n).
  explicit SleepingSides(const WorkMesh& mesh);

  bool contains(HalfId h) const { return !line_of_.empty() && mesh_.is_constraint(h) && line_of_.contains(ends_of(h)); }
  /// Wakes the side of a line that holds h, if its first side is meshed; else returns none.
  /// @pre contains(h)
  std::vector<HalfId> wake_if_due(HalfId h);
  /// Wakes all that are asleep.
  std::vector<HalfId> wake_all();

 private:
  using Ends = std::pair<NodeId, NodeId>;  // tail and head of a half-edge
  struct Line {
    std::vector<Ends> second_side;
    std::size_t n_meshed = 0;  // of the first side; those at the start of the vector
  };
  Ends ends_of(HalfId h) const { return {mesh_.topo().tail(h), mesh_.topo().head(h)}; }
  HalfId half(const Ends& ends) const { return mesh_.topo().find(ends.first, ends.second); }

  const WorkMesh& mesh_;
  std::map<Ends, CurveId> line_of_;  // of the half-edges that sleep
  std::map<CurveId, Line> lines_;
};

}  // namespace quadline
