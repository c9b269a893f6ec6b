#include "stages/grid/lattice.hpp"

namespace quadline {

std::vector<GridPlace> traced(const NodeWalk& walk, int direction) {
  constexpr GridPlace kSteps[] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
  std::vector<GridPlace> places;
  places.reserve(walk.nodes.size() + 1);
  GridPlace at;
  for (std::size_t n = 0; n < walk.nodes.size(); ++n) {
    places.push_back(at);
    if (n > 0) direction += walk.nodes[n].turn;
    const GridPlace step = kSteps[direction & 3];
    at = {at.i + step.i, at.j + step.j};
  }
  places.push_back(at);
  return places;
}

Lattice::Lattice(int columns, int rows, bool is_ring) : columns_(columns), rows_(rows), is_ring_(is_ring) {
  const std::size_t n = static_cast<std::size_t>(columns + 1) * static_cast<std::size_t>(rows + 1);
  nodes_.assign(n, NodeId());
  on_boundary_.assign(n, 0);
  on_rim_.assign(n, 0);
  inside_.assign(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows), 0);
}

bool Lattice::put(const NodeWalk& walk, std::span<const GridPlace> places) {
  for (std::size_t n = 0; n < walk.nodes.size(); ++n) {
    const GridPlace from = places[n], to = places[n + 1];
    if (!contains(from) || !contains(to)) return false;
    NodeId& here = node(from);
    if (here.valid() && here != walk.nodes[n].node) return false;
    here = walk.nodes[n].node;
    on_boundary_[index(from)] = 1;
    // Going up, the cell is on the side of the lesser i: a step of the winding number, seen along the row.
    if (from.i == to.i && from.i > 0)
      inside_[square(from.i - 1, std::min(from.j, to.j))] =
          static_cast<std::int8_t>(inside_[square(from.i - 1, std::min(from.j, to.j))] + (to.j > from.j ? 1 : -1));
  }
  return true;
}

bool Lattice::find_inside() {
  for (int j = 0; j < rows_; ++j) {
    int winding = 0;
    for (int i = columns_ - 1; i >= 0; --i) {
      winding += inside_[square(i, j)];
      if (winding < 0 || winding > 1) return false;
      inside_[square(i, j)] = static_cast<std::int8_t>(winding);
    }
  }
  return true;
}

bool Lattice::cut(const Patch& patch) {
  const GridPlace c = patch.corner;
  if (!contains(c) || !contains({c.i + patch.columns, c.j + patch.rows})) return false;
  if (is_ring_ && patch.rows >= rows_) return false;
  for (int j = c.j; j < c.j + patch.rows; ++j)
    for (int i = c.i; i < c.i + patch.columns; ++i) {
      if (!is_quad(i, j)) return false;
      if (i > c.i && j > c.j && is_on_boundary({i, j})) return false;
      inside_[square(i, j)] = 0;
    }
  for (int j = c.j; j <= c.j + patch.rows; ++j)  // where two patches meet no quad is beside it
    for (int i = c.i; i <= c.i + patch.columns; ++i)
      if (j == c.j || j == c.j + patch.rows || i == c.i || i == c.i + patch.columns) on_rim_[index({i, j})] = 1;
  return true;
}

bool Lattice::is_used(GridPlace p) const {
  if (on_rim_[index(p)] != 0) return true;
  for (int j = p.j - 1; j <= p.j; ++j)
    for (int i = p.i - 1; i <= p.i; ++i)
      if (i >= 0 && i < columns_ && (is_ring_ || (j >= 0 && j < rows_)) && is_quad(i, j)) return true;
  return false;
}

}  // namespace quadline
