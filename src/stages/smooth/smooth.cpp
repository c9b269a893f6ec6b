#include "stages/smooth/smooth.hpp"

#include "stages/smooth/steps.hpp"

namespace quadline {

void smooth(WorkMesh& mesh, const Domain& domain, const SizeField& size, const SmoothOptions& options,
            Context& context) {
  if (options.passes <= 0) return;
  smoothing::Stars stars(mesh, domain, size);
  smoothing::laplacian(stars, options);
  context.progress("smooth", 0.15);
  smoothing::untangle(stars, options);
  context.progress("smooth", 0.2);
  smoothing::optimize(stars, options);
  context.progress("smooth", 0.4);
  smoothing::polish(stars, options);
  context.progress("smooth", 1);
  stars.store(mesh);
}

}  // namespace quadline
