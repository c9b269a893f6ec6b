#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "domain/domain.hpp"
#include "stages/discretize/count_wish.hpp"

namespace quadline {

/// A cell with four corners and nothing inside: it meshes as a grid where its opposite sides get equal counts.
struct Bay {
  std::size_t walk;                           ///< number of its walk among all walks of all cells
  std::array<std::vector<CurveId>, 4> sides;  ///< counter-clockwise; 0 is opposite to 2, 1 to 3
  std::array<bool, 2> is_close;               ///< sides 0 and 2, sides 1 and 3 want about the same count
};

/// The bays of a domain with a pair of opposite sides that want about the same count, in the order of the cells. A
/// corner is a vertex where one quad fits; elsewhere two must fit. O(n).
std::vector<Bay> find_bays(const Domain& domain, const IdVector<CurveId, CountWish>& wishes);

/// A cell with three corners wants two edges or more on each side: with one, a quad would have a flat corner.
void widen_triangles(const Domain& domain, IdVector<CurveId, CountWish>& wishes);

/// Brings the wished lengths of opposite sides of bays together, from bay to bay, so that they round to the same
/// counts. No wish changes by more than the factor `kMostEvened`. O(n).
void even_out(const std::vector<Bay>& bays, IdVector<CurveId, CountWish>& wishes);

inline constexpr double kMostEvened = 1.15;

}  // namespace quadline
