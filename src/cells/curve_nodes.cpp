#include "cells/curve_nodes.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "stages/discretize/discretize.hpp"
#include "stages/halve/halve.hpp"

namespace quadline {

CurveNodes::CurveNodes(const Domain& domain, const SizeField& size, const CellSet& halved, Context& context)
    : domain_(domain), halved_(halved) {
  all_.nodes = discretize(domain, size, halved, context);
  if (!halved.empty()) {
    before_halving_.nodes = all_.nodes;
    sort_by_cells(before_halving_);
    halve_segments(all_.nodes, domain, curves_round(domain, halved));
  }
  sort_by_cells(all_);
}

void CurveNodes::sort_by_cells(Layout& layout) const {
  layout.of_cell = IdVector<CellId, std::vector<std::uint32_t>>(domain_.cells.count());
  for (std::size_t i = 0; i < layout.nodes.segments.size(); ++i) {
    const Domain::Curve& curve = domain_.curves[layout.nodes.segments[i].curve];
    if (curve.left.valid()) layout.of_cell[curve.left].push_back(static_cast<std::uint32_t>(i));
    if (curve.right.valid() && curve.right != curve.left)
      layout.of_cell[curve.right].push_back(static_cast<std::uint32_t>(i));
  }
}

WorkMesh CurveNodes::of(CellId c) const {
  const Layout& layout = halved_.contains(c) ? before_halving_ : all_;
  const WorkMesh& nodes = layout.nodes;
  std::vector<NodeId> used;
  for (const std::uint32_t i : layout.of_cell[c]) {
    used.push_back(nodes.segments[i].a);
    used.push_back(nodes.segments[i].b);
  }
  for (const VertexId v : domain_.cells[c].lone_points) used.push_back(NodeId(v.value));
  std::sort(used.begin(), used.end());
  used.erase(std::unique(used.begin(), used.end()), used.end());
  WorkMesh part;
  for (const NodeId v : used) part.add_node(nodes.point(v), nodes.tag(v));
  const auto number = [&](NodeId v) { return NodeId(std::lower_bound(used.begin(), used.end(), v) - used.begin()); };
  for (const std::uint32_t i : layout.of_cell[c]) {
    const Segment& s = nodes.segments[i];
    part.segments.push_back({number(s.a), number(s.b), s.curve});
  }
  return part;
}

double CurveNodes::least_quads() const {
  double sum = 0;
  for (const auto& segments : all_.of_cell) sum += std::max(1.0, 0.5 * (static_cast<double>(segments.size()) - 2));
  return sum;
}

}  // namespace quadline
