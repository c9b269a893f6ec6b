#pragma once

#include <cstdint>
#include <optional>

#include "mesh/work_mesh.hpp"
#include "quadline/report.hpp"

namespace quadline {

/// Number that tells meshes apart: by the points of their faces, in order. O(n).
std::uint64_t fingerprint(const WorkMesh& mesh);

/// Cells as clean-up left them in an earlier attempt. Most cells begin the next one with the same quads, and need not
/// go through the slow steps again; sizes that a fall-back beside a cell has changed a little inside it make no
/// difference then. Different cells may be used at the same time.
class CellCache {
 public:
  explicit CellCache(std::size_t n_cells) : entries_(n_cells) {}

  struct Entry {
    std::uint64_t start;
    WorkMesh mesh;
    MorphCounts counts;
  };
  /// What became of the cell when it began like that; null: not known.
  const Entry* find(CellId c, std::uint64_t start) const {
    return entries_[c] && entries_[c]->start == start ? &*entries_[c] : nullptr;
  }
  void keep(CellId c, const Entry& entry) { entries_[c] = entry; }

 private:
  IdVector<CellId, std::optional<Entry>> entries_;
};

}  // namespace quadline
