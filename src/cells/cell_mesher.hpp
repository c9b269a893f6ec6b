#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "base/stage_clock.hpp"
#include "cells/cell_cache.hpp"
#include "cells/cell_parts.hpp"
#include "cells/fallback.hpp"
#include "domain/cell_set.hpp"
#include "domain/size/size_field.hpp"
#include "quadline/context.hpp"
#include "quadline/options.hpp"
#include "stages/cleanup/cleanup.hpp"

namespace quadline {

/// Meshes the cells of a domain, each by itself from the nodes on its curves on, several at once where the context can.
///
/// An InternalError in a cell is trouble of that cell alone: the stages leave it out from there on.
class CellMesher {
 public:
  /// Gets the mesh of all cells that are not in trouble; may be empty.
  using Observe = std::function<void(std::string_view name, const WorkMesh& mesh)>;

  /// What is passed must outlive this.
  /// @param size   sizes of the plan.
  /// @param cache  of earlier attempts; gets the cells of this one, unless it is the first.
  CellMesher(const Domain& domain, const SizeField& size, const FallbackPlan& plan, const Options& options,
             CellCache& cache, const Context& context, StageClock& clock, Observe observe);

  // In this order; each runs one stage or more of all cells.
  void place_nodes();
  void make_triangles();
  void make_quads();     ///< by Q-Morph; halved cells by pairing and halving
  void clean_up();       ///< thin quads of `fallen_back` cells stay, frozen from there on
  void try_triangles();  ///< other ones, where those of a cell leave something to wish for, or its quads failed
  /// Cleans some of the `fallen_back` cells up anew, from the quads of `make_quads` on, without those that `freeze`
  /// freezes.
  void clean_up_again(const CellSet& cells, const std::function<void(WorkMesh&)>& freeze);

  /// Quads that the cells need at least, for the edges on their curves: no fewer than a row one quad wide.
  /// @pre place_nodes() is done.
  double least_quads() const;
  /// Cells that are halved as a fall-back.
  const CellSet& fallen_back() const { return fallen_back_; }
  /// Cells where a stage failed, in their order.
  std::vector<Trouble> troubles() const;
  /// What Q-Morph did in the cells that it meshed, with the triangles that were kept.
  MorphCounts morph_counts() const;
  /// The mesh of all cells that are not in trouble.
  WorkMesh mesh() const { return joined(parts_); }
  /// The same, for the last time where no cell has fallen back: the parts' memory goes.
  WorkMesh cleaned_mesh();

 private:
  template <class Work>
  void run(const char* stage, Work work);
  void note(CellId c, const InternalError& error);
  void observe(std::string_view name) const;
  bool is_halved(CellId c) const { return halved_.contains(c); }
  Triangles triangles_of(CellId c) const;
  IdVector<CellId, double> weights() const;
  void merge();
  void halve();
  bool take_from_cache(CellId c);
  void keep_in_cache(CellId c);
  WorkMesh triangulated(CellId c, Context& context) const;
  void try_triangles_of(CellId c, Context& context);

  const Domain& domain_;
  const SizeField& size_;
  const FallbackPlan& plan_;
  const Options& options_;
  const Context& context_;
  StageClock& clock_;
  CellCache& cache_;
  const Observe observe_;
  const cleanup::TemplateTable templates_;
  CellSet halved_, fallen_back_;        ///< the one by the method or as a fall-back, the other as a fall-back alone
  SizeField double_size_;               ///< for the halved cells
  std::vector<SizeField> other_sizes_;  ///< for other triangles
  WorkMesh nodes_, halved_nodes_;       ///< of whole and of halved cells
  std::optional<CellNodes> of_whole_, of_halved_;
  IdVector<CellId, WorkMesh> parts_;
  IdVector<CellId, WorkMesh> raw_;  ///< of the cells that have fallen back, before clean-up
  IdVector<CellId, MorphCounts> counts_;
  IdVector<CellId, std::optional<Trouble>> troubles_;
  IdVector<CellId, std::uint64_t> starts_;  ///< fingerprints before clean-up
  IdVector<CellId, std::uint8_t> is_done_;  ///< taken from the cache
};

}  // namespace quadline
