// A cell that turns in quarter turns: a lattice of rows and columns whose numbers come from the gaps between what they
// must meet.
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "base/constants.hpp"
#include "domain/walk_turns.hpp"
#include "stages/grid/grid_stops.hpp"
#include "stages/grid/hole_shape.hpp"
#include "stages/grid/propose_grid.hpp"

namespace quadline {

namespace {

constexpr double kTogether = 0.3;  // sizes: stops so near get one place in the grid
constexpr std::array<double, kProposals> kDensities{1, 1.08, 1};
constexpr double kSparsest = 0.5;  // of the density of squares of the size

class StraightGrid {
 public:
  StraightGrid(const Domain& domain, CellId c, const std::vector<InnerWalk>& holes)
      : domain_(domain), cell_(c), walk_(domain.cells[c].walks[0]), inner_(holes), h_(domain.cells[c].size) {}

  std::optional<GridProposal> propose(double quads, int variant, const Options& options) {
    if (!find_sides() || is_too_large(options.max_quads)) return std::nullopt;
    for (const InnerWalk& inner : inner_) {
      const std::optional<HoleShape> shape = shape_of(domain_, cell_, inner, plan_.frame);
      if (!shape || is_too_fine(*shape, h_)) return std::nullopt;
      holes_.push_back({*shape, counts_of(*shape, h_, variant, options)});
    }
    if (!make_parities_alike()) return std::nullopt;
    collect_stops();
    for (auto& stops : stops_) {
      place_stops(stops, kDensities[static_cast<std::size_t>(variant)] * density(quads), kTogether * h_);
      if (stops.front().k > 0 || stops.back().k > 0) return std::nullopt;
    }
    plan_.columns = static_cast<int>(stops_[0].back().index);
    plan_.rows = static_cast<int>(stops_[1].back().index);
    add_holes();
    if (std::any_of(plan_.holes.begin(), plan_.holes.end(), [&](const GridHole& hole) { return is_pressed(hole); }))
      return std::nullopt;
    wish_sides();
    return GridProposal{std::move(plan_), std::move(wishes_), std::move(turns_)};
  }

 private:
  // Curves that follow each other without a turn: they lie on one line of the lattice.
  struct Side {
    std::size_t first, count;  // in the walk
    int direction;             // quarter turns from the axis
    double at = 0;             // its mean place, across it, in the frame

    bool is_level() const { return direction % 2 == 0; }
  };

  struct Hole {
    HoleShape shape;
    HoleCounts counts;
  };

  const CurvePiece& piece(std::size_t n) const { return domain_.curves[walk_[n % walk_.size()].curve].piece; }
  Point start(std::size_t n) const { return walk_[n % walk_.size()].reversed ? piece(n).b : piece(n).a; }

  // The sides, and the frame that suits their directions best; false where the walk is not that of a lattice.
  bool find_sides() {
    const std::vector<int> quads = quads_along(domain_, walk_);
    const auto corner = std::find_if(quads.begin(), quads.end(), [](int k) { return k != 2; });
    if (turns(quads) != 4 || corner == quads.end()) return false;
    const std::size_t first = static_cast<std::size_t>(corner - quads.begin());
    int direction = 0;
    Point axis;
    for (std::size_t k = 0; k < walk_.size(); ++k) {
      const std::size_t n = (first + k) % walk_.size();
      direction += k == 0 ? 0 : 2 - quads[n];
      if (k == 0 || quads[n] != 2) sides_.push_back({n, 0, direction & 3});
      ++sides_.back().count;
      Point v = start(n + 1) - start(n);
      for (int turn = direction & 3; turn > 0; --turn) v = -1.0 * left_normal(v);
      axis += v;
    }
    if (!(norm(axis) > 0)) return false;
    axis = (1 / norm(axis)) * axis;
    while (!(axis.x > std::abs(axis.y) || axis.x == axis.y)) {
      axis = left_normal(axis);
      for (Side& side : sides_) side.direction = (side.direction + 3) & 3;
    }
    plan_.frame = {start(0), axis, false};
    plan_.direction = side_at(0).direction;
    return true;
  }

