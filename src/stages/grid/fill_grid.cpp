#include "stages/grid/fill_grid.hpp"

#include <algorithm>
#include <cstdint>
#include <utility>

#include "stages/grid/fill_disk.hpp"
#include "stages/grid/grid_places.hpp"
#include "stages/grid/lattice_points.hpp"
#include "stages/grid/walk_nodes.hpp"

namespace quadline {

namespace {

constexpr double kBetter = 1 - 1e-6;  // of a misfit: rounding decides nothing
constexpr int kMostSteps = 32;        // round a hole: of the longest slots the direction is that many off

class Filler {
 public:
  Filler(WorkMesh& mesh, PlacedCell& cell, const std::vector<NodeWalk>& walks)
      : mesh_(mesh), cell_(cell), walks_(walks), lattice_(cell.lattice) {
    for (const NodeId v : mesh.topo().nodes()) {
      points_.push_back(mesh.point(v));
      tags_.push_back(mesh.tag(v));
    }
  }

  void run(CellId c) {
    add_nodes();
    add_quads();
    for (const PlacedHole& hole : cell_.holes) add_rings(hole);
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

  int node_rows() const { return lattice_.is_ring() ? lattice_.rows() - 1 : lattice_.rows(); }

  void add_nodes() {
    LatticePoints places(cell_, points_);
    places.interpolate();
    for (int j = 0; j <= node_rows(); ++j)
      for (int i = 0; i <= lattice_.columns(); ++i)
        if (const GridPlace p{i, j}; !lattice_.node(p).valid() && lattice_.is_used(p))
          lattice_.node(p) = add_node(places.at(p));
    for (const PlacedHole& hole : cell_.holes)  // between two patches there may be no square
      for (const GridPlace p : rim_places(hole.patch))
        if (!lattice_.node(p).valid()) lattice_.node(p) = add_node(places.at(p));
  }

  void add_quads() {
    for (int j = 0; j < lattice_.rows(); ++j)
      for (int i = 0; i < lattice_.columns(); ++i)
        if (lattice_.is_quad(i, j)) add_quad({i, j}, {i + 1, j}, {i + 1, j + 1}, {i, j + 1});
  }
  void add_quad(GridPlace a, GridPlace b, GridPlace c, GridPlace d) {
    quads_.emplace_back(lattice_.node(a), lattice_.node(b), lattice_.node(c), lattice_.node(d));
  }

  // The rim of a patch, counter-clockwise from its corner of least i and j.
  static std::vector<GridPlace> rim_places(const Patch& patch) {
    std::vector<GridPlace> rim;
    const auto [i, j] = patch.corner;
    const int columns = patch.columns, rows = patch.rows;
    for (int n = 0; n < columns; ++n) rim.push_back({i + n, j});
    for (int n = 0; n < rows; ++n) rim.push_back({i + columns, j + n});
    for (int n = 0; n < columns; ++n) rim.push_back({i + columns - n, j + rows});
    for (int n = 0; n < rows; ++n) rim.push_back({i, j + rows - n});
    return rim;
  }

  std::vector<NodeId> rim_of(const Patch& patch) const {
    std::vector<NodeId> rim;
    for (const GridPlace p : rim_places(patch)) rim.push_back(lattice_.node(p));
    return rim;
  }

  // The nodes of a hole, counter-clockwise, each beside its node of the rim: from the one in the direction of the first
  // on, round the hole as long as they fit better.
  std::vector<NodeId> circle_of(const GridHole& hole, const std::vector<NodeId>& rim) const {
    std::vector<NodeId> circle;
    for (const WalkNode& w : walks_[hole.walk].nodes) circle.push_back(w.node);
    std::reverse(circle.begin(), circle.end());
    const auto seen = [&](NodeId v) {  // from the centre
      const Point way = points_[v.value] - hole.at;
      return (1 / norm(way)) * way;
    };
    const Point towards = seen(rim[0]);
    const auto is_less = [&](NodeId a, NodeId b) { return dot(seen(a), towards) < dot(seen(b), towards); };
    auto first = static_cast<std::size_t>(std::max_element(circle.begin(), circle.end(), is_less) - circle.begin());
    for (const std::size_t step : {std::size_t{1}, circle.size() - 1}) first = best_from(first, step, circle, rim);
    std::rotate(circle.begin(), circle.begin() + static_cast<std::ptrdiff_t>(first), circle.end());
    return circle;
  }

  std::size_t best_from(std::size_t first, std::size_t step, const std::vector<NodeId>& circle,
                        const std::vector<NodeId>& rim) const {
    const std::size_t n = circle.size();
    const auto misfit = [&](std::size_t at) {
      double sum = 0;
      for (std::size_t k = 0; k < n; ++k) sum += norm2(points_[rim[k].value] - points_[circle[(at + k) % n].value]);
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

  void add_rings(const PlacedHole& placed) {
    const std::vector<NodeId> rim = rim_of(placed.patch);
    const std::vector<NodeId> circle = circle_of(placed.hole, rim);
    std::vector<NodeId> inner = circle;
    for (int ring = 1; ring <= placed.hole.rings; ++ring) {
      const double share = static_cast<double>(ring) / placed.hole.rings;
      std::vector<NodeId> outer = rim;
      if (ring < placed.hole.rings)
        for (std::size_t n = 0; n < rim.size(); ++n)
          outer[n] = add_node(points_[circle[n].value] + share * (points_[rim[n].value] - points_[circle[n].value]));
      for (std::size_t n = 0; n < rim.size(); ++n) {
        const std::size_t next = (n + 1) % rim.size();
        quads_.emplace_back(inner[n], outer[n], outer[next], inner[next]);
      }
      inner = std::move(outer);
    }
  }

  WorkMesh& mesh_;
  PlacedCell& cell_;
  const std::vector<NodeWalk>& walks_;
  Lattice& lattice_;
  std::vector<Point> points_;
  std::vector<NodeTag> tags_;
  std::vector<Polygon> quads_;
};

// The circles of the holes have the nodes that their rings need.
bool holes_fit(const GridPlan& plan, const std::vector<NodeWalk>& walks) {
  return std::all_of(plan.holes.begin(), plan.holes.end(), [&](const GridHole& hole) {
    return walks[hole.walk].turns == 0 &&
           walks[hole.walk].nodes.size() == 2 * static_cast<std::size_t>(hole.columns + hole.rows);
  });
}

}  // namespace

bool fill_grid(WorkMesh& mesh, const Domain& domain, CellId c, const GridPlan& plan) {
  if (plan.is_disk) return fill_disk(mesh, domain, c, plan.rows);
  const std::vector<NodeWalk> walks = walks_of(mesh, domain, c);
  if (!domain.cells[c].lone_points.empty() || !holes_fit(plan, walks)) return false;
  std::optional<PlacedCell> cell = place_cell(mesh, plan, walks);
  if (!cell) return false;
  Filler(mesh, *cell, walks).run(c);
  return true;
}

}  // namespace quadline
