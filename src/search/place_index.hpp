#pragma once

#include <algorithm>
#include <cmath>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "quadline/point.hpp"

namespace quadline {

/// Finds places that are given again, up to a tolerance.
///
/// Places are sorted by the squares of a grid. Built in O(n log n); a query costs O(log n) where the places are some
/// tolerances apart.
class PlaceIndex {
 public:
  static constexpr std::size_t kNone = SIZE_MAX;

  /// @param places     must outlive this.
  /// @param tolerance  model units, > 0; no less than 2^-48 of the coordinates.
  PlaceIndex(std::span<const Point> places, double tolerance)
      : places_(places), tolerance_(tolerance), per_side_(1 / (kSquare * tolerance)) {
    for (std::size_t i = 0; i < places.size(); ++i) entries_.push_back({cell(places[i].x), cell(places[i].y), i});
    std::sort(entries_.begin(), entries_.end());
  }

  /// The place nearest to p, no farther than the tolerance, the first of equals; kNone: there is none.
  std::size_t find(Point p) const {
    std::size_t best = kNone;
    double least = tolerance_ * tolerance_;
    for (std::int64_t x = cell(p.x - tolerance_); x <= cell(p.x + tolerance_); ++x)
      for (std::int64_t y = cell(p.y - tolerance_); y <= cell(p.y + tolerance_); ++y) {
        const Entry from{x, y, 0};
        for (auto e = std::lower_bound(entries_.begin(), entries_.end(), from);
             e != entries_.end() && e->x == x && e->y == y; ++e) {
          const double d = norm2(places_[e->place] - p);
          if (d > least || (d == least && e->place > best)) continue;
          least = d;
          best = e->place;
        }
      }
    return best;
  }

 private:
  static constexpr double kSquare = 4;  // side of a square, in tolerances

  struct Entry {
    std::int64_t x, y;
    std::size_t place;
    friend auto operator<=>(const Entry&, const Entry&) = default;
  };
  std::int64_t cell(double along) const { return static_cast<std::int64_t>(std::floor(along * per_side_)); }

  std::span<const Point> places_;
  double tolerance_, per_side_;
  std::vector<Entry> entries_;
};

}  // namespace quadline
