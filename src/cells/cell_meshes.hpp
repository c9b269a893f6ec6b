#pragma once

#include <vector>

#include "base/stage_clock.hpp"
#include "cells/cell_cache.hpp"
#include "cells/cell_copies.hpp"
#include "cells/curve_nodes.hpp"
#include "cells/fallback_plan.hpp"
#include "cells/mesh_cell.hpp"
#include "cells/spaced_sizes.hpp"
#include "domain/cell_set.hpp"
#include "domain/size/size_field.hpp"
#include "quadline/context.hpp"
#include "quadline/report.hpp"

namespace quadline {

/// The meshes of all cells of a domain, each made by `mesh_cell`.
class CellMeshes {
 public:
  /// Meshes every cell as the plan says, several at once where the context can, but only one of those that are alike:
  /// the others get copies. Tells the context's `on_snapshot` the stages. What is passed must outlive this.
  /// @param cache  of earlier attempts; gets the cells of this one, unless it is the first.
  /// @throws Cancelled when `context` asks for it.
  CellMeshes(const FallbackPlan& plan, const CurveNodes& nodes, const SizeField& size, CellCache& cache,
             StageClock& clock, const Context& context);

  /// Cells without a mesh, in their order.
  std::vector<Trouble> troubles() const;
  /// Who made the quads. Not after `take_joined`, which takes them.
  CellOrigins origins() const;
  /// What Q-Morph did in the cells that it meshed.
  MorphCounts morph_counts() const;
  /// All cells as Q-Morph or halving left them, before clean-up. Once: their memory goes.
  WorkMesh take_raw();
  /// All cells together. Their memory goes, where `mesh_spoiled_again` will have nothing to do.
  WorkMesh take_joined();

  /// As a fall-back, halving leaves sound quads where the triangles were, however thin. Where clean-up and smoothing
  /// spoil them, these cells are meshed again, and more and more of what is round the place stays as it was, until no
  /// more quads are spoiled than were not sound before.
  /// @param smoothed  what became of `take_joined`.
  /// @return  false: nothing was done.
  bool mesh_spoiled_again(const WorkMesh& smoothed);

 private:
  void mesh(const CellSet& cells);
  void copy(const CellCopy& copy);
  void copy_trouble(const CellCopy& copy);
  void freeze_grids();
  void keep_in_cache(CellId c);
  void tell_snapshots() const;

  const FallbackPlan& plan_;
  const CurveNodes& nodes_;
  CellCache& cache_;
  StageClock& clock_;
  const Context& context_;
  IdVector<CellId, Recipe> recipes_;
  const SpacedSizes sizes_;
  const cleanup::TemplateTable templates_;
  IdVector<CellId, CellResult> results_;
  std::vector<Point> spoiled_;     ///< places of quads, of all rounds
  std::size_t rounds_ = 0;         ///< of `mesh_spoiled_again`
  std::size_t n_raw_unsound_ = 0;  ///< quads, of cells halved as a fall-back
};

}  // namespace quadline
