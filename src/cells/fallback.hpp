#pragma once

#include <optional>
#include <string>
#include <vector>

#include "domain/domain.hpp"
#include "mesh/work_mesh.hpp"
#include "quadline/report.hpp"

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

/// A cell where a mesh breaks the promise.
struct Trouble {
  CellId cell;
  std::string reason;  ///< one line
  Point at;
  bool is_thin = false;  ///< a quad there is so thin that the drawing must be: only halving helps
};

/// The cells where a quad is not sound or a triangle is left, each with the first such place; in the order of the
/// cells.
std::vector<Trouble> unsound_cells(const WorkMesh& mesh);

/// The cells at a place: those beside the curves within the tolerance of it, else the one that holds it; all cells
/// where there is none, or the place is unknown.
std::vector<Trouble> troubles_at(const Domain& domain, std::optional<Point> place, const std::string& reason);

/// Which cells are meshed otherwise than asked, and why.
class FallbackPlan {
 public:
  explicit FallbackPlan(const Domain& domain) : domain_(domain), rung_(domain.cells.count(), 0), why_(rung_.count()) {}

  /// Takes the cells in trouble a rung further; straight to halving where a quad is thin, and beside cells that are
  /// halved, as what troubles one mostly troubles the other.
  /// @return  false: nothing is left to be tried.
  bool advance(const std::vector<Trouble>& troubles);

  const Rung& rung(CellId c) const { return kRungs[rung_[c]]; }
  bool is_changed(CellId c) const { return rung_[c] > 0; }  ///< not meshed as asked
  bool is_first() const { return attempts_ == 1; }          ///< all cells as asked
  /// The domain with the sizes of the plan.
  Domain domain() const;
  /// A finding for each cell that was not meshed as asked, at a place inside it.
  std::vector<Finding> findings(const WorkMesh& mesh) const;
  /// A finding for each cell where nothing helped.
  std::vector<Finding> failures(const std::vector<Trouble>& troubles) const;

 private:
  bool is_beside_halved(CellId c) const;
  std::string name_of(CellId c) const;

  const Domain& domain_;
  IdVector<CellId, std::size_t> rung_;
  IdVector<CellId, std::string> why_;  ///< the first reason
  std::size_t attempts_ = 1;
};

}  // namespace quadline
