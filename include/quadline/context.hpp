#pragma once

#include <cstddef>
#include <functional>
#include <string_view>

#include "quadline/errors.hpp"
#include "quadline/mesh.hpp"

namespace quadline {

/// What a run shares with its caller: progress, cancelling, threads, snapshots. Every member may stay empty.
///
///     std::atomic<bool> stop = false;  // set by another thread, or by a button
///     quadline::Context context;
///     context.on_progress = [](std::string_view stage, double fraction) { show(stage, fraction); };
///     context.is_cancelled = [&] { return stop.load(); };
///     context.run_all = [&](std::size_t n, const std::function<void(std::size_t)>& job) { pool.for_each(n, job); };
///     const quadline::MeshResult result = quadline::generate(model, {}, context);  // throws Cancelled once `stop` is
///     set
struct Context {
  /// Tells what part of a stage is done, 0..1. Where `run_all` uses threads it is called from them, also at once.
  std::function<void(std::string_view stage, double fraction)> on_progress;
  /// True: stop with Cancelled. Called as `on_progress` is.
  std::function<bool()> is_cancelled;
  /// Gets the mesh after a stage.
  std::function<void(std::string_view name, const Mesh& mesh)> on_snapshot;
  /// Calls `job(i)` once for every i < n and returns when all are done: in any order, also at once in several threads.
  /// No job throws. Empty: one after the other. The mesh does not depend on it.
  std::function<void(std::size_t n, const std::function<void(std::size_t)>& job)> run_all;

  /// Reports progress and gives the caller the chance to stop.
  /// @throws Cancelled when the caller asks for it.
  void progress(std::string_view stage, double fraction) const {
    if (on_progress) on_progress(stage, fraction);
    if (is_cancelled && is_cancelled()) throw Cancelled();
  }
};

}  // namespace quadline