  // Even of a thin cell all squares of its box must be within the limit, or the lattice could not be stored.
  bool is_too_large(double most) const {
    Point low{kInfinity, kInfinity}, high{-kInfinity, -kInfinity};
    for (std::size_t n = 0; n < walk_.size(); ++n) {
      const Point p = plan_.frame.to_frame(start(n));
      low = {std::min(low.x, p.x), std::min(low.y, p.y)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
    const double columns = std::max(1.0, (high.x - low.x) / h_), rows = std::max(1.0, (high.y - low.y) / h_);
    return columns * rows > most;
  }

  // The side that a curve of the walk is on.
  const Side& side_at(std::size_t n) const {
    return *std::find_if(sides_.begin(), sides_.end(),
                         [&](const Side& side) { return (n + walk_.size() - side.first) % walk_.size() < side.count; });
  }

  // Holes with their middles in one row (or column) all have one there, or a line between two: if one does not suit,
  // all holes of the cell follow the largest, or those whose edges are given. False where these differ.
  bool make_parities_alike() {
    if (!has_mixed(0) && !has_mixed(1)) return true;
    const auto leader = std::max_element(holes_.begin(), holes_.end(), [](const Hole& a, const Hole& b) {
      return std::pair(a.shape.given > 0, a.counts.edges()) < std::pair(b.shape.given > 0, b.counts.edges());
    });
    const int parity = leader->counts.k[0] & 1;
    for (Hole& hole : holes_)
      for (const std::size_t side : {0u, 1u}) {
        if ((hole.counts.k[side] & 1) == parity) continue;
        if (hole.shape.given > 0) return false;
        grow(hole.counts, hole.shape, side);
      }
    return true;
  }

  bool has_mixed(std::size_t side) const {
    std::vector<std::pair<double, int>> middles;
    for (const Hole& hole : holes_) {
      const Point at = plan_.frame.to_frame(hole.shape.center);
      middles.emplace_back(side == 0 ? at.x : at.y, hole.counts.k[side]);
    }
    std::sort(middles.begin(), middles.end());
    for (std::size_t n = 1; n < middles.size(); ++n)
      if (middles[n].first - middles[n - 1].first <= kTogether * h_ && (middles[n].second ^ middles[n - 1].second) & 1)
        return true;
    return false;
  }

  // Squares for each unit of length, such that the grid has the quads that are asked for: patches and their first rings
  // count. More rings come with small holes, which ask for more quads whatever is round them.
  double density(double quads) const {
    double full = quads;
    for (const Hole& hole : holes_) {
      full += hole.shape.area / (h_ * h_);
      quads -= hole.counts.edges() - hole.counts.k[0] * hole.counts.k[1];
    }
    return std::max(kSparsest, std::sqrt(std::max(quads, 0.0) / full)) / h_;
  }

  void collect_stops() {
    for (Side& side : sides_) {
      double sum = 0, whole = 0;
      GridStop stop{0, 0, kInfinity, -kInfinity};
      for (std::size_t n = side.first; n < side.first + side.count; ++n) {
        const Point a = plan_.frame.to_frame(start(n)), b = plan_.frame.to_frame(start(n + 1));
        const double way = length(piece(n));
        sum += 0.5 * way * (side.is_level() ? a.y + b.y : a.x + b.x);
        whole += way;
        for (const Point p : {a, b}) {
          stop.low = std::min(stop.low, side.is_level() ? p.x : p.y);
          stop.high = std::max(stop.high, side.is_level() ? p.x : p.y);
        }
      }
      stop.at = side.at = sum / whole;
      stops_[side.is_level() ? 1 : 0].push_back(stop);
    }
    for (const Hole& hole : holes_) {
      const Point at = plan_.frame.to_frame(hole.shape.center);
      const auto [width, height] = hole.shape.across;
      stops_[0].push_back({at.x, hole.counts.k[0], at.y - 0.5 * height, at.y + 0.5 * height});
      stops_[1].push_back({at.y, hole.counts.k[1], at.x - 0.5 * width, at.x + 0.5 * width});
    }
  }

  void add_holes() {
    for (const Hole& hole : holes_) {
      const Point at = plan_.frame.to_frame(hole.shape.center);
      plan_.holes.push_back({hole.shape.walk,
                             hole.counts.k[0],
                             hole.counts.k[1],
                             rings_of(hole.shape, hole.counts, h_),
                             hole.shape.center,
                             {index_at(stops_[0], at.x), index_at(stops_[1], at.y)}});
      for (const DirectedCurve& d : domain_.cells[cell_].walks[hole.shape.walk]) wish(hole, d.curve);
      if (hole.shape.is_circle()) turns_.push_back({hole.shape.walk, plan_.frame.axis + left_normal(plan_.frame.axis)});
    }
  }

  // One ring from wall to wall has nothing to give way.
  bool is_pressed(const GridHole& hole) const {
    return hole.rings == 1 && (hole.columns >= plan_.columns || hole.rows >= plan_.rows);
  }

  void wish(const Hole& hole, CurveId c) {
    const CurvePiece& piece = domain_.curves[c].piece;
    const Point v = plan_.frame.to_frame(piece.b) - plan_.frame.to_frame(piece.a);
    const std::size_t along = std::abs(v.x) > std::abs(v.y) ? 0 : 1;
    wishes_.push_back({c, piece.is_arc() ? hole.counts.arc : hole.counts.straight[along]});
  }

  /// Where a side meets its neighbour, along it: on the neighbour's line, or at a tip, where a line turns back.
  double place_of_end(const Side& side, const Side& neighbour, Point end) const {
    const auto& stops = stops_[side.is_level() ? 0 : 1];
    if (neighbour.is_level() != side.is_level()) return index_at(stops, neighbour.at);
    const Point tip = plan_.frame.to_frame(end);
    return std::floor(0.5 + index_at(stops, side.is_level() ? tip.x : tip.y));
  }

  void wish_sides() {
    for (std::size_t k = 0; k < sides_.size(); ++k) {
      const Side& side = sides_[k];
      const Side &before = sides_[(k + sides_.size() - 1) % sides_.size()], &after = sides_[(k + 1) % sides_.size()];
      const double from = place_of_end(side, before, start(side.first));
      const double to = place_of_end(side, after, start(side.first + side.count));
      double whole = 0, way = 0, last = 0;
      for (std::size_t n = side.first; n < side.first + side.count; ++n) whole += length(piece(n));
      for (std::size_t n = side.first; n < side.first + side.count; ++n) {
        way += length(piece(n));
        const double place = std::floor(0.5 + std::abs(to - from) * (way / whole));
        wishes_.push_back({walk_[n % walk_.size()].curve, static_cast<std::uint32_t>(std::max(1.0, place - last))});
        last = place;
      }
    }
  }

  const Domain& domain_;
  CellId cell_;
  const std::vector<DirectedCurve>& walk_;
  const std::vector<InnerWalk>& inner_;
  double h_;
  std::vector<Side> sides_;
  std::vector<Hole> holes_;
  std::array<std::vector<GridStop>, 2> stops_;  // of the columns and of the rows
  GridPlan plan_;
  std::vector<CountWish> wishes_;
  std::vector<GridProposal::Turn> turns_;
};

}  // namespace

double quads_asked(const Domain& domain, CellId c) {
  const Domain::Cell& cell = domain.cells[c];
  double twice_area = 0;
  for (const auto& walk : cell.walks)
    for (const DirectedCurve& d : walk)
      twice_area += (d.reversed ? -1 : 1) * twice_area_under(domain.curves[d.curve].piece, domain.box.lo);
  return 0.5 * twice_area / (cell.size * cell.size);
}

std::optional<GridProposal> propose_straight(const Domain& domain, CellId c, const std::vector<InnerWalk>& holes,
                                             int variant, const Options& options) {
  return StraightGrid(domain, c, holes).propose(quads_asked(domain, c), variant, options);
}

}  // namespace quadline
