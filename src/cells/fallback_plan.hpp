#pragma once

#include <string>
#include <vector>

#include "cells/mesh_cell.hpp"
#include "cells/trouble.hpp"
#include "domain/cell_set.hpp"
#include "domain/domain.hpp"
#include "domain/symmetry/symmetries.hpp"
#include "mesh/work_mesh.hpp"
#include "quadline/context.hpp"
#include "quadline/options.hpp"
#include "quadline/report.hpp"
#include "stages/grid/plan_grids.hpp"

namespace quadline {

/// How a cell is meshed. The first rung is as asked; where that breaks the promise, the cell goes to the next one.
struct Rung {
  bool other_triangles;
  double refinement;  ///< of the sizes in the cell and round it
  bool is_halved;     ///< pairs of triangles at twice the size, and what stays alone, halved
  const char* what;
};
constexpr Rung kRungs[] = {{false, 1, false, "as asked"},
                           {true, 1, false, "with the other triangles"},
                           {false, 0.7, false, "with sizes 0.7 of those asked"},
                           {true, 0.5, false, "with the other triangles and half the sizes"},
                           {false, 1, true, "at twice the size and halved"},
                           {true, 0.5, true, "and halved, with half the sizes"},
                           {false, 0.25, true, "and halved, with a quarter of the sizes"}};
constexpr std::size_t kFirstHalving = 4;
static_assert(kRungs[kFirstHalving].is_halved && !kRungs[kFirstHalving - 1].is_halved);

/// Which cells are meshed otherwise than asked, and why.
class FallbackPlan {
 public:
  /// @param model    the domain of the model.
  /// @param options  as the user gave them; must outlive this.
  /// @param context  asked whether to stop.
  /// @param may_cut  cells that are symmetric are cut at their axes, but for Q-Morph alone, or where a function of
  /// place
  ///                 gives sizes.
  /// @throws Cancelled when `context` asks for it.
  FallbackPlan(Domain model, const Options& options, const Context& context, bool may_cut = true);

  /// Takes the cells in trouble, and their images, a rung further; straight to halving where a quad is thin, and beside
  /// cells that are halved, as what troubles one mostly troubles the other.
  /// @return  false: nothing is left to be tried.
  bool advance(const std::vector<Trouble>& troubles);

  const Rung& rung(CellId c) const { return kRungs[rung_[c]]; }
  bool is_changed(CellId c) const { return rung_[c] > 0; }  ///< not meshed as asked
  bool any_halved() const;                                  ///< as a fall-back
  bool is_first() const { return attempts_ == 1; }          ///< all cells as asked
  /// Cells whose edges will be halved: as a fall-back, or because the method does it.
  CellSet halved_cells() const;
  /// How the cell is meshed now.
  Recipe recipe(CellId c) const;
  /// Smoothing works towards limits that the user gave: in grids too, which else stay as they are among grids.
  bool has_criteria() const { return options_.criteria.has_value(); }
  /// Edges that curves want for the grids beside them; 0, or nothing at all: no wish.
  const IdVector<CurveId, std::uint32_t>& wished_counts() const { return grids_.counts; }
  /// Two cells are meshed the same way, and the domain tells all of their sizes.
  bool is_alike(CellId a, CellId b) const {
    return !options_.size_at && rung_[a] == rung_[b] && domain_.cells[a].rings == domain_.cells[b].rings;
  }
  /// Of the domain; none where a function of place gives sizes.
  const std::vector<Symmetry>& symmetries() const { return symmetries_; }
  /// The domain as it came.
  const Domain& model() const { return model_; }
  bool is_cut() const { return domain_.curves.count() > model_.curves.count(); }
  /// The domain with the cuts and the sizes of the plan.
  const Domain& domain() const { return domain_; }
  /// A finding for each cell that was not meshed as asked, at a place inside it, or that has no rings as the model
  /// asks.
  std::vector<Finding> findings(const WorkMesh& mesh) const;
  /// A finding for each cell where nothing helped.
  std::vector<Finding> failures(const std::vector<Trouble>& troubles) const;

 private:
  struct Sizes {
    std::vector<double> cells, curves, points;
  };
  void lay_out(const Context& context, bool may_cut);
  void set_sizes();
  void append_ringless(std::vector<Finding>& findings) const;
  bool is_beside_halved(CellId c) const;
  std::string name_of(CellId c) const;

  Domain model_, domain_;
  const Options& options_;
  GridPlans grids_;
  std::vector<Symmetry> symmetries_;
  Sizes asked_;  ///< of the domain as it came
  IdVector<CellId, std::size_t> rung_;
  IdVector<CellId, std::string> why_;  ///< the first reason
  std::size_t attempts_ = 1;
  std::size_t grid_failures_ = 0;
};

}  // namespace quadline
