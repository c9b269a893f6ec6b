#include "stages/grid/grid_stops.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <tuple>
#include <utility>

#include "base/constants.hpp"

namespace quadline {

namespace {

constexpr double kTie = 1e-9;            // ties go up, whatever rounding makes of them
constexpr double kAlike = 1e-6;          // of a gap: what differs less is equal
constexpr double kMostCorrected = 0.45;  // squares that a gap takes for others, beside its own rounding

// Stops with one place in the grid.
struct Group {
  std::size_t from, to;
  double at = 0;
  int k = 0;  // the greatest
  bool is_half = false;
};

std::vector<Group> groups_of(const std::vector<GridStop>& stops, double together) {
  std::vector<Group> groups;
  for (std::size_t n = 0; n < stops.size(); ++n) {
    if (n == 0 || stops[n].at - stops[n - 1].at > together) groups.push_back({n, n});
    groups.back().to = n + 1;
  }
  for (Group& g : groups) {
    for (std::size_t n = g.from; n < g.to; ++n) {
      g.at += stops[n].at / static_cast<double>(g.to - g.from);
      g.k = std::max(g.k, stops[n].k);
    }
    g.is_half = g.k % 2 != 0;
  }
  return groups;
}

// A sweep from low to high: a stop meets one of the other group where that ends after it begins.
bool face_each_other(const std::vector<GridStop>& stops, const Group& a, const Group& b) {
  std::vector<std::pair<const GridStop*, bool>> both;
  for (const Group* group : {&a, &b})
    for (std::size_t n = group->from; n < group->to; ++n) both.emplace_back(&stops[n], group == &b);
  std::sort(both.begin(), both.end(), [](const auto& p, const auto& q) { return p.first->low < q.first->low; });
  std::array<double, 2> high{-kInfinity, -kInfinity};  // of those of each group so far
  for (const auto& [stop, is_second] : both) {
    if (stop->low < high[is_second ? 0 : 1]) return true;
    high[is_second] = std::max(high[is_second], stop->high);
  }
  return false;
}

// Between two groups. Alike are those that want the same: they get the same count.
struct Gap {
  double wanted;  // squares
  double half;    // 0.5 where it holds a half square too
  double fewest;  // beside the half
  std::size_t place;

  bool is_like(const Gap& o) const {
    return std::abs(wanted - o.wanted) < kAlike * wanted && half == o.half && fewest == o.fewest;
  }
  double count(double correction) const {
    return std::max(std::floor(wanted - half + correction + 0.5 + kTie), fewest) + half;
  }
};

std::vector<Gap> gaps_of(const std::vector<GridStop>& stops, const std::vector<Group>& groups, double density) {
  std::vector<Gap> gaps;
  for (std::size_t g = 1; g < groups.size(); ++g) {
    const Group &a = groups[g - 1], &b = groups[g];
    const double half = a.is_half != b.is_half ? 0.5 : 0;
    const double least = face_each_other(stops, a, b) ? 0.5 * (a.k + b.k) : 0;
    gaps.push_back({density * (b.at - a.at), half, std::ceil(std::max(least - half, half > 0 ? 0.0 : 1.0)), g});
  }
  return gaps;
}

// By classes of like gaps, those that take most of the way first; what rounding added or took, the next ones give back.
std::vector<double> counts_of(std::vector<Gap> gaps) {
  std::vector<double> counts(gaps.size() + 1, 0);
  std::stable_sort(gaps.begin(), gaps.end(), [](const Gap& a, const Gap& b) {
    return std::tuple(a.wanted, a.half, a.fewest) < std::tuple(b.wanted, b.half, b.fewest);
  });
  std::vector<std::span<const Gap>> classes;
  for (std::size_t from = 0, to = 0; from < gaps.size(); from = to) {
    while (to < gaps.size() && gaps[from].is_like(gaps[to])) ++to;
    classes.emplace_back(gaps.data() + from, to - from);
  }
  std::stable_sort(classes.begin(), classes.end(), [](const auto& a, const auto& b) {
    return static_cast<double>(a.size()) * a[0].wanted > static_cast<double>(b.size()) * b[0].wanted;
  });
  double excess = 0;
  for (const std::span<const Gap> like : classes) {
    const double n = static_cast<double>(like.size());
    const double count = like[0].count(std::clamp(-excess / n, -kMostCorrected, kMostCorrected));
    excess += n * (count - like[0].wanted);
    for (const Gap& gap : like) counts[gap.place] = count;
  }
  return counts;
}

}  // namespace

void place_stops(std::vector<GridStop>& stops, double density, double together) {
  std::sort(stops.begin(), stops.end(), [](const GridStop& a, const GridStop& b) { return a.at < b.at; });
  const std::vector<Group> groups = groups_of(stops, together);
  const std::vector<double> counts = counts_of(gaps_of(stops, groups, density));
  double index = 0;
  for (std::size_t g = 0; g < groups.size(); ++g) {
    index += counts[g];
    for (std::size_t n = groups[g].from; n < groups[g].to; ++n) stops[n].index = index;
  }
}

double index_at(const std::vector<GridStop>& stops, double at) {
  const auto above =
      std::upper_bound(stops.begin(), stops.end(), at, [](double x, const GridStop& stop) { return x < stop.at; });
  if (above == stops.begin()) return stops.front().index;
  if (above == stops.end()) return stops.back().index;
  const GridStop &a = above[-1], &b = *above;
  return a.index + (at - a.at) / (b.at - a.at) * (b.index - a.index);
}

}  // namespace quadline
