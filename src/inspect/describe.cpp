#include <algorithm>
#include <utility>

#include "domain/arrange/arrange.hpp"
#include "domain/corners.hpp"
#include "domain/expected_quads.hpp"
#include "domain/size/size_field.hpp"
#include "inspect/fill_report.hpp"
#include "quadline/inspect.hpp"

namespace quadline {

namespace {

Estimate estimate_of(const Domain& domain, const Options& options, Context& context) {
  double quads = expected_quads(domain, options);
  if (options.size_at) quads = std::max(quads, make_size_field(domain, options, context).quads_expected());
  return {.quads = quads, .area = area_of(domain)};
}

}  // namespace

Estimate estimate(const Model& model, const Options& options, Context& context) {
  check(options);
  return estimate_of(arrange(model, options, context), options, context);
}

ModelFacts describe(const Model& model, const Options& options, Context& context) {
  check(options);
  Domain domain = arrange(model, options, context);
  const DomainCounts counts = counts_of(domain);
  return {.size = domain.size,
          .tolerance = domain.tolerance,
          .low = domain.box.lo,
          .high = domain.box.hi,
          .n_cells = counts.n_cells,
          .n_curves = counts.n_curves,
          .n_vertices = counts.n_vertices,
          .expected = estimate_of(domain, options, context),
          .findings = std::move(domain.findings),
          .corners = corners_of(domain)};
}

}  // namespace quadline
