#include "cells/symmetric_nodes.hpp"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>

#include "base/csr.hpp"

namespace quadline {

namespace {

constexpr std::size_t kLeastEdges = 4;  // round a cell
constexpr Point kAside{1, 0.3};         // along none of the axes

using Places = std::vector<double>;  // arc lengths of the nodes inside a curve

Places reversed(const Places& places, double length) {
  Places back;
  for (auto s = places.rbegin(); s != places.rend(); ++s) back.push_back(length - *s);
  return back;
}

// The same nodes and one more, each of them moved a little.
Places with_one_more(const Places& places, double length) {
  const std::size_t n = places.size() + 1;  // edges
  const auto at = [&](std::size_t i) { return i == 0 ? 0 : i == n ? length : places[i - 1]; };
  Places more;
  for (std::size_t k = 1; k <= n; ++k) {
    const std::size_t i = k * n / (n + 1);
    const double share = static_cast<double>(k * n - i * (n + 1)) / static_cast<double>(n + 1);
    more.push_back(at(i) + share * (at(i + 1) - at(i)));
  }
  return more;
}

class Symmetrizer {
 public:
  Symmetrizer(const WorkMesh& nodes, const Domain& domain, const std::vector<Symmetry>& symmetries,
              const IdVector<CurveId, bool>& is_halved)
      : nodes_(nodes),
        domain_(domain),
        symmetries_(symmetries),
        is_halved_(is_halved),
        given_(domain.curves.count()),
        is_crossed_(domain.curves.count(), false),
        must_be_even_(domain.curves.count(), false) {
    for (const Segment& s : nodes.segments())
      if (const NodeTag& tag = nodes.tag(s.a); tag.curve.valid()) given_[s.curve].push_back(tag.s);
    for (const Symmetry& symmetry : symmetries)
      for (std::size_t i = 0; i < given_.count(); ++i) {
        const DirectedCurve image = symmetry.curves[CurveId(i)];
        if (image.curve == CurveId(i) && image.reversed) is_crossed_[CurveId(i)] = true;
      }
    for (std::size_t i = 0; i < given_.count(); ++i) sources_.push_back(source(CurveId(i)));
    crossed_.fill(domain.cells.count(), [&](const auto& visit) {
      for (std::size_t i = 0; i < given_.count(); ++i)
        if (is_crossed_[CurveId(i)])
          for (const CellId c : {domain.curves[CurveId(i)].left, domain.curves[CurveId(i)].right})
            if (c.valid()) visit(c.value, CurveId(i));
    });
  }

  // Nothing where cells stay odd.
  std::optional<WorkMesh> run() {
    for (;;) {
      place_all();
      std::vector<CellId> odd = odd_cells();
      if (odd.empty()) return mesh();
      if (!make_even(std::move(odd))) return std::nullopt;
    }
  }

 private:
  // The curve of its orbit that lies farthest aside, and how its direction lies to that.
  DirectedCurve source(CurveId c) const {
    const Point centre = midpoint(domain_.box.lo, domain_.box.hi);
    const auto aside = [&](CurveId curve) {
      const CurvePiece& piece = domain_.curves[curve].piece;
      return dot(kAside, point_at(piece, 0.5 * length(piece)) - centre);
    };
    const double slack = 4 * domain_.tolerance;
    DirectedCurve best{c, false};
    double farthest = aside(c);
    for (const Symmetry& symmetry : symmetries_) {
      const DirectedCurve image = symmetry.curves[c];
      const double far = aside(image.curve);
      if (far < farthest - slack || (far < farthest + slack && image.curve >= best.curve)) continue;
      farthest = far;
      best = image;
    }
    return best;
  }

