#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "geom/curve.hpp"

namespace quadline {

inline Box inflated(const Box& b, double by) { return {{b.lo.x - by, b.lo.y - by}, {b.hi.x + by, b.hi.y + by}}; }

inline Box join(const Box& a, const Box& b) {
  return {{std::min(a.lo.x, b.lo.x), std::min(a.lo.y, b.lo.y)}, {std::max(a.hi.x, b.hi.x), std::max(a.hi.y, b.hi.y)}};
}

inline bool overlap(const Box& a, const Box& b) {
  return a.lo.x <= b.hi.x && b.lo.x <= a.hi.x && a.lo.y <= b.hi.y && b.lo.y <= a.hi.y;
}

/// A static tree of boxes, packed in sorted tiles [Leutenegger1997].
///
/// Items are known by their place in the vector given. Built in O(n log n); a query costs O(log n + hits) where boxes
/// overlap little. The order of hits depends on the boxes alone.
class BoxTree {
 public:
  explicit BoxTree(const std::vector<Box>& boxes) : boxes_(boxes) {
    sort_tiles();
    pack();
  }

  const Box& box_of(std::size_t item) const { return boxes_[item]; }
  std::size_t count() const { return boxes_.size(); }

  /// Calls visit(item) for every item whose box touches `query`.
  template <class Visit>
  void query(const Box& query, Visit&& visit) const {
    if (!boxes_.empty()) descend(levels_.size() - 1, 0, query, visit);
  }

  /// Calls visit(item) for the items whose boxes the ray from `start` may meet before the best hit. The visitor returns
  /// the length of the ray up to its hit in the item, in lengths of `direction`, or infinity.
  /// @param direction  with both coordinates other than zero.
  template <class Visit>
  void ray(Point start, Point direction, Visit&& visit) const {
    double best = std::numeric_limits<double>::infinity();
    if (!boxes_.empty()) nearest_first(levels_.size() - 1, 0, start, direction, best, visit);
  }

 private:
  static constexpr std::size_t kFan = 8;

  void sort_tiles() {
    const std::size_t n = boxes_.size();
    order_.resize(n);
    for (std::size_t i = 0; i < n; ++i) order_[i] = static_cast<std::uint32_t>(i);
    const auto x = [this](std::uint32_t i) { return boxes_[i].lo.x + 0.5 * (boxes_[i].hi.x - boxes_[i].lo.x); };
    const auto y = [this](std::uint32_t i) { return boxes_[i].lo.y + 0.5 * (boxes_[i].hi.y - boxes_[i].lo.y); };
    std::sort(order_.begin(), order_.end(), [&](std::uint32_t i, std::uint32_t j) {
      const double a = x(i), b = x(j);
      return a != b ? a < b : i < j;
    });
    const std::size_t leaves = (n + kFan - 1) / kFan;
    const std::size_t per_slice = kFan * static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(leaves))));
    for (std::size_t first = 0; first < n; first += per_slice) {
      const auto begin = order_.begin() + static_cast<std::ptrdiff_t>(first);
      const auto end = order_.begin() + static_cast<std::ptrdiff_t>(std::min(n, first + per_slice));
      std::sort(begin, end, [&](std::uint32_t i, std::uint32_t j) {
        const double a = y(i), b = y(j);
        return a != b ? a < b : i < j;
      });
      // Every other slice runs back, so that neighbours in the order are neighbours in the plane.
      if (first / per_slice % 2 == 1) std::reverse(begin, end);
    }
  }

  /// Boxes of groups of kFan, level by level; level 0 groups the items.
  void pack() {
    for (std::size_t below = boxes_.size(); below > 1 || levels_.empty();) {
      std::vector<Box> level((below + kFan - 1) / kFan);
      for (std::size_t i = 0; i < below; ++i) {
        const Box& b = levels_.empty() ? boxes_[order_[i]] : levels_.back()[i];
        level[i / kFan] = i % kFan == 0 ? b : join(level[i / kFan], b);
      }
      below = level.size();
      levels_.push_back(std::move(level));
    }
  }

  std::size_t count_below(std::size_t level) const { return level == 0 ? boxes_.size() : levels_[level - 1].size(); }
  const Box& box_below(std::size_t level, std::size_t i) const {
    return level == 0 ? boxes_[order_[i]] : levels_[level - 1][i];
  }

  template <class Visit>
  void descend(std::size_t level, std::size_t group, const Box& query, const Visit& visit) const {
    for (std::size_t i = group * kFan; i < std::min(count_below(level), (group + 1) * kFan); ++i) {
      if (!overlap(box_below(level, i), query)) continue;
      if (level > 0) {
        descend(level - 1, i, query, visit);
      } else {
        visit(order_[i]);
      }
    }
  }

  template <class Visit>
  void nearest_first(std::size_t level, std::size_t group, Point start, Point direction, double& best,
                     const Visit& visit) const {
    std::array<std::pair<double, std::size_t>, kFan> entries;
    std::size_t n = 0;
    for (std::size_t i = group * kFan; i < std::min(count_below(level), (group + 1) * kFan); ++i) {
      const double at = entry(box_below(level, i), start, direction);
      if (!(at < best)) continue;
      std::size_t k = n++;
      for (; k > 0 && entries[k - 1].first > at; --k) entries[k] = entries[k - 1];
      entries[k] = {at, i};
    }
    for (std::size_t k = 0; k < n && entries[k].first < best; ++k) {
      if (level > 0) {
        nearest_first(level - 1, entries[k].second, start, direction, best, visit);
      } else {
        best = std::min(best, visit(order_[entries[k].second]));
      }
    }
  }

  /// Where the ray enters the box, in lengths of its direction; infinity where it misses.
  static double entry(const Box& b, Point start, Point direction) {
    const double x0 = (b.lo.x - start.x) / direction.x, x1 = (b.hi.x - start.x) / direction.x;
    const double y0 = (b.lo.y - start.y) / direction.y, y1 = (b.hi.y - start.y) / direction.y;
    const double in = std::max({std::min(x0, x1), std::min(y0, y1), 0.0});
    const double out = std::min(std::max(x0, x1), std::max(y0, y1));
    return in <= out ? in : std::numeric_limits<double>::infinity();
  }

  std::vector<Box> boxes_;
  std::vector<std::uint32_t> order_;
  std::vector<std::vector<Box>> levels_;
};

}  // namespace quadline
