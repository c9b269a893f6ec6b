#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "cells/cell_copies.hpp"

namespace quadline {

/// Calls `visit(DirectedCurve)` for every curve round the cell and in it; twice for a line inside it.
template <class Visit>
void for_each_curve(const Domain::Cell& cell, Visit visit) {
  for (const std::vector<DirectedCurve>& walk : cell.walks)
    for (const DirectedCurve& d : walk) visit(d);
}

/// Sorts the vertices and curves of a copy, each once.
void sort_maps(CellCopy& copy);

/// What congruent cells have in common: numbers of edges, walks and points. O(n log n).
std::vector<std::uint32_t> kind_of(const Domain& domain, const CurveNodes& nodes, CellId c);

/// Tells whether a cell can have the mesh of another one, moved.
class CellMatcher {
 public:
  /// What is passed must outlive this.
  CellMatcher(const Domain& domain, const CurveNodes& nodes, const SizeField& size)
      : domain_(domain), nodes_(nodes), size_(size) {}

  /// The nodes and sizes of the copy are those of the original, moved: within a hundredth of an edge, and two of the
  /// size. O(n) for n nodes.
  bool fits(const CellCopy& copy) const;

  /// How one cell lies to another: not turned rather than turned, and not mirrored rather than mirrored. O(n log n).
  std::optional<CellCopy> find(CellId original, CellId copy) const;

 private:
  struct Alignment;
  bool fits_node(const Isometry& move, NodeId from, NodeId to) const;
  bool fits_curve(const Isometry& move, CurveId from, DirectedCurve to) const;
  std::optional<CellCopy> try_alignment(CellId original, CellId copy, const Alignment& alignment) const;
  bool map_inside(CellCopy& copy) const;

  const Domain& domain_;
  const CurveNodes& nodes_;
  const SizeField& size_;
};

}  // namespace quadline
