#include "stages/smooth/smooth.hpp"

#include "stages/smooth/measures.hpp"

namespace quadline {

void smooth(WorkMesh& mesh, const Domain& domain, const SizeField& size, const SmoothOptions& options,
            Context& context) {
  Stars stars(mesh, domain, size);
  laplacian(stars, options.passes / 5, options.min_move);
  context.progress("smooth", 0.2);
  optimize(stars, options.passes, options.min_move, 1);
  context.progress("smooth", 0.5);
  optimize(stars, options.passes / 2, options.min_move, 3);
  context.progress("smooth", 0.7);
  polish(stars, options.passes / 2, options.min_move);
  context.progress("smooth", 1);
  stars.store(mesh);
}

}  // namespace quadline
