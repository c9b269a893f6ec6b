#include "stages/grid/fill_disk.hpp"

#include <cstddef>
#include <vector>

#include "stages/grid/quad_maker.hpp"
#include "stages/grid/walk_nodes.hpp"

namespace quadline {

namespace {

constexpr double kCorner = 0.62;  // of the radius: from the middle to the corners of the grid

class DiskFiller {
 public:
  DiskFiller(QuadMaker& made, const NodeWalk& walk, Point center)
      : made_(made), side_(walk.nodes.size() / 4), center_(center) {
    for (const WalkNode& w : walk.nodes) circle_.push_back(w.node);
  }

  void run(int rings) {
    add_grid();
    // Outwards: the circle is the rim here.
    made_.add_rings(rim_of_grid(), circle_, rings);
  }

 private:
  Point corner(std::size_t k) const { return center_ + kCorner * (made_.point(circle_[k * side_]) - center_); }
  NodeId grid(std::size_t i, std::size_t j) const { return grid_[j * (side_ + 1) + i]; }

  void add_grid() {
    const double n = static_cast<double>(side_);
    for (std::size_t j = 0; j <= side_; ++j)
      for (std::size_t i = 0; i <= side_; ++i) {
        const double u = static_cast<double>(i) / n, v = static_cast<double>(j) / n;
        grid_.push_back(made_.add_node((1 - v) * ((1 - u) * corner(0) + u * corner(1)) +
                                       v * ((1 - u) * corner(3) + u * corner(2))));
      }
    for (std::size_t j = 0; j < side_; ++j)
      for (std::size_t i = 0; i < side_; ++i)
        made_.add_quad(grid(i, j), grid(i + 1, j), grid(i + 1, j + 1), grid(i, j + 1));
  }

  // Opposite to the nodes of the circle.
  std::vector<NodeId> rim_of_grid() const {
    std::vector<NodeId> rim;
    for (std::size_t k = 0; k < side_; ++k) rim.push_back(grid(k, 0));
    for (std::size_t k = 0; k < side_; ++k) rim.push_back(grid(side_, k));
    for (std::size_t k = 0; k < side_; ++k) rim.push_back(grid(side_ - k, side_));
    for (std::size_t k = 0; k < side_; ++k) rim.push_back(grid(0, side_ - k));
    return rim;
  }

  QuadMaker& made_;
  std::size_t side_;  // edges on a side of the grid
  Point center_;
  std::vector<NodeId> circle_, grid_;  // counter-clockwise; row after row
};

}  // namespace

bool fill_disk(WorkMesh& mesh, const Domain& domain, CellId c, int rings) {
  const std::vector<NodeWalk> walks = walks_of(mesh, domain, c);
  if (walks.size() != 1 || walks[0].nodes.size() % 4 != 0) return false;
  QuadMaker made(mesh);
  DiskFiller(made, walks[0], domain.curves[domain.cells[c].walks[0][0].curve].piece.center).run(rings);
  made.build(mesh, c);
  return true;
}

}  // namespace quadline
