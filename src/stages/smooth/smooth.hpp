#pragma once

#include "domain/domain.hpp"
#include "domain/size_field.hpp"
#include "mesh/work_mesh.hpp"
#include "quadline/context.hpp"

namespace quadline {

struct SmoothOptions {
  int passes = 50;         ///< at most so many sweeps of each kind, >= 0
  double min_move = 1e-3;  ///< a sweep whose longest move is below this part of the local size is the last
};

/// Constrained Laplacian smoothing, then optimisation of the worst elements and untangling.
///
/// Nodes on curves slide along them; nodes at vertices stay. The connectivity stays.
///
/// @pre   quads only.
/// @post  the least scaled Jacobian is no lower than before.
/// Source: [Lee2003 section 6]; optimisation of the inverse mean ratio [Knupp2000]; untangling [Garanzha2021].
void smooth(WorkMesh& mesh, const Domain& domain, const SizeField& size, const SmoothOptions& options,
            Context& context);

}  // namespace quadline
