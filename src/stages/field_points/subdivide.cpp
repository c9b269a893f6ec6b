// Points on edges that are too long in the size metric, filtered and inserted, until no edge is too long
// [BorouchakiGeorge1997]. We differ: the size is looked up along the edge instead of interpolated between its ends, so
// that an edge from one small feature to another gets no more points than the field between them asks for; candidates
// are taken in Hilbert order and filtered by the triangulation itself.
#include <algorithm>
#include <cmath>

#include "base/elementary.hpp"
#include "mesh/delaunay.hpp"
#include "search/hilbert.hpp"
#include "stages/field_points/insertion.hpp"

namespace quadline {

namespace {

constexpr double kTooLong = 1.42;  // length in the size metric; the diagonal of a square is not too long
constexpr Spacing kSpacing{0.75, 0.5, false};
constexpr int kMostRounds = 64;  // each round at least halves the longest edge: never reached

// Length in the size metric of an edge of length d where the size runs linearly from ha to hb.
double metric_length(double d, double ha, double hb) {
  const double r = hb / ha;
  return std::fabs(r - 1) < 1e-3 ? d / ha : d * logarithm(r) / (hb - ha);
}

// Places points at equal metric distance along edges.
class Subdivision {
 public:
  explicit Subdivision(const SizeField& size) : size_(size) {}

  void add_points(Point a, Point b, double ha, double hb, std::vector<Point>& points) {
    const double d = distance(a, b);
    if (metric_length(d, ha, hb) <= kTooLong) return;
    const double length = walk(a, (1 / d) * (b - a), d, ha);
    const int n = std::max(2, static_cast<int>(std::lround(length)));
    for (int i = 1; i < n; ++i) {
      const double wanted = length * i / n;
      const std::size_t k = std::min(static_cast<std::size_t>(wanted), marks_.size() - 2);
      const double part =
          (wanted - static_cast<double>(k)) / (k + 2 == marks_.size() ? length - static_cast<double>(k) : 1);
      points.push_back(a + ((marks_[k] + part * (marks_[k + 1] - marks_[k])) / d) * (b - a));
    }
  }

 private:
  // Marks the edge at metric lengths 0, 1, 2, ... and at its end; returns its metric length.
  double walk(Point a, Point direction, double d, double ha) {
    marks_.assign(1, 0);
    double at = 0, h = ha;
    for (;;) {
      h = size_.at(a + std::fmin(d, at + 0.5 * h) * direction);
      if (at + h >= d) break;
      at += h;
      marks_.push_back(at);
    }
    const double length = static_cast<double>(marks_.size() - 1) + (d - at) / h;
    marks_.push_back(d);
    return length;
  }

  const SizeField& size_;
  std::vector<double> marks_;
};

}  // namespace

void subdivide_edges(WorkMesh& mesh, const SizeField& size, double done, Context& context) {
  const Topology& topo = mesh.topo();
  Insertion insertion(mesh, size);
  Subdivision subdivision(size);
  IdVector<NodeId, double> h;
  std::vector<Point> candidates;
  for (int round = 0; round < kMostRounds; ++round) {
    for (std::size_t i = h.count(); i < topo.node_capacity(); ++i) h.push_back(size.at(mesh.point(NodeId(i))));
    candidates.clear();
    FaceId near;
    for (const EdgeId e : topo.edges()) {
      if (mesh.is_constraint(e) || mesh.is_outside(half_of(e))) continue;
      const NodeId a = topo.tail(half_of(e)), b = topo.head(half_of(e));
      subdivision.add_points(mesh.point(a), mesh.point(b), h[a], h[b], candidates);
      if (!near.valid()) near = topo.face(half_of(e));
    }
    std::size_t inserted = 0, seen = 0;
    for (const std::uint32_t i : hilbert_order(candidates)) {
      near = locate(mesh, candidates[i], near);
      const NodeId v = insertion.try_insert(candidates[i], near, kSpacing, {});
      if (v.valid()) {
        near = topo.face(topo.out(v));
        ++inserted;
      }
      if (++seen % 4096 == 0) context.progress("field points", done + (1 - done) * 0.1 * std::min(round, 9));
    }
    if (inserted == 0) return;
  }
}

}  // namespace quadline
