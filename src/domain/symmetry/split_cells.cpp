// A cell's boundary as half-edges with the cell on their left: a cut adds two of them, which go between an edge and the
// next at both of its ends; what can be walked round then are the parts.
#include "domain/symmetry/split_cells.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <utility>

#include "base/constants.hpp"
#include "domain/cell_locator.hpp"

namespace quadline {

namespace {

using Walk = std::vector<DirectedCurve>;

Point start_tangent(const Domain& domain, const DirectedCurve& d) {
  const CurvePiece& piece = domain.curves[d.curve].piece;
  return d.reversed ? -1.0 * tangent_at(piece, length(piece)) : tangent_at(piece, 0);
}
VertexId tail_of(const Domain& domain, const DirectedCurve& d) {
  return d.reversed ? domain.curves[d.curve].head : domain.curves[d.curve].tail;
}

// Counter-clockwise from u to v: 0..4, grows with the angle.
double turn(Point u, Point v) {
  const double c = dot(u, v), s = cross(u, v), sum = std::abs(c) + std::abs(s);
  return s >= 0 ? 1 - c / sum : 3 + c / sum;
}

// Halves the curves that cuts end at.
class CurveSplitter {
 public:
  explicit CurveSplitter(Domain& domain) : domain_(domain), second_(domain.curves.count()) {}

  VertexId vertex_at(const CutEnd& end) {
    if (end.vertex.valid()) return end.vertex;
    if (!second_[end.curve].valid()) split(end.curve);
    return domain_.curves[end.curve].head;
  }

  // Puts both halves where a curve was.
  void mend_chains() const {
    for (Domain::Cell& cell : domain_.cells)
      for (Walk& walk : cell.walks) mend(walk);
    for (Domain::Path& path : domain_.paths) mend(path.curves);
  }

 private:
  void split(CurveId c) {
    Domain::Curve first = domain_.curves[c];
    const double whole = length(first.piece), half = 0.5 * whole;
    const CurvePiece piece = first.piece;
    const Point middle = point_at(piece, half);
    first.edges /= 2;
    Domain::Curve second = first;
    first.head = second.tail = domain_.vertices.push_back({middle});
    first.piece = sub_piece(piece, 0, half, piece.a, middle);
    second.piece = sub_piece(piece, half, whole, middle, piece.b);
    domain_.curves[c] = first;
    second_[c] = domain_.curves.push_back(second);
  }

  void mend(Walk& chain) const {
    Walk mended;
    for (const DirectedCurve& d : chain) {
      const CurveId second = second_[d.curve];
      if (second.valid() && d.reversed) mended.push_back({second, true});
      mended.push_back(d);
      if (second.valid() && !d.reversed) mended.push_back({second, false});
    }
    chain = std::move(mended);
  }

  Domain& domain_;
  IdVector<CurveId, CurveId> second_;  // of those that are split
};

class CellSplitter {
 public:
  CellSplitter(Domain& domain, CellId cell) : domain_(domain), cell_(cell) {
    for (const Walk& walk : domain.cells[cell].walks)
      for (std::size_t i = 0; i < walk.size(); ++i) {
        const std::size_t h = halves_.size() - i;
        halves_.push_back(walk[i]);
        next_.push_back(h + (i + 1) % walk.size());
      }
    previous_.resize(next_.size());
    for (std::size_t h = 0; h < next_.size(); ++h) {
      previous_[next_[h]] = h;
      leaving_[tail_of(domain, halves_[h])].push_back(h);
    }
  }

  void add(CurveId cut) {
    const std::size_t out = halves_.size(), back = out + 1;
    halves_.push_back({cut, false});
    halves_.push_back({cut, true});
    next_.resize(back + 1);
    link(out, back);
    link(back, out);
  }

