#pragma once

#include "domain/cell_set.hpp"
#include "domain/domain.hpp"

namespace quadline {

/// The domain with cells that are their own mirror image cut along the axis, so that one half can be meshed and copied;
/// with two axes and more, again and again. The curves of the cuts are `is_auxiliary` and on no path; the parts of a
/// cell keep its region and size. Curves that a cut ends at are halved there.
///
/// A cell stays whole where the cut would harm: where it halves a corner of less than 135 degrees, is short or halves a
/// short curve, or runs beside a boundary of the cell within 1.2 sizes; and where the quads will be symmetric anyway.
///
/// @param whole  cells that stay whole in any case.
/// Cost O((n + k) log n) for cuts k sizes long.
Domain cut_at_axes(Domain domain, const CellSet& whole);

/// The rows of quads of a cell go straight through from side to side, or all the way round, so that nothing is gained
/// by a cut: four corners, opposite sides about as long and nothing inside, or two closed curves without corners.
bool has_plain_rows(const Domain& domain, CellId cell);

}  // namespace quadline
