#pragma once

#include "domain/domain.hpp"
#include "domain/size_field.hpp"
#include "mesh/work_mesh.hpp"
#include "quadline/context.hpp"
#include "stages/discretize/chords.hpp"

namespace quadline {

/// Places the nodes of the boundaries, lines and points by the size field.
///
/// The number of edges round every cell comes out even (a line inside a cell counts twice): the parity of each curve's
/// count follows from a label 0 or 1 per vertex, chosen where it hurts the sizes least.
///
/// @param use  edges that will be halved keep farther from what lies near an arc.
/// @return  nodes (tagged) and `segments`; no faces yet.
WorkMesh discretize(const Domain& domain, const SizeField& size, EdgeUse use, Context& context);

}  // namespace quadline
