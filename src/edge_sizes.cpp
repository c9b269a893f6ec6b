#include "edge_sizes.hpp"

#include "domain/arrange.hpp"
#include "quadline/generate.hpp"
#include "quadline/quality.hpp"

namespace quadline {

std::vector<double> edge_sizes(const Mesh& mesh, const SizeField& size) {
  std::vector<double> sizes;
  for (const auto& [a, b] : edges_of(mesh)) sizes.push_back(size.at(midpoint(mesh.points[a], mesh.points[b])));
  return sizes;
}

std::vector<double> edge_sizes(const Mesh& mesh, const Model& model, const Options& options, Context& context) {
  const Domain domain = arrange(model, options, context);
  return edge_sizes(mesh, make_size_field(domain, options, context));
}

}  // namespace quadline
