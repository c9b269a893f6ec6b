#include "stages/smooth/smooth.hpp"

#include "stages/smooth/measures.hpp"

namespace quadline {

namespace {

constexpr double kSound = 0.75;  // squared sine of the worst corner above which a star needs no second look

}  // namespace

void smooth(WorkMesh& mesh, const Domain& domain, const SizeField& size, const SmoothOptions& options,
            Context& context) {
  Stars stars(mesh, domain, size);
  laplacian(stars, options.passes / 5, options.min_move);
  context.progress("smooth", 0.2);
  optimize(stars, options.passes, 4 * options.min_move, 1, 1);
  context.progress("smooth", 0.5);
  optimize(stars, options.passes / 2, options.min_move, 3, kSound);
  context.progress("smooth", 0.7);
  polish(stars, options.passes / 2, options.min_move);
  context.progress("smooth", 1);
  stars.store(mesh);
}

}  // namespace quadline
