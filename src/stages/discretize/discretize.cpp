#include "stages/discretize/discretize.hpp"

#include "stages/discretize/intervals.hpp"
#include "stages/discretize/metric_length.hpp"

namespace quadline {
namespace {

IdVector<CurveId, CountWish> wishes_of(const Domain& domain, const SizeField& size) {
  IdVector<CurveId, CountWish> wishes;
  wishes.reserve(domain.curves.count());
  for (std::size_t i = 0; i < domain.curves.count(); ++i) {
    const CurveId id(i);
    wishes.push_back({MetricLength(domain.curves[id].piece, size).total(), size.least_edges(id)});
  }
  return wishes;
}

void place_nodes(const Domain& domain, const SizeField& size, const IdVector<CurveId, std::uint32_t>& counts,
                 WorkMesh& mesh) {
  for (std::size_t i = 0; i < domain.vertices.count(); ++i)
    mesh.add_node(domain.vertices[VertexId(i)].at, {NodeKind::Fixed, CurveId(), 0, VertexId(i)});
  for (std::size_t i = 0; i < domain.curves.count(); ++i) {
    const CurveId id(i);
    const Domain::Curve& curve = domain.curves[id];
    NodeId last(curve.tail.value);
    for (double s : MetricLength(curve.piece, size).places(counts[id])) {
      const NodeId v = mesh.add_node(point_at(curve.piece, s), {NodeKind::OnCurve, id, s, VertexId()});
      mesh.segments.push_back({last, v, id});
      last = v;
    }
    mesh.segments.push_back({last, NodeId(curve.head.value), id});
  }
}

}  // namespace

WorkMesh discretize(const Domain& domain, const SizeField& size, Context& context) {
  context.progress("discretize", 0);
  const IdVector<CurveId, std::uint32_t> counts = choose_counts(domain, wishes_of(domain, size));
  context.progress("discretize", 0.5);
  WorkMesh mesh;
  place_nodes(domain, size, counts, mesh);
  context.progress("discretize", 1);
  return mesh;
}

}  // namespace quadline
