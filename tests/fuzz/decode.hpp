#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include "quadline/model.hpp"

namespace quadline {

/// A model on a grid of small whole numbers: the first byte is the size of the elements; then five bytes make a line, a
/// point or a square hole.
inline Model decode_model(const std::uint8_t* data, std::size_t size, std::size_t most_items) {
  constexpr int kGrid = 9;
  const auto coordinate = [](std::uint8_t byte) { return static_cast<double>(byte % kGrid); };
  Model m;
  m.size = size > 0 ? 0.5 + data[0] / 128.0 : 1;
  m.outer = {{.items = {{{0, 0}, {}}, {{8, 0}, {}}, {{8, 8}, {}}, {{0, 8}, {}}}, .circle = {}, .where = "outer"}};
  for (std::size_t i = 1; i + 5 <= size && i / 5 < most_items; i += 5) {
    const Point a{coordinate(data[i + 1]), coordinate(data[i + 2])},
        b{coordinate(data[i + 3]), coordinate(data[i + 4])};
    const std::string name = "n" + std::to_string(i);
    Path path{.items = {{a, {}}, {b, {}}}, .circle = {}, .where = name};
    switch (data[i] % 8) {
      case 0:
        m.points.push_back({.name = name, .at = a, .size = {}, .where = name});
        break;
      case 1:
        path.items = {{a, {}}, {{b.x, a.y}, {}}, {b, {}}, {{a.x, b.y}, {}}};
        m.holes.push_back(path);
        break;
      case 2:
        path.items[1].via = Point{coordinate(data[i + 2]), coordinate(data[i + 3])};
        [[fallthrough]];
      default:
        m.lines.push_back({.name = name, .path = path, .size = {}});
    }
  }
  return m;
}

}  // namespace quadline
