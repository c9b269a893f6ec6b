#pragma once

#include "quadline/context.hpp"
#include "quadline/model.hpp"
#include "quadline/options.hpp"

namespace quadline {

/// @throws InputError  neither the model nor the options give a target size.
void check_size_given(const Model& model, const Options& options);

/// @throws InputError  more than `most` quads are expected; or as `arrange`.
void refuse_too_large(const Model& model, const Options& options, double most, Context& context);

}  // namespace quadline
