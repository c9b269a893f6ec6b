#include "cells/rehearsal.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "base/constants.hpp"
#include "cells/accept_grid.hpp"
#include "cells/cell_cost.hpp"
#include "domain/size/size_field.hpp"
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

// The proposal in the frame of its grid, in sizes of the cell: the same for cells that are alike.
std::vector<std::int64_t> key_of(const Domain& domain, CellId c, const GridProposal& proposal) {
  constexpr double kPerSize = 1e6;
  const GridPlan& plan = proposal.plan;
  const double per_unit = kPerSize / (plan.frame.is_polar ? 1 : domain.cells[c].size);
  std::vector<std::int64_t> key{plan.is_disk, plan.frame.is_polar, plan.direction, plan.columns, plan.rows};
  const auto add = [&](Point p) {
    const Point at = plan.frame.to_frame(p);
    for (const double x : {at.x, at.y}) key.push_back(static_cast<std::int64_t>(std::floor(per_unit * x + 0.5)));
  };
  key.push_back(static_cast<std::int64_t>(
      std::floor(kPerSize * length(domain.curves[proposal.wishes[0].curve].piece) / domain.cells[c].size)));
  for (const CountWish& wish : proposal.wishes) {
    const CurvePiece& piece = domain.curves[wish.curve].piece;
    key.push_back(wish.count);
    add(piece.a);
    add(point_at(piece, 0.5 * length(piece)));
    add(piece.b);
  }
  for (const GridHole& hole : plan.holes)
    for (const int number : {hole.columns, hole.rows, hole.rings}) key.push_back(number);
  return key;
}

double tried(const Domain& domain, CellId c, const GridProposal& proposal, Context& context) {
  WorkMesh mesh = nodes_of(domain, proposal.wishes);
  if (!fill_grid(mesh, domain, c, proposal.plan)) return kInfinity;
  const SizeField size = SizeField::constant(domain.cells[c].size);
  smooth(mesh, domain, size, {.slides = false, .raises_beta = false}, context);
  if (!is_good_grid(mesh, domain, size)) return kInfinity;
  return cell_cost(mesh) / static_cast<double>(mesh.topo().face_count());
}

}  // namespace

double Rehearsal::cost(const Domain& domain, CellId c, const GridProposal& proposal) {
  const auto [known, is_new] = known_.try_emplace(key_of(domain, c, proposal), kInfinity);
  if (is_new) known->second = tried(domain, c, proposal, quiet_);
  return known->second;
}

}  // namespace quadline
