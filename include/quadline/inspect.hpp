#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "quadline/context.hpp"
#include "quadline/generate.hpp"
#include "quadline/mesh.hpp"
#include "quadline/model.hpp"
#include "quadline/options.hpp"
#include "quadline/quality.hpp"
#include "quadline/report.hpp"

namespace quadline {

/// How much there will be to mesh.
struct Estimate {
  double quads = 0;  ///< about so many quads
  double area = 0;   ///< of the domain, model units squared
};

/// About how many quads `generate` will make, without making them.
/// @throws InputError, Cancelled  as `generate`; not for more than Options::max_quads.
/// Cost O((n + k) log n) for n pieces and k meetings of curves; with a size function, that of its size field too.
Estimate estimate(const Model& model, const Options& options, Context& context);

/// What a model holds once it is arranged: what crosses is cut, what overlaps is one.
struct ModelFacts {
  double size = 0;                                        ///< target edge length, model units
  double tolerance = 0;                                   ///< distance below which points are one, model units
  Point low, high;                                        ///< the box of the outer loops, model units
  std::size_t n_cells = 0, n_curves = 0, n_vertices = 0;  ///< of the arrangement
  Estimate expected;                                      ///< what `estimate` gives
  std::vector<Finding> findings;                          ///< what was found in the model and mended
  std::vector<CellCorner> corners;                        ///< in which quads cannot all have right angles
};

/// Arranges a model and tells what it holds.
/// @throws InputError, Cancelled  as `generate`.
/// Cost as `estimate`.
ModelFacts describe(const Model& model, const Options& options, Context& context);

/// How a mesh stands to a model.
struct Verification {
  std::optional<Failure> broken;    ///< the first promise that the mesh breaks; empty: it keeps all
  std::vector<CellCorner> corners;  ///< of the model, in which quads cannot all have right angles
  std::vector<double> edge_sizes;   ///< as `edge_sizes` gives them; empty where model and options give no target size
};

/// Checks that a mesh, whoever made it, keeps what `generate` promises of a model: all quads, counter-clockwise,
/// strictly convex, conforming; over the whole domain and nothing else; edges along every curve, a node on every point.
/// Curves and points are found by their place, whatever the mesh calls them.
///
/// @param model    need not give a target size.
/// @param options  of which the tolerance counts, and the sizes for `edge_sizes`.
/// @throws InputError  (InvalidMesh) an element or a curve of the mesh has a node that is not there; else as
/// `generate`. Cost O((n + m) log n) for n nodes and m nodes on curves.
Verification verify(const Mesh& mesh, const Model& model, const Options& options, Context& context);

}  // namespace quadline
