#include "stages/discretize/discretize.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "stages/discretize/chords.hpp"
#include "stages/discretize/circle_twins.hpp"
#include "stages/discretize/intervals.hpp"
#include "stages/discretize/metric_length.hpp"

namespace quadline {
namespace {

class Discretizer {
 public:
  Discretizer(const Domain& domain, const SizeField& size, const CellSet& halved) : domain_(domain), size_(size) {
    uses_.assign(domain.curves.count(), EdgeUse::Whole);
    for (const CurveId c : curves_round(domain, halved)) uses_[c] = EdgeUse::Halved;
    for (std::size_t i = 0; i < domain.cells.count(); ++i) all_halved_ &= halved.contains(CellId(i));
  }

  void choose_places() {
    IdVector<CurveId, double> lengths;
    lengths.reserve(domain_.curves.count());
    for (const Domain::Curve& c : domain_.curves) lengths.push_back(MetricLength(c.piece, size_).total());
    twins_ = circle_twins(domain_, lengths);
    IdVector<CurveId, CountTarget> targets;
    targets.reserve(domain_.curves.count());
    for (std::size_t i = 0; i < domain_.curves.count(); ++i) targets.push_back(target(CurveId(i), lengths[CurveId(i)]));
    const IdVector<CurveId, std::uint32_t> counts = choose_counts(domain_, std::move(targets));
    places_.assign(counts.count(), {});
    lines_.assign(counts.count(), {});
    for (std::size_t i = 0; i < counts.count(); ++i) {
      const CurveId c(i);
      place(c, uses_[c] == EdgeUse::Halved && !all_halved_ ? counts[c] / 2 : counts[c]);
    }
  }

  /// Chords leave their arcs, and so may cross what the arcs do not. An even number of edges more keeps cells even.
  void refine_arcs() {
    constexpr int kMaxRounds = 16;
    for (int round = 0; round < kMaxRounds; ++round) {
      std::vector<CurveId> coarse = too_coarse_arcs(domain_, lines_, uses_);
      if (coarse.empty()) return;
      add_twins(coarse);
      for (CurveId c : coarse) {
        const auto count = static_cast<std::uint32_t>(places_[c].size() + 1);
        place(c, count + 2 * (count / 4 + 1));
      }
    }
  }

  WorkMesh mesh() const {
    WorkMesh mesh;
    for (std::size_t i = 0; i < domain_.vertices.count(); ++i)
      mesh.add_node(domain_.vertices[VertexId(i)].at, {NodeKind::Fixed, CurveId(), 0, VertexId(i)});
    for (std::size_t i = 0; i < domain_.curves.count(); ++i) {
      const CurveId c(i);
      NodeId last(domain_.curves[c].tail.value);
      for (std::size_t k = 0; k < places_[c].size(); ++k) {
        const NodeId v = mesh.add_node(lines_[c][k + 1], {NodeKind::OnCurve, c, places_[c][k], VertexId()});
        mesh.add_segment({last, v, c});
        last = v;
      }
      mesh.add_segment({last, NodeId(domain_.curves[c].head.value), c});
    }
    return mesh;
  }

 private:
  /// Where all edges will be halved, the counts are those before: even round every cell, as pairs of triangles want.
  /// Else they are those of the mesh in the end.
  CountTarget target(CurveId c, double length) const {
    const std::uint32_t least = size_.least_edges(c);
    if (all_halved_) return {length / 2, (least + 1) / 2, false, twins_[c]};
    const CountTarget target{length, least, uses_[c] == EdgeUse::Halved, twins_[c]};
    return {length, target.is_even() ? least + least % 2 : least, target.is_halved, target.twin};
  }

  void add_twins(std::vector<CurveId>& curves) const {
    for (std::size_t i = curves.size(); i-- > 0;)
      if (const CurveId twin = twins_[curves[i]]; twin.valid()) curves.push_back(twin);
    std::sort(curves.begin(), curves.end());
    curves.erase(std::unique(curves.begin(), curves.end()), curves.end());
  }

  void place(CurveId c, std::uint32_t count) {
    const CurvePiece& piece = domain_.curves[c].piece;
    places_[c] = MetricLength(piece, size_).places(count);
    lines_[c].assign(1, piece.a);
    for (double s : places_[c]) lines_[c].push_back(point_at(piece, s));
    lines_[c].push_back(piece.b);
  }

  const Domain& domain_;
  const SizeField& size_;
  IdVector<CurveId, EdgeUse> uses_;
  IdVector<CurveId, CurveId> twins_;  ///< see CountTarget
  bool all_halved_ = true;
  IdVector<CurveId, std::vector<double>> places_;  ///< arc lengths of the nodes inside each curve
  Polylines lines_;
};

}  // namespace

WorkMesh discretize(const Domain& domain, const SizeField& size, const CellSet& halved, Context& context) {
  context.progress("discretize", 0);
  Discretizer discretizer(domain, size, halved);
  discretizer.choose_places();
  context.progress("discretize", 0.5);
  discretizer.refine_arcs();
  WorkMesh mesh = discretizer.mesh();
  context.progress("discretize", 1);
  return mesh;
}

std::vector<CurveId> curves_round(const Domain& domain, const CellSet& cells) {
  std::vector<CurveId> curves;
  for (std::size_t i = 0; i < domain.curves.count(); ++i) {
    const Domain::Curve& c = domain.curves[CurveId(i)];
    if ((c.left.valid() && cells.contains(c.left)) || (c.right.valid() && cells.contains(c.right)))
      curves.emplace_back(i);
  }
  return curves;
}

}  // namespace quadline
