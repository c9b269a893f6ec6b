#include "stages/grid/quad_maker.hpp"

#include <algorithm>
#include <utility>

namespace quadline {

namespace {

constexpr double kBetter = 1 - 1e-6;  // of a misfit: rounding decides nothing
constexpr int kMostSteps = 32;        // round a hole: of the longest slots the direction is that many off

}  // namespace

QuadMaker::QuadMaker(const WorkMesh& mesh) {
  for (const NodeId v : mesh.topo().nodes()) {
    points_.push_back(mesh.point(v));
    tags_.push_back(mesh.tag(v));
  }
}

NodeId QuadMaker::add_node(Point p) {
  points_.push_back(p);
  tags_.emplace_back();
  return NodeId(points_.size() - 1);
}

void QuadMaker::add_rings(const std::vector<NodeId>& circle, const std::vector<NodeId>& rim, int rings) {
  std::vector<NodeId> inner = circle;
  for (int ring = 1; ring <= rings; ++ring) {
    const double share = static_cast<double>(ring) / rings;
    std::vector<NodeId> outer = rim;
    if (ring < rings)
      for (std::size_t n = 0; n < rim.size(); ++n)
        outer[n] = add_node(point(circle[n]) + share * (point(rim[n]) - point(circle[n])));
    for (std::size_t n = 0; n < rim.size(); ++n) {
      const std::size_t next = (n + 1) % rim.size();
      add_quad(inner[n], outer[n], outer[next], inner[next]);
    }
    inner = std::move(outer);
  }
}

void QuadMaker::build(WorkMesh& mesh, CellId c) {
  mesh.build(std::move(points_), std::move(tags_), quads_);
  for (std::size_t f = 0; f < quads_.size(); ++f) mesh.set_cell(FaceId(f), c);
  for (const Segment& s : mesh.segments()) mesh.set_curve(edge_of(mesh.topo().find(s.a, s.b)), s.curve);
}

std::vector<NodeId> QuadMaker::circle_of(const NodeWalk& hole, Point centre, const std::vector<NodeId>& rim) const {
  std::vector<NodeId> circle;
  for (const WalkNode& w : hole.nodes) circle.push_back(w.node);
  std::reverse(circle.begin(), circle.end());
  const auto seen = [&](NodeId v) {  // from the centre
    const Point way = point(v) - centre;
    return (1 / norm(way)) * way;
  };
  const Point towards = seen(rim[0]);
  const auto is_less = [&](NodeId a, NodeId b) { return dot(seen(a), towards) < dot(seen(b), towards); };
  auto first = static_cast<std::size_t>(std::max_element(circle.begin(), circle.end(), is_less) - circle.begin());
  for (const std::size_t step : {std::size_t{1}, circle.size() - 1}) first = best_from(first, step, circle, rim);
  std::rotate(circle.begin(), circle.begin() + static_cast<std::ptrdiff_t>(first), circle.end());
  return circle;
}

std::size_t QuadMaker::best_from(std::size_t first, std::size_t step, const std::vector<NodeId>& circle,
                                 const std::vector<NodeId>& rim) const {
  const std::size_t n = circle.size();
  const auto misfit = [&](std::size_t at) {
    double sum = 0;
    for (std::size_t k = 0; k < n; ++k) sum += norm2(point(rim[k]) - point(circle[(at + k) % n]));
    return sum;
  };
  double least = misfit(first);
  for (int k = 0; k < kMostSteps; ++k) {
    const double next = misfit((first + step) % n);
    if (next >= kBetter * least) break;
    first = (first + step) % n;
    least = next;
  }
  return first;
}

}  // namespace quadline
