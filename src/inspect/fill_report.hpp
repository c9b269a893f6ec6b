#pragma once

#include "domain/domain.hpp"
#include "quadline/generate.hpp"

namespace quadline {

/// What a report says of the domain; its findings come before those that are there.
void describe_domain(const Domain& domain, Report& report);

/// What a report says of its mesh.
/// @pre the report's corners are known.
void measure_result(MeshResult& result);

}  // namespace quadline
