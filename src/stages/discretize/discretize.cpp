#include "stages/discretize/discretize.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "base/constants.hpp"
#include "stages/discretize/arc_chains.hpp"
#include "stages/discretize/chords.hpp"
#include "stages/discretize/intervals.hpp"
#include "stages/discretize/metric_length.hpp"

namespace quadline {
namespace {

// Growth of sizes along arcs, on which consecutive chords then differ by 13 % at most: the eye sees more there than
// elsewhere.
constexpr double kArcSlope = 0.1;

/// Arc lengths of the nodes that cut a curve into n equal edges.
std::vector<double> even_places(double whole, std::uint32_t n) {
  std::vector<double> places;
  for (std::uint32_t i = 1; i < n; ++i) places.push_back(whole * i / n);
  return places;
}

class Discretizer {
 public:
  Discretizer(const Domain& domain, const SizeField& size, const IdVector<CurveId, std::uint32_t>& wished,
              const CellSet& halved)
      : domain_(domain), size_(size), wished_(wished), chains_(arc_chains(domain)) {
    uses_.assign(domain.curves.count(), EdgeUse::Whole);
    for (const CurveId c : curves_round(domain, halved)) uses_[c] = EdgeUse::Halved;
    for (std::size_t i = 0; i < domain.cells.count(); ++i) all_halved_ &= halved.contains(CellId(i));
  }

  void choose_places() {
    metrics_.reserve(domain_.curves.count());
    for (const Domain::Curve& c : domain_.curves) metrics_.push_back(MetricLength(c.piece, size_));
    grade_arcs();
    IdVector<CurveId, double> lengths;
    lengths.reserve(domain_.curves.count());
    for (const MetricLength& metric : metrics_) lengths.push_back(metric.total());
    twins_ = circle_twins(domain_, chains_, lengths);
    IdVector<CurveId, CountTarget> targets;
    targets.reserve(domain_.curves.count());
    for (std::size_t i = 0; i < domain_.curves.count(); ++i) targets.push_back(target(CurveId(i), lengths[CurveId(i)]));
    counts_ = choose_counts(domain_, std::move(targets));
    for (std::size_t i = 0; i < counts_.count(); ++i) counts_[CurveId(i)] /= nodes_apart(CurveId(i));
    places_.assign(counts_.count(), {});
    lines_.assign(counts_.count(), {});
    place_all();
  }

  /// Chords leave their arcs, and so may cross what the arcs do not. An even number of edges more keeps cells even.
  void refine_arcs() {
    constexpr int kMaxRounds = 16;
    for (int round = 0; round < kMaxRounds; ++round) {
      std::vector<CurveId> coarse = too_coarse_arcs(domain_, lines_, uses_);
      if (coarse.empty()) return;
      add_twins(coarse);
      for (CurveId c : coarse) counts_[c] += 2 * (counts_[c] / 4 + 1);
      place_all();
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
    if (const std::uint32_t given = domain_.curves[c].edges; given > 0) return given_target(c, given);
    if (all_halved_) return {length / 2, (least + 1) / 2, false, twins_[c]};
    if (!wished_.empty() && wished_[c] > 0 && uses_[c] == EdgeUse::Whole)
      return {static_cast<double>(wished_[c]), std::max(least, wished_[c]), false, twins_[c], true};
    const CountTarget target{length, least, uses_[c] == EdgeUse::Halved, twins_[c]};
    return {length, target.is_even() ? least + least % 2 : least, target.is_halved, target.twin};
  }

  CountTarget given_target(CurveId c, std::uint32_t given) const {
    const std::uint32_t count = all_halved_ ? (given + 1) / 2 : given;
    const CurveId twin = count % 2 == 0 ? twins_[c] : CurveId();
    return {static_cast<double>(count), count, uses_[c] == EdgeUse::Halved && !all_halved_, twin, true};
  }

  void add_twins(std::vector<CurveId>& curves) const {
    for (std::size_t i = curves.size(); i-- > 0;)
      if (const CurveId twin = twins_[curves[i]]; twin.valid()) curves.push_back(twin);
    std::sort(curves.begin(), curves.end());
    curves.erase(std::unique(curves.begin(), curves.end()), curves.end());
  }

  /// Limits the growth of sizes along arcs, and from one to those beyond its ends.
  void grade_arcs() {
    constexpr int kMaxRounds = 4;
    bool falls = true;
    for (int round = 0; round < kMaxRounds && falls; ++round) {
      falls = false;
      for (std::size_t i = 0; i < metrics_.count(); ++i) {
        const CurveId c(i);
        if (!domain_.curves[c].piece.is_arc()) continue;
        const double begin = size_beyond(domain_.curves[c].tail, chains_[c][0]);
        const double end = size_beyond(domain_.curves[c].head, chains_[c][1]);
        falls |= metrics_[c].limit(kArcSlope, begin, end);
      }
    }
  }
  double size_beyond(VertexId v, CurveId beyond) const {
    if (!beyond.valid()) return kInfinity;
    return domain_.curves[beyond].tail == v ? metrics_[beyond].begin_size() : metrics_[beyond].end_size();
  }

  /// Edges of the mesh in the end from one node to the next, against those on other curves.
  std::uint32_t nodes_apart(CurveId c) const { return uses_[c] == EdgeUse::Halved && !all_halved_ ? 2 : 1; }

  /// Edges over what the sizes ask for.
  double density(CurveId c) const { return counts_[c] * nodes_apart(c) / metrics_[c].total(); }

  /// Counts are whole numbers, so densities jump from arc to arc: at a vertex between two they meet at the mean.
  double crowding(CurveId c, CurveId beyond) const {
    return beyond.valid() ? std::clamp(std::sqrt(density(beyond) / density(c)), 0.5, 2.0) : 1;
  }

  void place_all() {
    for (std::size_t i = 0; i < counts_.count(); ++i) {
      const CurveId c(i);
      const CurvePiece& piece = domain_.curves[c].piece;
      places_[c] = is_beside_rings(c)
                       ? even_places(length(piece), counts_[c])
                       : metrics_[c].places(counts_[c], {crowding(c, chains_[c][0]), crowding(c, chains_[c][1])});
      lines_[c].assign(1, piece.a);
      for (double s : places_[c]) lines_[c].push_back(point_at(piece, s));
      lines_[c].push_back(piece.b);
    }
  }

  /// Then its nodes stand on the rays of the other circle's.
  bool is_beside_rings(CurveId c) const {
    const auto has_rings = [&](CellId cell) { return cell.valid() && domain_.cells[cell].rings > 0; };
    return has_rings(domain_.curves[c].left) || has_rings(domain_.curves[c].right);
  }

  const Domain& domain_;
  const SizeField& size_;
  const IdVector<CurveId, std::uint32_t>& wished_;
  const ArcChains chains_;
  IdVector<CurveId, EdgeUse> uses_;
  IdVector<CurveId, MetricLength> metrics_;
  IdVector<CurveId, std::uint32_t> counts_;  ///< edges on each curve as it is placed
  IdVector<CurveId, CurveId> twins_;         ///< see CountTarget
  bool all_halved_ = true;
  IdVector<CurveId, std::vector<double>> places_;  ///< arc lengths of the nodes inside each curve
  Polylines lines_;
};

}  // namespace

WorkMesh discretize(const Domain& domain, const SizeField& size, const IdVector<CurveId, std::uint32_t>& wished,
                    const CellSet& halved, Context& context) {
  context.progress("discretize", 0);
  Discretizer discretizer(domain, size, wished, halved);
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
