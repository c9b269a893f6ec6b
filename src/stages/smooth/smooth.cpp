#include "stages/smooth/smooth.hpp"

#include "stages/smooth/steps.hpp"

namespace quadline {

void smooth(WorkMesh& mesh, const Domain& domain, const SizeField& size, const SmoothOptions& options,
            Context& context) {
  if (options.passes <= 0) return;
  smoothing::Stars stars(mesh, domain, size, options.slides);
  const smoothing::Progress progress(context);
  smoothing::laplacian(stars, options, progress.part(0, 0.1));
  smoothing::untangle(stars, options, progress.part(0.1, 0.12));
  smoothing::optimize(stars, options, progress.part(0.12, 0.3));
  smoothing::raise_least_sine(stars, options, progress.part(0.3, 0.32));
  if (options.raises_beta) smoothing::raise_beta(stars, options, progress.part(0.32, 0.95));
  if (options.criteria) smoothing::meet_criteria(stars, options, progress.part(0.95, 1));
  progress.report(1);
  stars.store(mesh);
}

}  // namespace quadline
