#include "io/text/nearest_name.hpp"

#include <algorithm>

namespace quadline {

namespace {

constexpr std::size_t kTooFar = 4;
constexpr std::size_t kLongest = 64;  // names that are longer were not meant to be one of ours

/// Letters to change, insert or take away to make b of a.
std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t above = row[j];
      row[j] = std::min({above + 1, row[j - 1] + 1, diagonal + (a[i - 1] == b[j - 1] ? 0 : 1)});
      diagonal = above;
    }
  }
  return row[b.size()];
}

}  // namespace

std::string nearest_name(std::string_view name, const std::vector<std::string>& known) {
  std::string nearest;
  std::size_t least = kTooFar;
  for (const std::string& candidate : known) {
    const std::size_t distance = edit_distance(candidate, name.substr(0, kLongest));
    if (distance >= least || 2 * distance > candidate.size()) continue;
    least = distance;
    nearest = candidate;
  }
  return nearest;
}

}  // namespace quadline
