#pragma once

#include <vector>

#include "domain/domain.hpp"

namespace quadline {

/// Where a cut through a cell ends: at a vertex, or in the middle of a curve.
struct CutEnd {
  VertexId vertex;
  CurveId curve;  ///< where there is no vertex
};

/// A straight cut from boundary to boundary of a cell, or lone points of it.
struct Cut {
  CellId cell;
  CutEnd from, to;
};

/// Cuts cells. No cut meets another but at its ends, and no sector of a cell at a vertex gets two cuts. The first part
/// of a cell keeps its id. O(n log n).
Domain split_cells(Domain domain, const std::vector<Cut>& cuts);

}  // namespace quadline
