#pragma once

#include "domain/domain.hpp"
#include "quadline/context.hpp"
#include "quadline/model.hpp"
#include "quadline/options.hpp"

namespace quadline {

/// Area of the domain, model units squared.
double area_of(const Domain& domain);

/// About how many quads a mesh of the domain takes: its cells by their sizes, and what finer lines and curved edges add
/// on the way from their size to that of the cell.
double expected_quads(const Domain& domain, const Options& options);

/// @throws InputError  neither the model nor the options give a target size.
void check_size_given(const Model& model, const Options& options);

/// @throws InputError  more than `most` quads are expected; or as `arrange`.
void refuse_too_large(const Model& model, const Options& options, double most, Context& context);

}  // namespace quadline
