#pragma once

#include <optional>
#include <vector>

#include "quadline/context.hpp"
#include "quadline/failure.hpp"
#include "quadline/mesh.hpp"
#include "quadline/model.hpp"
#include "quadline/options.hpp"
#include "quadline/report.hpp"

namespace quadline {

/// What `generate` gives.
struct MeshResult {
  Mesh mesh;                       ///< the best mesh so far where `failure` is set
  Report report;                   ///< counts, findings, times and quality
  std::vector<double> edge_sizes;  ///< target size at the middle of each of edges_of(mesh), model units; may be empty
                                   ///< where `failure` is set
  std::optional<Failure> failure;  ///< empty: valid, all quadrilaterals, every constraint in it
};

/// Meshes a model with quadrilaterals, with element edges along every line [Lee2003].
///
/// Same model, same options: the same mesh, bit for bit.
///
/// @throws InputError  the model or an option is wrong; the message says what, where and what to do.
/// @throws Cancelled   the context asked for it.
MeshResult generate(const Model& model, const Options& options, Context& context);

/// The sizes that `generate` aims at, for a mesh of the model that anyone may have made.
///
/// @return  target size at the middle of each of edges_of(mesh), model units.
/// @throws InputError, Cancelled  as `generate`.
/// Cost O(n log n).
std::vector<double> edge_sizes(const Mesh& mesh, const Model& model, const Options& options, Context& context);

}  // namespace quadline
