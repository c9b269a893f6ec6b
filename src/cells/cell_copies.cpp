#include "cells/cell_copies.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <span>

#include "cells/match_cells.hpp"

namespace quadline {

namespace {

template <class From, class To>
const To& image(const std::vector<std::pair<From, To>>& sorted, From from) {
  return std::lower_bound(sorted.begin(), sorted.end(), from, [](const auto& e, From key) { return e.first < key; })
      ->second;
}

// What a symmetry makes of a cell.
CellCopy image_of(const Domain& domain, CellId c, const Symmetry& symmetry) {
  CellCopy copy{c, symmetry.cells[c], symmetry.move, {}, {}};
  for_each_curve(domain.cells[c],
                 [&](DirectedCurve d) { copy.curves.emplace_back(d.curve, symmetry.curves[d.curve]); });
  for (const auto& [from, to] : copy.curves)
    for (const VertexId v : {domain.curves[from].tail, domain.curves[from].head})
      copy.vertices.emplace_back(v, symmetry.vertices[v]);
  for (const VertexId v : domain.cells[c].lone_points) copy.vertices.emplace_back(v, symmetry.vertices[v]);
  sort_maps(copy);
  return copy;
}

class CopyFinder {
 public:
  CopyFinder(const Domain& domain, const std::vector<Symmetry>& symmetries, const CurveNodes& nodes,
             const SizeField& size, const std::function<bool(CellId, CellId)>& is_alike)
      : domain_(domain), symmetries_(symmetries), matcher_(domain, nodes, size), nodes_(nodes), is_alike_(is_alike) {}

  std::vector<CellCopy> run() {
    std::vector<CellCopy> in_orbits, congruent;
    for (std::size_t i = 0; i < domain_.cells.count(); ++i) {
      if (auto copy = from_orbit(CellId(i))) {
        in_orbits.push_back(std::move(*copy));
      } else if (auto twin = from_congruent(CellId(i))) {
        congruent.push_back(std::move(*twin));
      }
    }
    congruent.insert(congruent.end(), in_orbits.begin(), in_orbits.end());
    return congruent;
  }

 private:
  // The first cell of an orbit is the original of all.
  std::optional<CellCopy> from_orbit(CellId c) const {
    CellId first = c;
    for (const Symmetry& symmetry : symmetries_) first = std::min(first, symmetry.cells[c]);
    if (first == c || !is_alike_(first, c)) return std::nullopt;
    for (const Symmetry& symmetry : symmetries_) {
      if (symmetry.cells[first] != c) continue;
      CellCopy copy = image_of(domain_, first, symmetry);
      if (matcher_.fits(copy)) return copy;
    }
    return std::nullopt;
  }

  // Few cells of one kind are no copies of each other: to look at some of them is enough.
  std::optional<CellCopy> from_congruent(CellId c) {
    constexpr std::size_t kMostOriginals = 32;
    std::vector<CellId>& originals = originals_[kind_of(domain_, nodes_, c)];
    for (const CellId original : originals) {
      if (!is_alike_(original, c)) continue;
      if (auto copy = matcher_.find(original, c)) return copy;
    }
    if (originals.size() < kMostOriginals) originals.push_back(c);
    return std::nullopt;
  }

  const Domain& domain_;
  const std::vector<Symmetry>& symmetries_;
  const CellMatcher matcher_;
  const CurveNodes& nodes_;
  const std::function<bool(CellId, CellId)>& is_alike_;
  std::map<std::vector<std::uint32_t>, std::vector<CellId>> originals_;  // of each kind
};

// Places the nodes of a copy.
class Copier {
 public:
  Copier(const CellCopy& copy, const CurveNodes& nodes) : copy_(copy), nodes_(nodes) {}

  // The node on the curves that the tag's node becomes. The nodes of a curve are sorted by their places.
  NodeId node(const NodeTag& tag) const {
    if (tag.vertex.valid()) return NodeId(image(copy_.vertices, tag.vertex).value);
    const DirectedCurve to = image(copy_.curves, tag.curve);
    const std::span<const NodeId> from = nodes_.on(tag.curve), into = nodes_.on(to.curve);
    const auto found = std::lower_bound(from.begin(), from.end(), tag.s,
                                        [&](NodeId v, double s) { return nodes_.all().tag(v).s < s; });
    const auto k = static_cast<std::size_t>(found - from.begin());
    return into[to.reversed ? into.size() - 1 - k : k];
  }

  WorkMesh run(const WorkMesh& mesh) const {
    std::vector<Point> points;
    std::vector<NodeTag> tags;
    const Topology& topo = mesh.topo();
    IdVector<NodeId, NodeId> number(topo.node_capacity());
    for (const NodeId v : topo.nodes()) {
      number[v] = NodeId(points.size());
      const NodeTag& tag = mesh.tag(v);
      const NodeId on = tag.vertex.valid() || tag.curve.valid() ? node(tag) : NodeId();
      points.push_back(on.valid() ? nodes_.all().point(on) : copy_.move(mesh.point(v)));
      tags.push_back(on.valid() ? nodes_.all().tag(on) : NodeTag{});
    }
    std::vector<Polygon> faces;
    for (const FaceId f : topo.faces()) faces.push_back(face(topo.polygon(f), number));
    WorkMesh made;
    made.build(std::move(points), std::move(tags), faces);
    add_constraints(mesh, number, made);
    std::size_t k = 0;
    for (const FaceId f : topo.faces()) {
      made.set_cell(FaceId(k), mesh.cell(f).valid() ? copy_.copy : CellId());
      if (mesh.is_frozen(f)) made.freeze(FaceId(k));
      ++k;
    }
    return made;
  }

 private:
  Polygon face(Polygon p, const IdVector<NodeId, NodeId>& number) const {
    for (int k = 0; k < p.n; ++k) p.nodes[k] = number[p.nodes[k]];
    if (copy_.move.is_mirrored) std::reverse(p.nodes.begin(), p.nodes.begin() + p.n);
    return p;
  }

  void add_constraints(const WorkMesh& mesh, const IdVector<NodeId, NodeId>& number, WorkMesh& made) const {
    for (Segment s : mesh.segments()) {
      const DirectedCurve to = image(copy_.curves, s.curve);
      s = {number[s.a], number[s.b], to.curve};
      if (to.reversed) std::swap(s.a, s.b);
      if (const HalfId h = made.topo().find(s.a, s.b); h.valid()) made.set_curve(edge_of(h), s.curve);
      made.add_segment(s);
    }
  }

  const CellCopy& copy_;
  const CurveNodes& nodes_;
};

}  // namespace

std::vector<CellCopy> find_copies(const Domain& domain, const std::vector<Symmetry>& symmetries,
                                  const CurveNodes& nodes, const SizeField& size,
                                  const std::function<bool(CellId, CellId)>& is_alike) {
  return CopyFinder(domain, symmetries, nodes, size, is_alike).run();
}

WorkMesh copied(const WorkMesh& mesh, const CellCopy& copy, const CurveNodes& nodes) {
  return Copier(copy, nodes).run(mesh);
}

}  // namespace quadline
