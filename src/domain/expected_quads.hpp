#pragma once

#include "domain/domain.hpp"
#include "quadline/options.hpp"

namespace quadline {

/// Area of the domain, model units squared.
double area_of(const Domain& domain);

/// About how many quads a mesh of the domain takes: its cells by their sizes, what finer lines, curved edges and points
/// add on the way from their size to that of the cell, and what thin cells need along their curves.
double expected_quads(const Domain& domain, const Options& options);

}  // namespace quadline
