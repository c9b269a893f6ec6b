#include "domain/size/edge_sizes.hpp"

#include "quadline/quality.hpp"

namespace quadline {

std::vector<double> edge_sizes(const Mesh& mesh, const SizeField& size) {
  std::vector<double> sizes;
  for (const auto& [a, b] : edges_of(mesh)) sizes.push_back(size.at(midpoint(mesh.points[a], mesh.points[b])));
  return sizes;
}

}  // namespace quadline
