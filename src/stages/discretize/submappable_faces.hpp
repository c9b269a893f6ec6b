#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "domain/domain.hpp"
#include "stages/discretize/count_target.hpp"

namespace quadline {

/// What meshes as a grid where its opposite sides get equal counts: a walk that turns by four right angles, as its
/// quads count them (a rectangle, an L, a T; also a hole of that kind), its curves sorted by the direction in which
/// rows meet them [Whiteley1996]; or a ring, whose two walks do not turn at all.
struct SubmappableFace {
  static constexpr std::size_t kNoWalk = SIZE_MAX;
  std::size_t walk;                           ///< number among all walks of all cells; kNoWalk: a ring
  std::array<std::vector<CurveId>, 4> sides;  ///< by direction; 0 is opposite to 2, 1 to 3
  std::array<bool, 2> is_close;               ///< sides 0 and 2, sides 1 and 3 want about the same count

  bool is_ring() const { return walk == kNoWalk; }
};

/// The submappable faces of a domain with a pair of opposite sides that want about the same count, in the order of the
/// cells. O(n).
std::vector<SubmappableFace> find_submappable_faces(const Domain& domain,
                                                    const IdVector<CurveId, CountTarget>& targets);

/// Brings the target lengths of opposite sides of submappable faces together, from submappable face to submappable
/// face, so that they round to the same counts. No target falls by more than the factor `kMostCoarsened`, or rises by
/// more than `kMostRefined`, round a ring `kMostRefinedRing`. O(n).
void even_out(const std::vector<SubmappableFace>& submaps, IdVector<CurveId, CountTarget>& targets);

inline constexpr double kMostRefined = 1.25, kMostRefinedRing = 1.6, kMostCoarsened = 1.08;

}  // namespace quadline