  void run() {
    std::vector<Walk> outer, inner;
    for (Walk& walk : walks()) (area(walk) > 0 ? outer : inner).push_back(std::move(walk));
    const Domain::Cell whole = domain_.cells[cell_];
    std::vector<CellId> parts;
    for (Walk& walk : outer) {
      Domain::Cell part{.walks = {std::move(walk)}, .lone_points = {}, .region = whole.region, .size = whole.size};
      if (parts.empty()) {
        domain_.cells[cell_] = std::move(part);
        parts.push_back(cell_);
      } else {
        parts.push_back(domain_.cells.push_back(std::move(part)));
      }
      name_sides(domain_.cells[parts.back()].walks[0], parts.back());
    }
    const Domain outline = outline_of(parts);
    const CellLocator locator(outline);
    for (Walk& walk : inner) {
      const CellId part = locator.at(domain_.vertices[tail_of(domain_, walk[0])].at);
      name_sides(walk, part);
      domain_.cells[part].walks.push_back(std::move(walk));
    }
    for (const VertexId v : whole.lone_points)
      if (!leaving_.contains(v)) domain_.cells[locator.at(domain_.vertices[v].at)].lone_points.push_back(v);
  }

 private:
  // Puts `out` and its twin, which arrives, into the sector that holds them. At a lone point the one cut follows the
  // other.
  void link(std::size_t out, std::size_t arriving) {
    const VertexId v = tail_of(domain_, halves_[out]);
    std::vector<std::size_t>& leaving = leaving_[v];
    if (leaving.empty()) {
      next_[arriving] = out;
      previous_.resize(next_.size());
      previous_[out] = arriving;
    } else {
      const Point direction = start_tangent(domain_, halves_[out]);
      const std::size_t o = *std::min_element(leaving.begin(), leaving.end(), [&](std::size_t a, std::size_t b) {
        return turn(start_tangent(domain_, halves_[a]), direction) <
               turn(start_tangent(domain_, halves_[b]), direction);
      });
      previous_.resize(next_.size());
      next_[previous_[o]] = out;
      previous_[out] = previous_[o];
      next_[arriving] = o;
      previous_[o] = arriving;
    }
    leaving.push_back(out);
  }

  std::vector<Walk> walks() const {
    std::vector<Walk> found;
    std::vector<bool> is_walked(halves_.size(), false);
    for (std::size_t start = 0; start < halves_.size(); ++start) {
      if (is_walked[start]) continue;
      Walk& walk = found.emplace_back();
      for (std::size_t h = start; !is_walked[h]; h = next_[h]) {
        is_walked[h] = true;
        walk.push_back(halves_[h]);
      }
    }
    return found;
  }

  // Of a line that is walked on both sides it is none, and the rounding of that must not count.
  double area(const Walk& walk) const {
    const Point origin = domain_.vertices[tail_of(domain_, walk[0])].at;
    double twice = 0, whole = 0;
    for (const DirectedCurve& d : walk) {
      const CurvePiece& piece = domain_.curves[d.curve].piece;
      twice += twice_area_under(d.reversed ? reversed(piece) : piece, origin);
      whole += length(piece);
    }
    return 0.5 * twice - domain_.tolerance * whole;
  }

  void name_sides(const Walk& walk, CellId part) {
    for (const DirectedCurve& d : walk)
      (d.reversed ? domain_.curves[d.curve].right : domain_.curves[d.curve].left) = part;
  }

  Domain outline_of(const std::vector<CellId>& parts) const {
    Domain outline;
    for (const CellId part : parts)
      for (const DirectedCurve& d : domain_.cells[part].walks[0]) outline.curves.push_back(domain_.curves[d.curve]);
    return outline;
  }

  Domain& domain_;
  CellId cell_;
  Walk halves_;
  std::vector<std::size_t> next_, previous_;  // along the boundary
  std::map<VertexId, std::vector<std::size_t>> leaving_;
};

}  // namespace

Domain split_cells(Domain domain, const std::vector<Cut>& cuts) {
  CurveSplitter splitter(domain);
  std::map<CellId, std::vector<CurveId>> of_cell;
  for (const Cut& cut : cuts) {
    const VertexId from = splitter.vertex_at(cut.from), to = splitter.vertex_at(cut.to);
    const CurvePiece piece{.a = domain.vertices[from].at, .b = domain.vertices[to].at};
    of_cell[cut.cell].push_back(domain.curves.push_back({.tail = from,
                                                         .head = to,
                                                         .piece = piece,
                                                         .left = cut.cell,
                                                         .right = cut.cell,
                                                         .size = kInfinity,
                                                         .is_auxiliary = true}));
  }
  splitter.mend_chains();
  for (const auto& [cell, curves] : of_cell) {
    CellSplitter parts(domain, cell);
    for (const CurveId c : curves) parts.add(c);
    parts.run();
  }
  return domain;
}

}  // namespace quadline