  void place_all() {
    places_ = given_;
    for (std::size_t i = 0; i < places_.count(); ++i)
      if (const CurveId c(i); is_crossed_[c]) center(c);
    IdVector<CurveId, Places> own = places_;
    for (std::size_t i = 0; i < places_.count(); ++i) {
      const DirectedCurve from = sources_[CurveId(i)];
      if (from.curve == CurveId(i)) continue;
      const double whole = length(domain_.curves[CurveId(i)].piece);
      const double scale = whole / length(domain_.curves[from.curve].piece);
      Places places = own[from.curve];
      for (double& s : places) s *= scale;
      places_[CurveId(i)] = from.reversed ? reversed(places, whole) : std::move(places);
    }
  }

  // Symmetric about the middle of the curve.
  void center(CurveId c) {
    const double whole = length(domain_.curves[c].piece);
    if (must_be_even_[c] && places_[c].size() % 2 == 0) places_[c] = with_one_more(places_[c], whole);
    const Places back = reversed(places_[c], whole);
    for (std::size_t k = 0; k < back.size(); ++k) places_[c][k] = 0.5 * (places_[c][k] + back[k]);
  }

  std::vector<CellId> odd_cells() const {
    std::vector<CellId> odd;
    for (std::size_t i = 0; i < domain_.cells.count(); ++i) {
      std::size_t edges = 0;
      for (const std::vector<DirectedCurve>& walk : domain_.cells[CellId(i)].walks)
        for (const DirectedCurve& d : walk) edges += (places_[d.curve].size() + 1) * (is_halved_[d.curve] ? 2 : 1);
      if (edges % 2 == 1 || edges < kLeastEdges) odd.emplace_back(i);
    }
    return odd;
  }

  // All curves that axes cross on the way from these cells on, but for those whose numbers are given; false: they are
  // even already. Sources are curves of their own, whose images follow.
  bool make_even(std::vector<CellId> cells) {
    bool is_new = false;
    while (!cells.empty()) {
      const CellId cell = cells.back();
      cells.pop_back();
      for (const CurveId c : crossed_[cell.value]) {
        if (must_be_even_[c] || domain_.curves[c].edges > 0) continue;
        must_be_even_[c] = is_new = true;
        for (const CellId beside : {domain_.curves[c].left, domain_.curves[c].right})
          if (beside.valid()) cells.push_back(beside);
      }
    }
    return is_new;
  }

  WorkMesh mesh() const {
    WorkMesh mesh;
    for (std::size_t i = 0; i < domain_.vertices.count(); ++i)
      mesh.add_node(nodes_.point(NodeId(i)), nodes_.tag(NodeId(i)));
    for (std::size_t i = 0; i < places_.count(); ++i) {
      const CurveId c(i);
      NodeId last(domain_.curves[c].tail.value);
      for (const double s : places_[c]) {
        const NodeId v = mesh.add_node(point_at(domain_.curves[c].piece, s), {NodeKind::OnCurve, c, s, VertexId()});
        mesh.add_segment({last, v, c});
        last = v;
      }
      mesh.add_segment({last, NodeId(domain_.curves[c].head.value), c});
    }
    return mesh;
  }

  const WorkMesh& nodes_;
  const Domain& domain_;
  const std::vector<Symmetry>& symmetries_;
  const IdVector<CurveId, bool>& is_halved_;
  IdVector<CurveId, Places> given_, places_;
  IdVector<CurveId, DirectedCurve> sources_;
  IdVector<CurveId, bool> is_crossed_;  // in the middle, by an axis
  IdVector<CurveId, bool> must_be_even_;
  Rows<CurveId> crossed_;  // of every cell
};

}  // namespace

WorkMesh symmetric_nodes(WorkMesh nodes, const Domain& domain, const std::vector<Symmetry>& symmetries,
                         const IdVector<CurveId, bool>& is_halved) {
  if (symmetries.empty()) return nodes;
  std::optional<WorkMesh> made = Symmetrizer(nodes, domain, symmetries, is_halved).run();
  return made ? std::move(*made) : std::move(nodes);
}

}  // namespace quadline
