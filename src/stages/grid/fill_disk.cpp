#include "stages/grid/fill_disk.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include "stages/grid/walk_nodes.hpp"

namespace quadline {

namespace {

constexpr double kCorner = 0.62;  // of the radius: from the middle to the corners of the grid

class DiskFiller {
 public:
  DiskFiller(WorkMesh& mesh, const NodeWalk& walk, Point center)
      : mesh_(mesh), side_(walk.nodes.size() / 4), center_(center) {
    for (const NodeId v : mesh.topo().nodes()) {
      points_.push_back(mesh.point(v));
      tags_.push_back(mesh.tag(v));
    }
    for (const WalkNode& w : walk.nodes) circle_.push_back(w.node);
  }

  void run(CellId c, int rings) {
    add_grid();
    add_rings(rings);
    mesh_.build(std::move(points_), std::move(tags_), quads_);
    for (std::size_t f = 0; f < quads_.size(); ++f) mesh_.set_cell(FaceId(f), c);
    for (const Segment& s : mesh_.segments()) mesh_.set_curve(edge_of(mesh_.topo().find(s.a, s.b)), s.curve);
  }

 private:
  NodeId add_node(Point p) {
    points_.push_back(p);
    tags_.emplace_back();
    return NodeId(points_.size() - 1);
  }
  Point point(NodeId v) const { return points_[v.value]; }
  Point corner(std::size_t k) const { return center_ + kCorner * (point(circle_[k * side_]) - center_); }

  void add_grid() {
    const double n = static_cast<double>(side_);
    for (std::size_t j = 0; j <= side_; ++j)
      for (std::size_t i = 0; i <= side_; ++i) {
        const double u = static_cast<double>(i) / n, v = static_cast<double>(j) / n;
        grid_.push_back(
            add_node((1 - v) * ((1 - u) * corner(0) + u * corner(1)) + v * ((1 - u) * corner(3) + u * corner(2))));
      }
    for (std::size_t j = 0; j < side_; ++j)
      for (std::size_t i = 0; i < side_; ++i)
        quads_.emplace_back(grid(i, j), grid(i + 1, j), grid(i + 1, j + 1), grid(i, j + 1));
  }
  NodeId grid(std::size_t i, std::size_t j) const { return grid_[j * (side_ + 1) + i]; }

  // Opposite to the nodes of the circle.
  std::vector<NodeId> rim_of_grid() const {
    std::vector<NodeId> rim;
    for (std::size_t k = 0; k < side_; ++k) rim.push_back(grid(k, 0));
    for (std::size_t k = 0; k < side_; ++k) rim.push_back(grid(side_, k));
    for (std::size_t k = 0; k < side_; ++k) rim.push_back(grid(side_ - k, side_));
    for (std::size_t k = 0; k < side_; ++k) rim.push_back(grid(0, side_ - k));
    return rim;
  }

  void add_rings(int n_rings) {
    const std::vector<NodeId> rim = rim_of_grid();
    std::vector<NodeId> inner = rim;
    for (int ring = 1; ring <= n_rings; ++ring) {
      const double share = static_cast<double>(ring) / n_rings;
      std::vector<NodeId> outer = circle_;
      if (ring < n_rings)
        for (std::size_t n = 0; n < rim.size(); ++n)
          outer[n] = add_node(point(rim[n]) + share * (point(circle_[n]) - point(rim[n])));
      for (std::size_t n = 0; n < rim.size(); ++n) {
        const std::size_t next = (n + 1) % rim.size();
        quads_.emplace_back(inner[n], outer[n], outer[next], inner[next]);
      }
      inner = std::move(outer);
    }
  }

  WorkMesh& mesh_;
  std::size_t side_;  // edges on a side of the grid
  Point center_;
  std::vector<Point> points_;
  std::vector<NodeTag> tags_;
  std::vector<NodeId> circle_, grid_;  // counter-clockwise; row after row
  std::vector<Polygon> quads_;
};

}  // namespace

bool fill_disk(WorkMesh& mesh, const Domain& domain, CellId c, int rings) {
  const std::vector<NodeWalk> walks = walks_of(mesh, domain, c);
  if (walks.size() != 1 || walks[0].nodes.size() % 4 != 0) return false;
  DiskFiller(mesh, walks[0], domain.curves[domain.cells[c].walks[0][0].curve].piece.center).run(c, rings);
  return true;
}

}  // namespace quadline
