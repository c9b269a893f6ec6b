#pragma once

#include <vector>

#include "domain/cell_set.hpp"
#include "domain/domain.hpp"
#include "domain/size/size_field.hpp"
#include "mesh/work_mesh.hpp"
#include "quadline/context.hpp"

namespace quadline {

/// Places the nodes of the boundaries, lines and points by the size field.
///
/// The number of edges round every cell comes out even (a line inside a cell counts twice): the parity of each curve's
/// count follows from a label 0 or 1 per vertex, chosen where it hurts the sizes least.
///
/// @param size    of the edges of the mesh in the end.
/// @param wished  numbers of edges that curves want for what is planned beside them; 0, or none at all: no wish.
/// @param halved  cells whose edges will be halved. The curves round them get edges of twice the size, which keep
///                farther from what lies near an arc; the other cells there count each of them as two.
/// @return  nodes (tagged), those of the vertices first, and `segments`; no faces yet.
/// @throws Cancelled when `context` asks for it.
WorkMesh discretize(const Domain& domain, const SizeField& size, const IdVector<CurveId, std::uint32_t>& wished,
                    const CellSet& halved, Context& context);

/// The curves round some cells, in id order: where the edges will be halved.
std::vector<CurveId> curves_round(const Domain& domain, const CellSet& cells);

}  // namespace quadline
