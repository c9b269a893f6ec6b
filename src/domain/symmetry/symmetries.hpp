#pragma once

#include <cstddef>
#include <vector>

#include "domain/domain.hpp"
#include "domain/symmetry/isometry.hpp"

namespace quadline {

/// A motion that takes a domain to itself, with what it asks of sizes.
struct Symmetry {
  Isometry move;
  IdVector<VertexId, VertexId> vertices;    ///< where each goes
  IdVector<CurveId, DirectedCurve> curves;  ///< `reversed`: the direction of the image is the other one
  IdVector<CellId, CellId> cells;
  /// Of whole circles: the image is the right circle and direction, but its arcs may begin elsewhere.
  IdVector<CurveId, bool> is_whole_circle;
};

/// The symmetries of a domain about the middle of its box, among the mirror images in the axes and diagonals, the half
/// turn and the quarter turns; without the one that moves nothing. Together with that they are a group.
///
/// Vertices, curves, cells, lone points and sizes must go to their like, within twice the domain's tolerance; names
/// need not, nor where the arcs of whole circles begin. O(n log n).
std::vector<Symmetry> find_symmetries(const Domain& domain);

/// The groups that some of them make, as their places, the largest first.
std::vector<std::vector<std::size_t>> subgroups_of(const std::vector<Symmetry>& symmetries);

}  // namespace quadline
