#include "search/hilbert.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <utility>

namespace quadline {

namespace {

// Turns (x, y), 16 bits each, to the place on the Hilbert curve.
std::uint32_t hilbert_key(std::uint32_t x, std::uint32_t y) {
  std::uint32_t key = 0;
  for (std::uint32_t s = 1u << 15; s > 0; s >>= 1) {
    const std::uint32_t rx = (x & s) ? 1 : 0, ry = (y & s) ? 1 : 0;
    key = key * 4 + ((3 * rx) ^ ry);
    if (ry == 0) {
      if (rx == 1) {
        x = 0xffff - x;
        y = 0xffff - y;
      }
      std::swap(x, y);
    }
  }
  return key;
}

// For each point its place on a Hilbert curve over the box of all (high half) and its index (low half).
std::vector<std::uint64_t> hilbert_keys(const std::vector<Point>& points) {
  std::vector<std::uint64_t> keys(points.size());
  if (points.empty()) return keys;
  Point lo = points[0], hi = points[0];
  for (const Point p : points) {
    lo = {std::fmin(lo.x, p.x), std::fmin(lo.y, p.y)};
    hi = {std::fmax(hi.x, p.x), std::fmax(hi.y, p.y)};
  }
  const double extent = std::fmax(hi.x - lo.x, hi.y - lo.y);
  const double scale = extent > 0 ? 65535 / extent : 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Point d = points[i] - lo;
    const std::uint64_t key =
        hilbert_key(static_cast<std::uint32_t>(d.x * scale), static_cast<std::uint32_t>(d.y * scale));
    keys[i] = key << 32 | i;
  }
  return keys;
}

// Number of tosses of a coin until heads: 0 for a half of all i, 1 for a quarter, ...
std::uint32_t round_of(std::uint32_t i) {
  i = (i ^ (i >> 16)) * 0x7feb352du;
  i = (i ^ (i >> 15)) * 0x846ca68bu;
  i ^= i >> 16;
  return i == 0 ? 0 : static_cast<std::uint32_t>(std::countr_zero(i));
}

}  // namespace

std::vector<std::uint32_t> hilbert_order(const std::vector<Point>& points) {
  std::vector<std::uint64_t> keys = hilbert_keys(points);
  std::sort(keys.begin(), keys.end());
  std::vector<std::uint32_t> order(points.size());
  for (std::size_t i = 0; i < keys.size(); ++i) order[i] = static_cast<std::uint32_t>(keys[i]);
  return order;
}

std::vector<std::uint32_t> insertion_order(const std::vector<Point>& points) {
  // The last round takes a half of the points, the one before it a quarter, and so on.
  constexpr std::size_t kRounds = 24;
  std::array<std::vector<std::uint64_t>, kRounds> rounds;
  for (const std::uint64_t key : hilbert_keys(points))
    rounds[round_of(static_cast<std::uint32_t>(key)) % kRounds].push_back(key);
  std::vector<std::uint32_t> order;
  order.reserve(points.size());
  for (std::size_t k = kRounds; k-- > 0;) {
    std::sort(rounds[k].begin(), rounds[k].end());
    for (const std::uint64_t key : rounds[k]) order.push_back(static_cast<std::uint32_t>(key));
  }
  return order;
}

}  // namespace quadline
