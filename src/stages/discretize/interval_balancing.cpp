#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

#include "stages/discretize/count_state.hpp"

// Interval assignment [Mitchell1997] by cheapest cycles: a closed path across the faces crosses every face boundary an
// even number of times, so one edge more or less on all curves that it crosses keeps every cell even. Through a
// submappable face it goes straight, or it makes the submappable face unequal. Dijkstra's algorithm finds the cheapest
// path back to the face where it started, within a small budget.

namespace quadline {
namespace {

constexpr double kFar = std::numeric_limits<double>::infinity();
constexpr int kBudget = 2000;  // curves looked at per path
constexpr int kMaxPasses = 4;

class IntervalBalancing {
 public:
  IntervalBalancing(const Domain& domain, CountState& state) : domain_(domain), state_(state) {
    number_faces();
    index_submaps();
  }

  /// Tries to start a path at each curve of an unequal submappable face; true where one gained.
  bool pass() {
    bool is_better = false;
    for (std::uint32_t b = 0; b < state_.submaps().size(); ++b) {
      const SubmappableFace& submap = state_.submaps()[b];
      for (std::uint32_t k = 0; k < 4; ++k) {
        if (!submap.is_close[k % 2]) continue;
        for (CurveId c : submap.sides[k]) {
          if (state_.target(c).is_even) continue;
          const std::int64_t excess = state_.sum(b, k) - state_.sum(b, (k + 2) % 4);
          if (excess == 0) break;
          is_better |= try_from(c, excess > 0 ? -1 : 1);
        }
      }
    }
    return is_better;
  }

 private:
  static constexpr std::uint32_t kNone = UINT32_MAX;

  /// A way into a face: across a curve, which gets one edge more or less.
  struct Arrival {
    std::uint32_t face = kNone;
    CurveId curve;
    int step = 0;
    std::uint32_t from = kNone;  ///< the arrival before it, an index into `arrivals_`
  };

  std::size_t side(CurveId c, bool is_right) const { return 2 * std::size_t{c.value} + is_right; }

  /// Faces are walks, not cells: a cell with a hole is two of them, since parities hold round each walk. The sides of a
  /// curve that look outside form faces as well; where a face outside touches itself it stays in parts, which only
  /// keeps paths from using it.
  void number_faces() {
    face_.assign(2 * domain_.curves.count(), kNone);
    std::uint32_t n = 0;
    for (const Domain::Cell& cell : domain_.cells)
      for (const auto& walk : cell.walks) {
        for (const DirectedCurve& d : walk) face_[side(d.curve, d.reversed)] = n;
        ++n;
      }
    IdVector<VertexId, std::vector<std::size_t>> outside(domain_.vertices.count());
    for (std::size_t i = 0; i < domain_.curves.count(); ++i)
      for (bool is_right : {false, true}) {
        if (face_[side(CurveId(i), is_right)] != kNone) continue;
        for (VertexId v : {domain_.curves[CurveId(i)].tail, domain_.curves[CurveId(i)].head})
          outside[v].push_back(side(CurveId(i), is_right));
      }
    for (std::size_t s = 0; s < face_.size(); ++s) {
      if (face_[s] != kNone) continue;
      std::vector<std::size_t> pending{s};
      for (face_[s] = n; !pending.empty();) {
        const Domain::Curve& c = domain_.curves[CurveId(pending.back() / 2)];
        pending.pop_back();
        for (VertexId v : {c.tail, c.head}) {
          if (outside[v].size() != 2) continue;
          for (std::size_t other : outside[v])
            if (std::exchange(face_[other], n) != n) pending.push_back(other);
        }
      }
      ++n;
    }
    sides_of_.fill(n, [&](const auto& visit) {
      for (std::uint32_t s = 0; s < face_.size(); ++s) visit(face_[s], s);
    });
  }

  void index_submaps() {
    submap_.assign(sides_count(), kNone);
    for (std::uint32_t b = 0; b < state_.submaps().size(); ++b)
      if (!state_.submaps()[b].is_ring()) submap_[state_.submaps()[b].walk] = b;
    best_.assign(8 * submap_.size(), kFar);
  }
  std::size_t sides_count() const {
    std::uint32_t most = 0;
    for (std::uint32_t f : face_) most = std::max(most, f + 1);
    return most;
  }

  /// Side of the submappable face that a curve belongs to; the first of a line that ends in it.
  std::uint32_t submap_side(std::uint32_t submap, CurveId c) const {
    for (auto p = state_.parts().begin(c.value); p != state_.parts().end(c.value); ++p)
      if (p->submap == submap) return p->side;
    return 0;
  }

  /// Where an arrival counts as the same: by face, and in submappable faces also by side and step.
  std::size_t slot(const Arrival& a) const {
    const std::uint32_t submap = submap_[a.face];
    if (submap == kNone) return 8 * std::size_t{a.face};
    return 8 * std::size_t{a.face} + 2 * submap_side(submap, a.curve) + (a.step > 0);
  }

