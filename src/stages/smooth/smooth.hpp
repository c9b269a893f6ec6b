#pragma once

#include "domain/domain.hpp"
#include "domain/size/size_field.hpp"
#include "mesh/work_mesh.hpp"
#include "quadline/context.hpp"
#include "quadline/criteria.hpp"

namespace quadline {

struct SmoothOptions {
  int passes = 8;                      ///< at most so many sweeps of each step, >= 0; 0: the mesh stays
  bool slides = true;                  ///< nodes on curves too
  bool raises_beta = true;             ///< at the cost of angles and of even rows
  double min_move = 2e-3;              ///< a node that wants to move less stays; in target sizes, > 0
  std::optional<Criteria> criteria{};  ///< limits that nodes move towards at last; growth is not looked at
};

/// Smoothing: constrained Laplacian, untangling, optimisation of the shape and of the worst elements, polish of beta
/// and of even rows.
///
/// Nodes on straight curves slide along them and keep their order; those on arcs and at vertices stay. So does the
/// connectivity.
///
/// @pre   quads only.
/// @post  Around every node that was sound the least scaled Jacobian is no lower than before, or above 0.84. Around
///        the others it rises above 0 where the connectivity lets it: a node with two quads, or a fixed straight
///        corner that one quad fills, it does not.
/// @throws Cancelled when `context` asks for it.
/// Cost O(passes * nodes); sweeps look only at what is near a change. Limits: some hopeless quads may end no better.
/// Source: [Lee2003 section 6]; inverse mean ratio [Knupp2000]; untangling [Garanzha2021]. See docs/smoothing.md.
void smooth(WorkMesh& mesh, const Domain& domain, const SizeField& size, const SmoothOptions& options,
            Context& context);

}  // namespace quadline
