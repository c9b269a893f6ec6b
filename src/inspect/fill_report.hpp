#pragma once

#include <cstddef>

#include "domain/domain.hpp"
#include "quadline/generate.hpp"

namespace quadline {

/// What a model is made of, without the rings round its circles.
struct DomainCounts {
  std::size_t n_cells, n_curves, n_vertices;
};
/// @pre the domain is not cut at axes.
DomainCounts counts_of(const Domain& domain);

/// What a report says of the domain; its findings come before those that are there.
void describe_domain(const Domain& domain, Report& report);

/// What a report says of its mesh.
/// @pre the report's corners are known.
void measure_result(MeshResult& result);

}  // namespace quadline
