#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace quadline {

/// Rows of varying length in one array (compressed sparse rows).
template <class T>
class Rows {
 public:
  Rows() = default;
  template <class Each>
  Rows(std::size_t n, const Each& each) {
    fill(n, each);
  }

  /// Makes `n` rows; what was there is gone. Within a row items stand in the order of their visits. O(rows + items).
  /// @param each  `each(visit)` calls `visit(row, item)` for every item; called twice, to count and to fill.
  template <class Each>
  void fill(std::size_t n, const Each& each) {
    // Filling moves each start to the end of its row, which is the start of the next: so starts stand one place too far
    // while it goes on.
    start_.assign(n + 2, 0);
    each([&](std::size_t row, const T&) { ++start_[row + 2]; });
    for (std::size_t i = 2; i < start_.size(); ++i) start_[i] += start_[i - 1];
    items_.resize(start_.back());
    each([&](std::size_t row, const T& item) { items_[start_[row + 1]++] = item; });
    start_.pop_back();
  }

  std::size_t count() const { return start_.empty() ? 0 : start_.size() - 1; }
  std::span<const T> operator[](std::size_t row) const {
    return {items_.data() + start_[row], items_.data() + start_[row + 1]};
  }
  std::span<T> operator[](std::size_t row) { return {items_.data() + start_[row], items_.data() + start_[row + 1]}; }

  /// All items, row after row.
  std::span<const T> items() const { return items_; }

 private:
  std::vector<std::uint32_t> start_;  // of each row, and the end of the last
  std::vector<T> items_;
};

}  // namespace quadline
