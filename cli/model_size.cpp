#include "cli/model_size.hpp"

#include "quadline/errors.hpp"

namespace quadline {

void check_size_given(const Model& model, const Options& options) {
  if (options.size || model.size > 0) return;
  throw InputError("the model gives no target size: give --size H", Where{model.file, {}, {}});
}

}  // namespace quadline
