#include "stages/grid/lattice_points.hpp"

#include <algorithm>

#include "base/constants.hpp"

namespace quadline {

LatticePoints::LatticePoints(const PlacedCell& cell, const std::vector<Point>& points) : cell_(cell) {
  const std::size_t n = static_cast<std::size_t>(cell.lattice.columns() + 1) * static_cast<std::size_t>(node_rows());
  value_.assign(n, Point{});
  weight_.assign(n, 0);
  is_known_.assign(n, false);
  for (int j = 0; j < node_rows(); ++j)
    for (int i = 0; i <= cell.lattice.columns(); ++i) {
      const NodeId v = cell.lattice.node({i, j});
      if (!v.valid()) continue;
      Point at = cell.frame.to_frame(points[v.value]);
      if (cell.lattice.is_ring()) {  // next to where the row is: 0 and a full turn are one
        const double expected = cell.rows.to_frame(j);
        if (at.y - expected > 0.5 * kFullTurn) at.y -= kFullTurn;
        if (expected - at.y > 0.5 * kFullTurn) at.y += kFullTurn;
      }
      set({i, j}, at);
    }
}

GridPlace LatticePoints::wrapped(GridPlace p) const {
  if (!cell_.lattice.is_ring()) return p;
  const int rows = cell_.lattice.rows();
  return {p.i, ((p.j % rows) + rows) % rows};
}

// What is to be added to the value at the wrapped place.
Point LatticePoints::lap(GridPlace p) const {
  if (!cell_.lattice.is_ring()) return {};
  const int laps = (p.j - wrapped(p).j) / cell_.lattice.rows();
  return {0, kFullTurn * laps};
}

void LatticePoints::set(GridPlace p, Point value) {
  const std::size_t n = index(wrapped(p));
  value_[n] = value - lap(p);
  is_known_[n] = true;
}

void LatticePoints::set_rim(const PlacedHole& placed) {
  const auto& [corner, columns, rows] = placed.patch;
  const GridPlace end{corner.i + columns, corner.j + rows};
  const auto in_frame = [&](double i, double j) { return Point{cell_.columns.to_frame(i), cell_.rows.to_frame(j)}; };
  const Point off = cell_.frame.to_frame(placed.hole.at) - in_frame(0.5 * (corner.i + end.i), 0.5 * (corner.j + end.j));
  for (int j = corner.j; j <= end.j; ++j)
    for (int i = corner.i; i <= end.i; ++i) {
      const bool is_inside = i > corner.i && i < end.i && j > corner.j && j < end.j;
      if (!is_inside && !is_known_[index(wrapped({i, j}))]) set({i, j}, in_frame(i, j) + off);
    }
}

void LatticePoints::spread_between(const std::vector<GridPlace>& line, std::size_t from, std::size_t to) {
  const Point a = value_[index(wrapped(line[from]))] + lap(line[from]),
              b = value_[index(wrapped(line[to]))] + lap(line[to]);
  const double weight = 1 / static_cast<double>(to - from);
  for (std::size_t n = from + 1; n < to; ++n) {
    const std::size_t here = index(wrapped(line[n]));
    const Point between = a + (static_cast<double>(n - from) * weight) * (b - a) - lap(line[n]);
    value_[here] += weight * between;
    weight_[here] += weight;
  }
}

void LatticePoints::spread(const std::vector<GridPlace>& line) {
  std::size_t last = line.size();
  for (std::size_t n = 0; n < line.size(); ++n) {
    if (!is_known_[index(wrapped(line[n]))]) continue;
    if (last != line.size()) spread_between(line, last, n);
    last = n;
  }
}

void LatticePoints::interpolate() {
  for (const PlacedHole& hole : cell_.holes) set_rim(hole);
  const int columns = cell_.lattice.columns(), rows = cell_.lattice.rows();
  std::vector<GridPlace> line;
  for (int j = 0; j < node_rows(); ++j) {
    line.clear();
    for (int i = 0; i <= columns; ++i) line.push_back({i, j});
    spread(line);
  }
  for (int i = 0; i <= columns; ++i) {
    int first = 0;
    while (cell_.lattice.is_ring() && first < rows && !is_known_[index({i, first})]) ++first;
    if (cell_.lattice.is_ring() && first == rows) continue;  // nothing is known all round
    line.clear();
    for (int j = first; j <= first + rows; ++j) line.push_back({i, j});
    spread(line);
  }
  for (std::size_t n = 0; n < value_.size(); ++n)
    if (!is_known_[n] && weight_[n] > 0) value_[n] = (1 / weight_[n]) * value_[n];
}

}  // namespace quadline
