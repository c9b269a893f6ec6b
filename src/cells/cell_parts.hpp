#pragma once

#include <cstdint>
#include <vector>

#include "domain/domain.hpp"
#include "mesh/work_mesh.hpp"

namespace quadline {

/// The nodes and segments of single cells, out of those of a whole domain. Between two cells nothing but these is
/// shared, so each cell can be meshed by itself.
class CellNodes {
 public:
  /// @param nodes  as `discretize` returns them: those of the vertices first, no faces. Must outlive this.
  CellNodes(const Domain& domain, const WorkMesh& nodes);

  /// A mesh without faces: what bounds the cell, and the lines and points inside it. O(n log n) for its n nodes.
  WorkMesh of(CellId c) const;
  /// Number of segments of the cell.
  std::size_t count(CellId c) const { return segments_[c].size(); }

 private:
  const Domain& domain_;
  const WorkMesh& nodes_;
  IdVector<CellId, std::vector<std::uint32_t>> segments_;  ///< indices, of each cell
};

/// Puts meshes of single cells together at the nodes that they share on curves. What is frozen stays so.
///
/// @pre  nodes of two parts at one place of a curve have the same tag, but for its kind. Where two parts have other
///       nodes on a curve between them, the mesh has a crack there, and the constraints of one side.
/// Cost O(n log n).
WorkMesh joined(const IdVector<CellId, WorkMesh>& parts);

}  // namespace quadline
