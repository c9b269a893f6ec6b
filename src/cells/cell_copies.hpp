#pragma once

#include <functional>
#include <utility>
#include <vector>

#include "cells/curve_nodes.hpp"
#include "domain/domain.hpp"
#include "domain/size/size_field.hpp"
#include "domain/symmetry/symmetries.hpp"
#include "mesh/work_mesh.hpp"

namespace quadline {

/// A cell that is like another one, and how it lies to it.
struct CellCopy {
  CellId original, copy;
  Isometry move;                                        ///< takes the original to the copy
  std::vector<std::pair<VertexId, VertexId>> vertices;  ///< from the original to the copy, sorted
  std::vector<std::pair<CurveId, DirectedCurve>> curves;
};

/// The cells that need no mesh of their own: their nodes on curves, lines and points are those of another cell, moved
/// and turned or mirrored, and so are the sizes.
///
/// First each orbit of cells under the symmetries of the domain has one original, so that the mesh of all is symmetric;
/// then originals with the same boundary have one.
///
/// @param is_alike  two cells are to be meshed the same way.
/// @return  in the order in which they can be made: no original is a later copy.
/// Cost O(n log n) for n nodes.
std::vector<CellCopy> find_copies(const Domain& domain, const std::vector<Symmetry>& symmetries,
                                  const CurveNodes& nodes, const SizeField& size,
                                  const std::function<bool(CellId, CellId)>& is_alike);

/// The mesh of the copy. @param mesh  of the original, at any stage. O(n log n).
WorkMesh copied(const WorkMesh& mesh, const CellCopy& copy, const CurveNodes& nodes);

}  // namespace quadline
