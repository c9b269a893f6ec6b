#pragma once

#include "quadline/model.hpp"
#include "quadline/options.hpp"

namespace quadline {

/// @throws InputError  neither the model nor the options give a target size.
void check_size_given(const Model& model, const Options& options);

}  // namespace quadline
