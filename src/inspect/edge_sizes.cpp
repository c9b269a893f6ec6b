#include "domain/size/edge_sizes.hpp"

#include "domain/arrange/arrange.hpp"
#include "quadline/generate.hpp"

namespace quadline {

std::vector<double> edge_sizes(const Mesh& mesh, const Model& model, const Options& options, Context& context) {
  check(options);
  const Domain domain = arrange(model, options, context);
  return edge_sizes(mesh, make_size_field(domain, options, context));
}

}  // namespace quadline
