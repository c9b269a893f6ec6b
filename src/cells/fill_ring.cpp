#include "cells/fill_ring.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace quadline {

namespace {

/// The nodes of a closed walk in order.
/// @param segments  in the order of the curves, those of a curve in its direction.
std::vector<NodeId> nodes_of(const std::vector<DirectedCurve>& walk, const std::vector<Segment>& segments) {
  std::vector<NodeId> nodes;
  for (const DirectedCurve& d : walk) {
    const auto start = static_cast<std::ptrdiff_t>(nodes.size());
    auto s = std::lower_bound(segments.begin(), segments.end(), d.curve,
                              [](const Segment& segment, CurveId c) { return segment.curve < c; });
    for (; s != segments.end() && s->curve == d.curve; ++s) nodes.push_back(d.reversed ? s->b : s->a);
    if (d.reversed) std::reverse(nodes.begin() + start, nodes.end());
  }
  return nodes;
}

}  // namespace

bool fill_ring(WorkMesh& mesh, const Domain& domain, CellId cell) {
  const std::vector<std::vector<DirectedCurve>>& walks = domain.cells[cell].walks;
  if (walks.size() != 2) return false;
  const std::vector<NodeId> outer = nodes_of(walks[0], mesh.segments());
  std::vector<NodeId> inner = nodes_of(walks[1], mesh.segments());
  if (inner.size() != outer.size()) return false;
  std::reverse(inner.begin(), inner.end());  // counter-clockwise like the outer walk
  const auto opposite = std::min_element(inner.begin(), inner.end(), [&](NodeId v, NodeId w) {
    const Point from = mesh.point(outer[0]);
    return norm2(mesh.point(v) - from) < norm2(mesh.point(w) - from);
  });
  std::rotate(inner.begin(), opposite, inner.end());

  const std::size_t n = outer.size();
  std::vector<Polygon> quads;
  for (std::size_t i = 0; i < n; ++i) quads.emplace_back(inner[i], outer[i], outer[(i + 1) % n], inner[(i + 1) % n]);
  std::vector<Point> points;
  std::vector<NodeTag> tags;
  for (std::size_t i = 0; i < mesh.topo().node_capacity(); ++i) {
    points.push_back(mesh.point(NodeId(i)));
    tags.push_back(mesh.tag(NodeId(i)));
  }
  mesh.build(std::move(points), std::move(tags), quads);
  for (const Segment& s : mesh.segments()) mesh.set_curve(edge_of(mesh.topo().find(s.a, s.b)), s.curve);
  for (const FaceId f : mesh.topo().faces()) mesh.set_cell(f, cell);
  for (const FaceId f : mesh.topo().faces()) mesh.freeze(f);
  return true;
}

}  // namespace quadline
