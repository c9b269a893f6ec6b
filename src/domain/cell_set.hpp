#pragma once

#include <algorithm>
#include <cstdint>

#include "base/id.hpp"

namespace quadline {

/// Some of the cells of a domain.
class CellSet {
 public:
  bool contains(CellId c) const { return c.value < is_in_.count() && is_in_[c] != 0; }
  bool empty() const {
    return std::none_of(is_in_.begin(), is_in_.end(), [](std::uint8_t in) { return in != 0; });
  }
  void insert(CellId c) {
    is_in_.grow(c.value + std::size_t{1}, 0);
    is_in_[c] = 1;
  }

 private:
  IdVector<CellId, std::uint8_t> is_in_;
};

}  // namespace quadline