  double crossing_cost(CurveId c, int step) const {
    const CountTarget& target = state_.target(c);
    const std::int64_t count = static_cast<std::int64_t>(state_.count(c)) + step;
    if (target.is_even || count < std::max<std::int64_t>(1, target.least)) return kFar;
    const double cost = count_cost(target, static_cast<std::uint32_t>(count)) - count_cost(target, state_.count(c));
    return std::max(0.0, cost);
  }

  /// What the counts of two curves of a face make of its submappable face.
  double turning_cost(std::uint32_t face, CurveId a, int step_a, CurveId b, int step_b) const {
    const std::uint32_t submap = submap_[face];
    if (submap == kNone) return 0;
    std::array<std::int64_t, 4> sums = state_.sums(submap);
    for (const auto& [curve, step] : {std::pair{a, step_a}, std::pair{b, step_b}})
      for (auto p = state_.parts().begin(curve.value); p != state_.parts().end(curve.value); ++p)
        if (p->submap == submap) sums[p->side] += step;  // twice for a line that ends in the submappable face
    return CountState::kGapCost *
           static_cast<double>(std::max<std::int64_t>(0, state_.gap(submap, sums) - state_.gap(submap)));
  }

  bool try_from(CurveId start, int step) {
    const std::uint32_t home = face_[side(start, false)];
    arrivals_.assign(1, {face_[side(start, true)], start, step, kNone});
    for (std::size_t s : used_) best_[s] = kFar;
    used_.clear();
    std::priority_queue<std::pair<double, std::uint32_t>, std::vector<std::pair<double, std::uint32_t>>, std::greater<>>
        queue;
    queue.push({0, 0});
    double shortest = kFar;
    std::uint32_t last = kNone;
    if (arrivals_[0].face == home) {
      last = 0;  // a bridge: alone it keeps every cell even
      shortest = 0;
    }
    for (int budget = kBudget; !queue.empty() && budget > 0;) {
      const auto [cost, id] = queue.top();
      queue.pop();
      if (cost >= shortest) break;
      const Arrival here = arrivals_[id];
      for (auto s = sides_of_.begin(here.face); s != sides_of_.end(here.face) && budget > 0; ++s, --budget) {
        const CurveId c(*s / 2);
        if (c == here.curve) continue;
        for (int by : {-1, 1}) {
          const double sum = cost + crossing_cost(c, by) + turning_cost(here.face, here.curve, here.step, c, by);
          const Arrival next{face_[*s ^ 1], c, by, id};
          if (sum >= shortest) continue;
          if (next.face == home) {
            const double closed = sum + turning_cost(home, c, by, start, step);
            if (closed >= shortest) continue;
            shortest = closed;
            last = static_cast<std::uint32_t>(arrivals_.size());
            arrivals_.push_back(next);
            continue;
          }
          const std::size_t place = slot(next);
          if (sum >= best_[place]) continue;
          best_[place] = sum;
          used_.push_back(place);
          queue.push({sum, static_cast<std::uint32_t>(arrivals_.size())});
          arrivals_.push_back(next);
        }
      }
    }
    return last != kNone && take(last);
  }

  bool take(std::uint32_t last) {
    changes_.clear();
    for (std::uint32_t id = last; id != kNone; id = arrivals_[id].from) {
      const Arrival& a = arrivals_[id];
      changes_.push_back(
          {a.curve, static_cast<std::uint32_t>(static_cast<std::int64_t>(state_.count(a.curve)) + a.step)});
    }
    std::sort(changes_.begin(), changes_.end(), [](const auto& a, const auto& b) { return a.curve < b.curve; });
    for (std::size_t i = 0; i < changes_.size(); ++i) {
      if (i > 0 && changes_[i].curve == changes_[i - 1].curve) return false;
      if (changes_[i].count < std::max(1u, state_.target(changes_[i].curve).least)) return false;
    }
    return state_.try_changes(changes_);
  }

  const Domain& domain_;
  CountState& state_;
  std::vector<std::uint32_t> face_;    ///< per side
  Rows<std::uint32_t> sides_of_;       ///< per face
  std::vector<std::uint32_t> submap_;  ///< per face; kNone: no submappable face
  std::vector<Arrival> arrivals_;
  std::vector<double> best_;       ///< cost of the cheapest arrival per slot
  std::vector<std::size_t> used_;  ///< slots to clear
  std::vector<CountState::Change> changes_;
};

}  // namespace

void balance_intervals(const Domain& domain, CountState& state) {
  if (state.submaps().empty()) return;
  IntervalBalancing exchange(domain, state);
  for (int pass = 0; pass < kMaxPasses; ++pass)
    if (!exchange.pass()) break;
}

}  // namespace quadline
