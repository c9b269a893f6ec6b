#include "cli/estimate.hpp"

#include "cli/console.hpp"
#include "quadline/errors.hpp"
#include "quadline/inspect.hpp"

namespace quadline {

void check_size_given(const Model& model, const Options& options) {
  if (options.size || model.size > 0) return;
  throw InputError("the model gives no target size: give --size H", Where{model.file, {}, {}});
}

void refuse_too_large(const Model& model, const Options& options, double most, Context& context) {
  if (estimate_at_most(model, options) <= most) return;
  const double expected = estimate(model, options, context).quads;
  if (expected <= most) return;
  throw InputError(ErrorCode::TooManyQuads,
                   "about " + rounded(expected, 2) + " quads are expected, more than " + rounded(most, 6) +
                       ": choose a larger size, or raise --max-quads",
                   Where{model.file, {}, {}});
}

}  // namespace quadline
