#pragma once

#include <functional>
#include <string_view>

#include "domain/size/size_field.hpp"
#include "mesh/work_mesh.hpp"
#include "quadline/context.hpp"
#include "quadline/options.hpp"
#include "quadline/report.hpp"

namespace quadline {

struct FrontOptions {
  LineFronts lines = LineFronts::TwoSided;
  std::size_t steps_per_triangle = 64;  ///< a front that takes more spins
};

/// Merges the triangles to quads along an advancing front: Q-Morph [Owen1999] with line constraints [Lee2003].
///
/// @param observe  called after the first layer of quads and half-way, with a name; may be empty.
/// @return        what was done, and how often.
/// @pre   triangles only; an even number of edges round every cell.
/// @post  quads only; every constraint is an edge still. Quads may be badly shaped, even inverted, where the front
///        closed in haste: clean-up and smoothing mend that.
/// @throws InternalError  the edges round a cell are odd in number, or the front does not end.
/// Cost O(n log n).
MorphCounts merge_to_quads(WorkMesh& mesh, const SizeField& size, const FrontOptions& options,
                           const std::function<void(std::string_view, const WorkMesh&)>& observe, Context& context);

}  // namespace quadline
