#include "stages/grid/grid_places.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/constants.hpp"

namespace quadline {

namespace {

constexpr std::int64_t kMostEmpty = 16, kSmall = 4096;  // squares of the lattice for each that is inside, or in all

class Placer {
 public:
  Placer(const WorkMesh& mesh, const GridPlan& plan, const std::vector<NodeWalk>& walks)
      : mesh_(mesh),
        plan_(plan),
        walks_(walks),
        frame_(plan.frame),
        is_hole_(walks.size(), false),
        places_(walks.size()) {
    for (const GridHole& hole : plan.holes) is_hole_[hole.walk] = true;
  }

  std::optional<PlacedCell> run() {
    if (!trace_outer() || !trace_inner()) return std::nullopt;
    if (!has_room()) return std::nullopt;
    Lattice lattice(columns_, rows_, frame_.is_polar);
    for (std::size_t w = 0; w < walks_.size(); ++w)
      if (!is_hole_[w] && !lattice.put(walks_[w], places_[w])) return std::nullopt;
    if (!lattice.find_inside()) return std::nullopt;
    PlacedCell cell{frame_, std::move(lattice), GridMap(known_[0]), GridMap(known_[1]), {}};
    for (const GridHole& hole : plan_.holes) {
      if (!cell.columns.is_valid() || !cell.rows.is_valid()) return std::nullopt;
      cell.holes.push_back({hole, patch_of(hole, cell)});
      if (!cell.lattice.cut(cell.holes.back().patch)) return std::nullopt;
    }
    return cell;
  }

 private:
  bool trace_outer() {
    places_[0] = traced(walks_[0], frame_.is_polar ? 1 : plan_.direction);
    if (walks_[0].turns != (frame_.is_polar ? 0 : 4)) return false;
    if (frame_.is_polar) return true;
    if (places_[0].back() != GridPlace{}) return false;
    GridPlace low, high;
    for (const GridPlace p : places_[0]) {
      low = {std::min(low.i, p.i), std::min(low.j, p.j)};
      high = {std::max(high.i, p.i), std::max(high.j, p.j)};
    }
    move(places_[0], {-low.i, -low.j});
    columns_ = high.i - low.i;
    rows_ = high.j - low.j;
    learn(0);
    return true;
  }

  bool trace_inner() {
    if (frame_.is_polar && !trace_ring()) return false;
    for (std::size_t w = 1; w < walks_.size(); ++w)
      if (!is_hole_[w] && !(frame_.is_polar && w == plan_.inner)) return false;
    return true;
  }

  // Between two circles: their common number of rows round, and as many columns as make quads square.
  bool trace_ring() {
    const std::size_t w = plan_.inner;
    if (walks_[w].turns != 0) return false;
    const GridPlace end = places_[0].back();
    places_[w] = traced(walks_[w], 3);
    if (end.i != 0 || end.j < 3 || places_[w].back() != GridPlace{0, -end.j}) return false;
    rows_ = end.j;
    const Point start = mesh_.point(walks_[0].nodes[0].node) - frame_.origin;
    frame_.axis = (1 / norm(start)) * start;
    const Point outer = frame_.to_frame(mesh_.point(walks_[0].nodes[0].node));
    const Point inner = frame_.to_frame(mesh_.point(walks_[w].nodes[0].node));
    columns_ = std::max(1, static_cast<int>(std::floor((outer.x - inner.x) * rows_ / kFullTurn + 0.5)));
    if (is_patch_on_circle(inner.x, outer.x)) ++columns_;
    move(places_[0], {columns_, 0});
    for (std::size_t n = 0; n < walks_[0].nodes.size(); ++n)
      if (places_[0][n].i == columns_)
        known_[1].push_back({n == 0 ? 0 : frame_.to_frame(mesh_.point(walks_[0].nodes[n].node)).y, places_[0][n].j});
    known_[1].push_back({kFullTurn, rows_});
    known_[0] = {{inner.x, 0}, {outer.x, columns_}};
    const GridMap rows(known_[1]);
    if (!rows.is_valid()) return false;
    move(places_[w], {0, static_cast<int>(std::floor(rows.to_grid(inner.y) + 0.5))});
    return true;
  }

  // Rings that reach to a circle would have to bend to it: there is a row between them where one more makes room.
  bool is_patch_on_circle(double inner, double outer) const {
    return std::any_of(plan_.holes.begin(), plan_.holes.end(), [&](const GridHole& hole) {
      const int first = first_of_patch(columns_ * (frame_.to_frame(hole.at).x - inner) / (outer - inner), hole.columns);
      return first < 1 || first + hole.columns >= columns_;
    });
  }

  static void move(std::vector<GridPlace>& places, GridPlace by) {
    for (GridPlace& p : places) p = {p.i + by.i, p.j + by.j};
  }

  void learn(std::size_t w) {
    for (std::size_t n = 0; n < walks_[w].nodes.size(); ++n) {
      const Point at = frame_.to_frame(mesh_.point(walks_[w].nodes[n].node));
      known_[0].push_back({at.x, places_[w][n].i});
      known_[1].push_back({at.y, places_[w][n].j});
    }
  }

  // The lattice is not much larger than the cell in it.
  bool has_room() const {
    if (columns_ < 1 || rows_ < 1) return false;
    const std::int64_t box = std::int64_t{columns_} * rows_;
    std::int64_t inside = 0;
    for (std::size_t w = 0; w < walks_.size(); ++w)
      for (std::size_t n = 0; n + 1 < places_[w].size(); ++n)
        inside += std::int64_t{places_[w][n].i} * (places_[w][n + 1].j - places_[w][n].j);
    return box <= kSmall || box <= kMostEmpty * inside;
  }

  Patch patch_of(const GridHole& hole, const PlacedCell& cell) const {
    const Point at = cell.frame.to_frame(hole.at);
    const Point middle = columns_ == plan_.columns && rows_ == plan_.rows
                             ? hole.place
                             : Point{cell.columns.to_grid(at.x), cell.rows.to_grid(at.y)};
    return {{first_of_patch(middle.x, hole.columns), first_of_patch(middle.y, hole.rows)}, hole.columns, hole.rows};
  }

  static int first_of_patch(double middle, int n) { return static_cast<int>(std::floor(middle - 0.5 * n + 0.5)); }

  const WorkMesh& mesh_;
  const GridPlan& plan_;
  const std::vector<NodeWalk>& walks_;
  GridFrame frame_;
  std::vector<bool> is_hole_;  // of every walk
  std::vector<std::vector<GridPlace>> places_;
  std::array<std::vector<GridMap::Known>, 2> known_;
  int columns_ = 0, rows_ = 0;
};

}  // namespace

std::optional<PlacedCell> place_cell(const WorkMesh& mesh, const GridPlan& plan, const std::vector<NodeWalk>& walks) {
  return Placer(mesh, plan, walks).run();
}

}  // namespace quadline
