#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "base/check.hpp"
#include "domain/size/size_field.hpp"

namespace quadline {

/// A size field and multiples of it, made once for all cells.
class SpacedSizes {
 public:
  /// The field alone, which must outlive this.
  explicit SpacedSizes(const SizeField& size) : size_(size) {}
  void add(double spacing) { scaled_.emplace_back(spacing, size_.scaled(spacing)); }

  /// @pre `spacing` is 1, or was added.

  const SizeField& at(double spacing) const {
    if (spacing == 1) return size_;
    const auto found =
        std::find_if(scaled_.begin(), scaled_.end(), [&](const auto& field) { return field.first == spacing; });
    QUADLINE_CHECK(found != scaled_.end());
    return found->second;
  }

 private:
  const SizeField& size_;
  std::vector<std::pair<double, SizeField>> scaled_;
};

}  // namespace quadline
