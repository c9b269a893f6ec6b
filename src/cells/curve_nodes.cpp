#include "cells/curve_nodes.hpp"

#include <algorithm>
#include <cstddef>
#include <vector>

#include "cells/symmetric_nodes.hpp"
#include "stages/discretize/discretize.hpp"
#include "stages/halve/halve.hpp"

namespace quadline {

namespace {

// Where all cells are halved the counts are those before, and even.
IdVector<CurveId, bool> counted_twice(const Domain& domain, const CellSet& halved) {
  IdVector<CurveId, bool> is_twice(domain.curves.count(), false);
  const std::vector<CurveId> curves = curves_round(domain, halved);
  if (curves.size() < is_twice.count())
    for (const CurveId c : curves) is_twice[c] = true;
  return is_twice;
}

}  // namespace

CurveNodes::CurveNodes(const Domain& domain, const SizeField& size, const IdVector<CurveId, std::uint32_t>& wished,
                       const std::vector<Symmetry>& symmetries, const CellSet& halved, Context& context)
    : domain_(domain), halved_(halved) {
  all_.nodes = symmetric_nodes(discretize(domain, size, wished, halved, context), domain, symmetries,
                               counted_twice(domain, halved));
  if (!halved.empty()) {
    before_halving_.nodes = all_.nodes;
    sort_by_cells(before_halving_);
    halve_segments(all_.nodes, domain, curves_round(domain, halved));
  }
  sort_by_cells(all_);
  on_curve_.fill(domain.curves.count(), [&](const auto& visit) {
    for (const Segment& s : all_.nodes.segments())
      if (all_.nodes.tag(s.a).curve.valid()) visit(s.curve.value, s.a);
  });
}

void CurveNodes::sort_by_cells(Layout& layout) const {
  const std::vector<Segment>& segments = layout.nodes.segments();
  layout.of_cell.fill(domain_.cells.count(), [&](const auto& visit) {
    for (std::uint32_t i = 0; i < segments.size(); ++i) {
      const Domain::Curve& curve = domain_.curves[segments[i].curve];
      if (curve.left.valid()) visit(curve.left.value, i);
      if (curve.right.valid() && curve.right != curve.left) visit(curve.right.value, i);
    }
  });
}

WorkMesh CurveNodes::of(CellId c) const {
  const Layout& layout = halved_.contains(c) ? before_halving_ : all_;
  const WorkMesh& nodes = layout.nodes;
  std::vector<NodeId> used;
  for (const std::uint32_t i : layout.of_cell[c.value]) {
    used.push_back(nodes.segments()[i].a);
    used.push_back(nodes.segments()[i].b);
  }
  for (const VertexId v : domain_.cells[c].lone_points) used.push_back(NodeId(v.value));
  std::sort(used.begin(), used.end());
  used.erase(std::unique(used.begin(), used.end()), used.end());
  WorkMesh part;
  for (const NodeId v : used) part.add_node(nodes.point(v), nodes.tag(v));
  const auto number = [&](NodeId v) { return NodeId(std::lower_bound(used.begin(), used.end(), v) - used.begin()); };
  for (const std::uint32_t i : layout.of_cell[c.value]) {
    const Segment& s = nodes.segments()[i];
    part.add_segment({number(s.a), number(s.b), s.curve});
  }
  return part;
}

double CurveNodes::least_quads() const {
  double sum = 0;
  for (std::size_t i = 0; i < all_.of_cell.count(); ++i)
    sum += std::max(1.0, 0.5 * (static_cast<double>(count(CellId(i))) - 2));
  return sum;
}

}  // namespace quadline
