#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <queue>
#include <utility>
#include <vector>

#include "base/constants.hpp"
#include "stages/discretize/count_state.hpp"

// Interval assignment [Mitchell1997] by cheapest cycles: a closed path across the faces crosses every face boundary an
// even number of times, so one edge more or less on all curves that it crosses keeps every cell even. Through a
// submappable face it goes straight, or it makes the submappable face unequal. Dijkstra's algorithm finds the cheapest
// path back to the face where it started, within a small budget.

namespace quadline {
namespace {

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
          if (state_.target(c).is_even()) continue;
          const std::int64_t excess = state_.sum(b, k) - state_.sum(b, (k + 2) % 4);
          if (excess == 0) break;
          is_better |= try_from(c, excess > 0 ? -1 : 1);
        }
      }
    }
    return is_better;
  }

 private:
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
    const Rows<std::uint32_t> outside(domain_.vertices.count(), [&](const auto& visit) {
      for (std::uint32_t s = 0; s < face_.size(); ++s)
        if (face_[s] == kNone)
          for (VertexId v : ends(s)) visit(v.value, s);
    });
    for (std::uint32_t s = 0; s < face_.size(); ++s)
      if (face_[s] == kNone) number_outside(s, n++, outside);
    sides_of_.fill(n, [&](const auto& visit) {
      for (std::uint32_t s = 0; s < face_.size(); ++s) visit(face_[s], s);
    });
  }
  std::array<VertexId, 2> ends(std::uint32_t side) const {
    const Domain::Curve& c = domain_.curves[CurveId(side / 2)];
    return {c.tail, c.head};
  }

  /// Numbers a side that looks outside, and those that follow it at vertices where no others do.
  /// @param outside  by vertex: the sides that look outside.
  void number_outside(std::uint32_t first, std::uint32_t number, const Rows<std::uint32_t>& outside) {
    std::vector<std::uint32_t> pending{first};
    face_[first] = number;
    while (!pending.empty()) {
      const std::uint32_t here = pending.back();
      pending.pop_back();
      for (VertexId v : ends(here)) {
        if (outside[v.value].size() != 2) continue;
        for (const std::uint32_t other : outside[v.value])
          if (std::exchange(face_[other], number) != number) pending.push_back(other);
      }
    }
  }

  void index_submaps() {
    submap_.assign(sides_of_.count(), kNone);
    for (std::uint32_t b = 0; b < state_.submaps().size(); ++b)
      if (!state_.submaps()[b].is_ring()) submap_[state_.submaps()[b].walk] = b;
    best_.assign(8 * submap_.size(), kInfinity);
  }

  /// Side of the submappable face that a curve belongs to; the first of a line that ends in it.
  std::uint32_t submap_side(std::uint32_t submap, CurveId c) const {
    for (const CountState::Part& p : state_.parts(c))
      if (p.submap == submap) return p.side;
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
    if (target.is_even() || count < std::max<std::int64_t>(1, target.least)) return kInfinity;
    const double cost = count_cost(target, static_cast<std::uint32_t>(count)) - count_cost(target, state_.count(c));
    return std::max(0.0, cost);
  }

  /// What the counts of two curves of a face make of its submappable face.
  double turning_cost(std::uint32_t face, CurveId a, int step_a, CurveId b, int step_b) const {
    const std::uint32_t submap = submap_[face];
    if (submap == kNone) return 0;
    std::array<std::int64_t, 4> sums = state_.sums(submap);
    for (const auto& [curve, step] : {std::pair{a, step_a}, std::pair{b, step_b}})
      for (const CountState::Part& p : state_.parts(curve))
        if (p.submap == submap) sums[p.side] += step;  // twice for a line that ends in the submappable face
    return CountState::kGapCost *
           static_cast<double>(std::max<std::int64_t>(0, state_.gap(submap, sums) - state_.gap(submap)));
  }

  /// A search for the cheapest closed path across a curve, which gets `step` edges more.
  struct Search {
    using Entry = std::pair<double, std::uint32_t>;  ///< cost so far, arrival
    CurveId start;
    int step;
    std::uint32_t home;  ///< the face on the left of the start, where the path must end
    int budget = kBudget;
    double shortest = kInfinity;  ///< cost of the best path found
    std::uint32_t last = kNone;   ///< its last arrival
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue{};
  };

  bool try_from(CurveId start, int step) {
    for (std::size_t place : used_) best_[place] = kInfinity;
    used_.clear();
    Search search{.start = start, .step = step, .home = face_[side(start, false)]};
    arrivals_.assign(1, {face_[side(start, true)], start, step, kNone});
    search.queue.push({0, 0});
    if (arrivals_[0].face == search.home) {  // a bridge: alone it keeps every cell even
      search.shortest = 0;
      search.last = 0;
    }
    while (!search.queue.empty() && search.budget > 0) {
      const auto [cost, arrival] = search.queue.top();
      search.queue.pop();
      if (cost >= search.shortest) break;
      go_on(search, cost, arrival);
    }
    return search.last != kNone && take(search.last);
  }

  /// From an arrival across every other curve of its face.
  void go_on(Search& search, double cost, std::uint32_t arrival) {
    const Arrival here = arrivals_[arrival];
    for (const std::uint32_t s : sides_of_[here.face]) {
      if (search.budget == 0) return;
      --search.budget;
      const CurveId c(s / 2);
      if (c == here.curve) continue;
      for (int by : {-1, 1}) {
        const double sum = cost + crossing_cost(c, by) + turning_cost(here.face, here.curve, here.step, c, by);
        if (sum < search.shortest) arrive(search, sum, {face_[s ^ 1], c, by, arrival});
      }
    }
  }

  /// Closes the path where that is home; keeps the arrival to go on from where none was cheaper.
  void arrive(Search& search, double cost, const Arrival& next) {
    const auto id = static_cast<std::uint32_t>(arrivals_.size());
    if (next.face == search.home) {
      const double closed = cost + turning_cost(search.home, next.curve, next.step, search.start, search.step);
      if (closed >= search.shortest) return;
      search.shortest = closed;
      search.last = id;
    } else {
      const std::size_t place = slot(next);
      if (cost >= best_[place]) return;
      best_[place] = cost;
      used_.push_back(place);
      search.queue.push({cost, id});
    }
    arrivals_.push_back(next);
  }

  /// Makes the changes of a path; false where they do not gain, or where it crosses a curve twice.
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
  IntervalBalancing balancing(domain, state);
  for (int pass = 0; pass < kMaxPasses; ++pass)
    if (!balancing.pass()) break;
}

}  // namespace quadline
