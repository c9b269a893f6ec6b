#pragma once

#include <functional>
#include <string_view>

#include "quadline/errors.hpp"
#include "quadline/mesh.hpp"

namespace quadline {

/// What a run shares with its caller: progress, cancelling, threads, snapshots. Every member may stay empty.
struct Context {
  std::function<void(std::string_view stage, double fraction)> on_progress;  ///< fraction of the stage, 0..1
  std::function<bool()> is_cancelled;                                        ///< true: stop with Cancelled
  std::function<void(std::string_view name, const Mesh& mesh)> on_snapshot;  ///< the mesh after a stage
  unsigned threads = 1;                                                      ///< the mesh does not depend on it

  /// Reports progress and gives the caller the chance to stop.
  /// @throws Cancelled when the caller asks for it.
  void progress(std::string_view stage, double fraction) const {
    if (on_progress) on_progress(stage, fraction);
    if (is_cancelled && is_cancelled()) throw Cancelled();
  }
};

}  // namespace quadline
