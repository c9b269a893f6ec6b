#pragma once

#include <cstddef>

#include "domain/domain.hpp"
#include "quadline/generate.hpp"

namespace quadline {

/// Without those of rings: the model knows none of them.
std::size_t cell_count(const Domain& domain);
std::size_t curve_count(const Domain& domain);

/// What a report says of the domain; its findings come before those that are there.
void describe_domain(const Domain& domain, Report& report);

/// What a report says of its mesh.
/// @pre the report's corners are known.
void measure_result(MeshResult& result);

}  // namespace quadline
