#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/csr.hpp"
#include "domain/cell_set.hpp"
#include "domain/domain.hpp"
#include "domain/size/size_field.hpp"
#include "domain/symmetry/symmetries.hpp"
#include "mesh/work_mesh.hpp"
#include "quadline/context.hpp"

namespace quadline {

/// The nodes on all curves and at all points of a domain, and those of single cells out of them. Between two cells
/// nothing but these is shared, so each cell can be meshed by itself.
class CurveNodes {
 public:
  /// Places them by the size field, an even number of edges round every cell, as symmetric as the domain.
  /// @param wished  edges that curves want, see `discretize`.
  /// @param symmetries  of the domain and of `halved`.
  /// @param halved  cells whose edges will be halved: until then they have every second node.
  /// @throws Cancelled when `context` asks for it.
  CurveNodes(const Domain& domain, const SizeField& size, const IdVector<CurveId, std::uint32_t>& wished,
             const std::vector<Symmetry>& symmetries, const CellSet& halved, Context& context);

  /// A mesh without faces: what bounds the cell, and the lines and points inside it. O(n log n) for its n nodes.
  WorkMesh of(CellId c) const;
  /// The nodes in the end, halved or not: those of the vertices first, no faces.
  const WorkMesh& all() const { return all_.nodes; }
  /// Those of them inside a curve, in its direction.
  std::span<const NodeId> on(CurveId c) const { return on_curve_[c.value]; }
  /// Number of segments of the cell in the end, halved or not.
  std::size_t count(CellId c) const { return all_.of_cell[c.value].size(); }
  /// Quads that the cells need at least for their segments: no fewer than a row one quad wide.
  double least_quads() const;

 private:
  struct Layout {
    WorkMesh nodes;               ///< those of the vertices first, no faces
    Rows<std::uint32_t> of_cell;  ///< indices of segments
  };
  void sort_by_cells(Layout& layout) const;

  const Domain& domain_;
  CellSet halved_;
  Layout all_, before_halving_;  ///< the second is empty where no cell is halved
  Rows<NodeId> on_curve_;
};

}  // namespace quadline
