#include "cells/flatten.hpp"

#include <algorithm>

namespace quadline {

namespace {

constexpr NodeIndex kUnused = UINT32_MAX;

// Numbers the nodes that faces inside the domain use, in the order of their ids.
IdVector<NodeId, NodeIndex> number_nodes(const WorkMesh& mesh, Mesh& flat) {
  const Topology& topo = mesh.topo();
  IdVector<NodeId, NodeIndex> index(topo.node_capacity(), kUnused);
  for (const FaceId f : topo.faces()) {
    if (!mesh.cell(f).valid()) continue;
    topo.for_each_half(f, [&](HalfId h) { index[topo.tail(h)] = 0; });
  }
  for (std::size_t i = 0; i < topo.node_capacity(); ++i) {
    const NodeId v(i);
    if (index[v] == kUnused) continue;
    index[v] = static_cast<NodeIndex>(flat.points.size());
    flat.points.push_back(mesh.point(v));
  }
  return index;
}

// The mesh edges of each curve, in its direction from the tail on.
class CurveChains {
 public:
  CurveChains(const WorkMesh& mesh, const Domain& domain) : mesh_(mesh), domain_(domain) {
    node_at_.assign(domain.vertices.count(), NodeId());
    for (const NodeId v : mesh.topo().nodes())
      if (mesh.tag(v).vertex.valid()) node_at_[mesh.tag(v).vertex] = v;
  }

  NodeId node_at(VertexId v) const { return node_at_[v]; }

  std::vector<NodeId> nodes(CurveId c) const {
    const Topology& topo = mesh_.topo();
    std::vector<NodeId> chain;
    const NodeId last = node_at_[domain_.curves[c].head];
    NodeId v = node_at_[domain_.curves[c].tail];
    EdgeId came;
    while (v.valid()) {
      chain.push_back(v);
      if (v == last) return chain;
      HalfId on;
      topo.for_each_out(v, [&](HalfId h) {
        if (mesh_.curve(edge_of(h)) == c && edge_of(h) != came) on = h;
      });
      if (!on.valid()) return {};
      came = edge_of(on);
      v = topo.head(on);
    }
    return {};
  }

 private:
  const WorkMesh& mesh_;
  const Domain& domain_;
  IdVector<VertexId, NodeId> node_at_;
};

}  // namespace

Mesh flatten(const WorkMesh& mesh, const Domain& domain) {
  const Topology& topo = mesh.topo();
  Mesh flat;
  flat.regions = domain.regions;
  const IdVector<NodeId, NodeIndex> index = number_nodes(mesh, flat);
  for (const FaceId f : topo.faces()) {
    if (!mesh.cell(f).valid()) continue;
    const Polygon p = topo.polygon(f);
    const std::uint32_t region = domain.cells[mesh.cell(f)].region;
    if (p.n == 4) {
      flat.quads.push_back({index[p.nodes[0]], index[p.nodes[1]], index[p.nodes[2]], index[p.nodes[3]]});
      flat.quad_region.push_back(region);
    } else {
      flat.triangles.push_back({index[p.nodes[0]], index[p.nodes[1]], index[p.nodes[2]]});
      flat.triangle_region.push_back(region);
    }
  }
  const CurveChains chains(mesh, domain);
  for (const Domain::Path& path : domain.paths) {
    EdgeSet set{path.name, path.kind, {}};
    for (const DirectedCurve& d : path.curves) {
      std::vector<NodeId> nodes = chains.nodes(d.curve);
      if (d.reversed) std::reverse(nodes.begin(), nodes.end());
      for (std::size_t i = 1; i < nodes.size(); ++i) set.edges.push_back({index[nodes[i - 1]], index[nodes[i]]});
    }
    flat.curves.push_back(std::move(set));
  }
  for (const Domain::PointUse& use : domain.points) {
    const NodeId v = chains.node_at(use.vertex);
    if (v.valid()) flat.node_sets.push_back({use.name, {index[v]}});
  }
  return flat;
}

}  // namespace quadline
