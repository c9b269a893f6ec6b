#include "stages/grid/grid_map.hpp"

#include <algorithm>

namespace quadline {

GridMap::GridMap(std::vector<Known> known) {
  std::sort(known.begin(), known.end(),
            [](const Known& a, const Known& b) { return a.index != b.index ? a.index < b.index : a.at < b.at; });
  for (std::size_t from = 0, to = 0; from < known.size(); from = to) {
    double sum = 0;
    for (; to < known.size() && known[to].index == known[from].index; ++to) sum += known[to].at;
    knots_.push_back({sum / static_cast<double>(to - from), static_cast<double>(known[from].index)});
  }
  is_valid_ = knots_.size() >= 2;
  for (std::size_t k = 1; k < knots_.size(); ++k) is_valid_ &= knots_[k - 1].at < knots_[k].at;
}

double GridMap::to_grid(double at) const {
  const auto above = std::upper_bound(knots_.begin() + 1, knots_.end() - 1, at,
                                      [](double x, const Knot& knot) { return x < knot.at; });
  const Knot &a = above[-1], &b = *above;
  return a.index + (at - a.at) / (b.at - a.at) * (b.index - a.index);
}

double GridMap::to_frame(double index) const {
  const auto above = std::upper_bound(knots_.begin() + 1, knots_.end() - 1, index,
                                      [](double x, const Knot& knot) { return x < knot.index; });
  const Knot &a = above[-1], &b = *above;
  return a.at + (index - a.index) / (b.index - a.index) * (b.at - a.at);
}

}  // namespace quadline
