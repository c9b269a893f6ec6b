#include <cmath>
#include <limits>

#include "domain/arrange/arrange.hpp"
#include "domain/corners.hpp"
#include "domain/size/edge_sizes.hpp"
#include "quadline/inspect.hpp"
#include "stages/verify/fit_to_model.hpp"
#include "stages/verify/verify.hpp"

namespace quadline {

namespace {

template <class Elements>
void check_nodes(const Elements& elements, std::size_t n_nodes) {
  for (const auto& element : elements)
    for (const NodeIndex node : element)
      if (node >= n_nodes)
        throw InputError(ErrorCode::InvalidMesh,
                         "the mesh has no node " + std::to_string(node) + ", which an element or a curve uses");
}

void check_arrays(const Mesh& mesh) {
  check_nodes(mesh.quads, mesh.points.size());
  check_nodes(mesh.triangles, mesh.points.size());
  for (const EdgeSet& curve : mesh.curves) check_nodes(curve.edges, mesh.points.size());
  for (const Point p : mesh.points)
    if (!std::isfinite(p.x) || !std::isfinite(p.y))
      throw InputError(ErrorCode::InvalidMesh, "a node of the mesh has a coordinate that is no number");
}

}  // namespace

Verification verify(const Mesh& mesh, const Model& model, const Options& options, Context& context) {
  check(options);
  check_arrays(mesh);
  Options sized = options;
  const bool is_sized = options.size || model.size > 0;
  if (!is_sized) sized.size = std::numeric_limits<double>::max();  // whether the mesh fits does not depend on it
  const Domain domain = with_circles_turned_to(mesh, arrange(model, sized, context));
  Verification found;
  found.broken = verify(fit_to_model(mesh, domain), domain, context);
  found.corners = corners_of(domain);
  if (is_sized) found.edge_sizes = edge_sizes(mesh, make_size_field(domain, options, context));
  return found;
}

}  // namespace quadline
