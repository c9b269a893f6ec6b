#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "cells/cell_cache.hpp"
#include "cells/curve_nodes.hpp"
#include "cells/spaced_sizes.hpp"
#include "cells/trouble.hpp"
#include "domain/domain.hpp"
#include "mesh/work_mesh.hpp"
#include "quadline/context.hpp"
#include "quadline/options.hpp"
#include "quadline/report.hpp"
#include "stages/cleanup/cleanup.hpp"
#include "stages/grid/fill_grid.hpp"

namespace quadline {

/// What a cell is meshed from. What it refers to is only read, so that many cells can share it.
struct CellInput {
  const Domain& domain;  ///< for the geometry of the curves
  CellId cell;
  const CurveNodes& nodes;  ///< the cell's are taken
  const SpacedSizes& sizes;
  const cleanup::TemplateTable& templates;
  const CellCache* cache = nullptr;  ///< of earlier attempts; null: none
  bool wants_snapshots = false;
};

/// How a cell is meshed.
struct Recipe {
  Method method = Method::QMorph;
  Triangles triangles = Triangles::Front;   ///< of the first try
  LineFronts lines = LineFronts::TwoSided;  ///< QMorph: where fronts on lines start
  bool may_grid = false;                    ///< QMorph: not where a grid fills the cell well, or rings are asked for
  GridPlan grid{};                          ///< where may_grid
  bool may_retry = false;                   ///< QMorph: with other triangles, where they may make a better mesh
  bool keeps_thin_quads = false;            ///< clean-up and smoothing leave very thin quads as they are
  std::vector<Point> kept_places{};         ///< what lies near them stays as it is as well,
  double kept_reach = 0;                    ///< up to so many sizes from them

  bool is_grid_planned() const {
    return may_grid && (!grid.holes.empty() || grid.frame.is_polar || grid.is_disk || grid.rings > 0);
  }
};

/// Multiples of the sizes at which recipes space the points inside cells: of halved cells, and of retries.
inline constexpr double kHalvedSpacing = 2, kCloser = 0.93, kWider = 1.07;

/// The mesh of a cell after one of its stages; the names are those of `kCellSnapshots`.
struct CellSnapshot {
  std::string_view name;
  WorkMesh mesh;
};
/// In the order of the stages.
inline constexpr std::array<std::string_view, 6> kCellSnapshots = {
    "triangulation", "field-points", "first-layer", "half-way", "before-halving", "before-smoothing"};

struct CellResult {
  WorkMesh mesh;                        ///< clean quads; empty where there is `trouble`
  WorkMesh raw;                         ///< of the first try, as Q-Morph or halving left them; empty where it failed
  MorphCounts counts;                   ///< of Q-Morph, in the try whose quads became `mesh`
  std::uint64_t start = 0;              ///< fingerprint of `raw`
  bool is_grid = false;                 ///< `mesh` is a grid, smoothed
  bool is_copy = false;                 ///< of another cell's result
  bool is_cached = false;               ///< `mesh` was taken from the cache
  std::vector<StageTime> times;         ///< of its stages, in their order
  std::vector<CellSnapshot> snapshots;  ///< of the first try, where they are wanted
  std::optional<Trouble> trouble;       ///< the cell has no mesh
};

/// Meshes one cell, from the nodes on its curves to clean quads: triangles, field points, Q-Morph (or pairs, and
/// halving), clean-up; then the same with other triangles, where they may do better.
///
/// Cells do not depend on each other: many can be meshed at once.
/// @param context  told how much of the cell is done, 0..1, whatever the stage.
/// @throws Cancelled when `context` asks for it. An InternalError of a stage is `trouble`.
/// Cost O(n log n).
CellResult mesh_cell(const CellInput& input, const Recipe& recipe, Context& context);

}  // namespace quadline
