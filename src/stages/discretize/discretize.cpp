#include "stages/discretize/discretize.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

#include "stages/discretize/intervals.hpp"
#include "stages/discretize/metric_length.hpp"

namespace quadline {
namespace {

class Discretizer {
 public:
  Discretizer(const Domain& domain, const SizeField& size) : domain_(domain), size_(size) {}

  void choose_places() {
    IdVector<CurveId, CountWish> wishes;
    wishes.reserve(domain_.curves.count());
    for (std::size_t i = 0; i < domain_.curves.count(); ++i) {
      const CurveId c(i);
      wishes.push_back({MetricLength(domain_.curves[c].piece, size_).total(), size_.least_edges(c)});
    }
    const IdVector<CurveId, std::uint32_t> counts = choose_counts(domain_, std::move(wishes));
    places_.assign(counts.count(), {});
    lines_.assign(counts.count(), {});
    for (std::size_t i = 0; i < counts.count(); ++i) place(CurveId(i), counts[CurveId(i)]);
  }

  /// Chords leave their arcs, and so may cross what the arcs do not. An even number of edges more keeps cells even.
  void refine_arcs(EdgeUse use) {
    constexpr int kMaxRounds = 16;
    for (int round = 0; round < kMaxRounds; ++round) {
      const std::vector<CurveId> coarse = too_coarse_arcs(domain_, lines_, use);
      if (coarse.empty()) return;
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
        mesh.segments.push_back({last, v, c});
        last = v;
      }
      mesh.segments.push_back({last, NodeId(domain_.curves[c].head.value), c});
    }
    return mesh;
  }

 private:
  void place(CurveId c, std::uint32_t count) {
    const CurvePiece& piece = domain_.curves[c].piece;
    places_[c] = MetricLength(piece, size_).places(count);
    lines_[c].assign(1, piece.a);
    for (double s : places_[c]) lines_[c].push_back(point_at(piece, s));
    lines_[c].push_back(piece.b);
  }

  const Domain& domain_;
  const SizeField& size_;
  IdVector<CurveId, std::vector<double>> places_;  ///< arc lengths of the nodes inside each curve
  Polylines lines_;
};

}  // namespace

WorkMesh discretize(const Domain& domain, const SizeField& size, EdgeUse use, Context& context) {
  context.progress("discretize", 0);
  Discretizer discretizer(domain, size);
  discretizer.choose_places();
  context.progress("discretize", 0.5);
  discretizer.refine_arcs(use);
  WorkMesh mesh = discretizer.mesh();
  context.progress("discretize", 1);
  return mesh;
}

}  // namespace quadline
