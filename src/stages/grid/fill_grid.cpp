#include "stages/grid/fill_grid.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "stages/grid/fill_disk.hpp"
#include "stages/grid/grid_places.hpp"
#include "stages/grid/lattice_points.hpp"
#include "stages/grid/quad_maker.hpp"
#include "stages/grid/walk_nodes.hpp"

namespace quadline {

namespace {

class Filler {
 public:
  Filler(QuadMaker& made, PlacedCell& cell, const std::vector<NodeWalk>& walks)
      : made_(made), cell_(cell), walks_(walks), lattice_(cell.lattice) {}

  void run() {
    add_nodes();
    add_quads();
    for (const auto& [hole, patch] : cell_.holes) {
      const std::vector<NodeId> rim = rim_of(patch);
      made_.add_rings(made_.circle_of(walks_[hole.walk], hole.at, rim), rim, hole.rings);
    }
  }

 private:
  int node_rows() const { return lattice_.is_ring() ? lattice_.rows() - 1 : lattice_.rows(); }

  void add_nodes() {
    LatticePoints places(cell_, made_.points());
    places.interpolate();
    for (int j = 0; j <= node_rows(); ++j)
      for (int i = 0; i <= lattice_.columns(); ++i)
        if (const GridPlace p{i, j}; !lattice_.node(p).valid() && lattice_.is_used(p))
          lattice_.node(p) = made_.add_node(places.at(p));
  }

  void add_quads() {
    for (int j = 0; j < lattice_.rows(); ++j)
      for (int i = 0; i < lattice_.columns(); ++i)
        if (lattice_.is_quad(i, j)) add_quad({i, j}, {i + 1, j}, {i + 1, j + 1}, {i, j + 1});
  }
  void add_quad(GridPlace a, GridPlace b, GridPlace c, GridPlace d) {
    made_.add_quad(lattice_.node(a), lattice_.node(b), lattice_.node(c), lattice_.node(d));
  }

  // The rim of a patch, counter-clockwise from its corner of least i and j.
  std::vector<NodeId> rim_of(const Patch& patch) const {
    std::vector<NodeId> rim;
    const auto [i, j] = patch.corner;
    const int columns = patch.columns, rows = patch.rows;
    for (int n = 0; n < columns; ++n) rim.push_back(lattice_.node({i + n, j}));
    for (int n = 0; n < rows; ++n) rim.push_back(lattice_.node({i + columns, j + n}));
    for (int n = 0; n < columns; ++n) rim.push_back(lattice_.node({i + columns - n, j + rows}));
    for (int n = 0; n < rows; ++n) rim.push_back(lattice_.node({i, j + rows - n}));
    return rim;
  }

  QuadMaker& made_;
  PlacedCell& cell_;
  const std::vector<NodeWalk>& walks_;
  Lattice& lattice_;
};

// The circles of the holes have the nodes that their rings need.
bool holes_fit(const GridPlan& plan, const std::vector<NodeWalk>& walks) {
  return std::all_of(plan.holes.begin(), plan.holes.end(), [&](const GridHole& hole) {
    return walks[hole.walk].turns == 0 &&
           walks[hole.walk].nodes.size() == 2 * static_cast<std::size_t>(hole.columns + hole.rows);
  });
}

// Rows that the model asks for, from circle to circle. False where their nodes do not stand on common rays.
bool fill_rings(QuadMaker& made, const GridPlan& plan, const std::vector<NodeWalk>& walks) {
  constexpr double kOffRay = 1e-6;  // radians
  if (walks.size() != 2 || walks[0].nodes.size() != walks[1].nodes.size()) return false;
  std::vector<NodeId> rim;
  for (const WalkNode& w : walks[0].nodes) rim.push_back(w.node);
  const Point centre = plan.frame.origin;
  const std::vector<NodeId> circle = made.circle_of(walks[1], centre, rim);
  for (std::size_t n = 0; n < rim.size(); ++n) {
    const Point in = made.points()[circle[n].value] - centre, out = made.points()[rim[n].value] - centre;
    if (std::abs(cross(in, out)) > kOffRay * dot(in, out)) return false;
  }
  made.add_rings(circle, rim, plan.rings);
  return true;
}

bool fill_lattice(QuadMaker& made, const WorkMesh& mesh, const GridPlan& plan, const std::vector<NodeWalk>& walks) {
  if (!holes_fit(plan, walks)) return false;
  std::optional<PlacedCell> cell = place_cell(mesh, plan, walks);
  if (cell) Filler(made, *cell, walks).run();
  return cell.has_value();
}

}  // namespace

bool fill_grid(WorkMesh& mesh, const Domain& domain, CellId c, const GridPlan& plan) {
  if (!domain.cells[c].lone_points.empty()) return false;
  if (plan.is_disk) return fill_disk(mesh, domain, c, plan.rows);
  const std::vector<NodeWalk> walks = walks_of(mesh, domain, c);
  QuadMaker made(mesh);
  if (!(plan.rings > 0 ? fill_rings(made, plan, walks) : fill_lattice(made, mesh, plan, walks))) return false;
  made.build(mesh, c);
  return true;
}

}  // namespace quadline
