#include "cells/rehearse_grid.hpp"

#include <algorithm>
#include <cstddef>
#include <vector>

#include "base/constants.hpp"
#include "cells/accept_grid.hpp"
#include "cells/cell_cost.hpp"
#include "domain/size/size_field.hpp"
#include "quadline/context.hpp"
#include "stages/smooth/smooth.hpp"

namespace quadline {

namespace {

// Nodes and segments of the cell alone, equally spaced.
WorkMesh nodes_of(const Domain& domain, const std::vector<CountWish>& wishes) {
  WorkMesh mesh;
  std::vector<VertexId> vertices;
  for (const CountWish& wish : wishes)
    for (const VertexId v : {domain.curves[wish.curve].tail, domain.curves[wish.curve].head}) vertices.push_back(v);
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  for (const VertexId v : vertices) mesh.add_node(domain.vertices[v].at, {NodeKind::Fixed, CurveId(), 0, v});
  const auto vertex = [&](VertexId v) {
    return NodeId(std::lower_bound(vertices.begin(), vertices.end(), v) - vertices.begin());
  };
  for (const CountWish& wish : wishes) {
    const Domain::Curve& curve = domain.curves[wish.curve];
    NodeId last = vertex(curve.tail);
    for (std::uint32_t k = 1; k < wish.count; ++k) {
      const double s = length(curve.piece) * k / wish.count;
      const NodeId v = mesh.add_node(point_at(curve.piece, s), {NodeKind::OnCurve, wish.curve, s, VertexId()});
      mesh.add_segment({last, v, wish.curve});
      last = v;
    }
    mesh.add_segment({last, vertex(curve.head), wish.curve});
  }
  return mesh;
}

}  // namespace

double rehearsed_cost(const Domain& domain, CellId c, const GridProposal& proposal) {
  WorkMesh mesh = nodes_of(domain, proposal.wishes);
  if (!fill_grid(mesh, domain, c, proposal.plan)) return kInfinity;
  const SizeField size = SizeField::constant(domain.cells[c].size);
  Context alone;
  smooth(mesh, domain, size, {.slides = false, .raises_beta = false}, alone);
  if (!is_good_grid(mesh, domain, size)) return kInfinity;
  return cell_cost(mesh) / static_cast<double>(mesh.topo().face_count());
}

}  // namespace quadline
