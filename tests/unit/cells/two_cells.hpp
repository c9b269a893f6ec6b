#pragma once

#include <array>

#include "quadline/model.hpp"

namespace quadline::shapes {

/// A plate of 8 x 4, cut by a line at x = 4 into two cells; the left one holds a circular hole, the right one a line.
inline Model two_cells() {
  Model model;
  model.size = 0.5;
  model.outer.push_back({.items = {{{0, 0}}, {{8, 0}}, {{8, 4}}, {{0, 4}}}});
  model.holes.push_back({.circle = Circle{{2, 2}, 0.8}});
  model.lines.push_back({.name = "cut", .path = {.items = {{{4, 0}}, {{4, 4}}}}});
  model.lines.push_back({.name = "stiffener", .path = {.items = {{{5, 1}}, {{7, 2.5}}}}});
  return model;
}

/// Lines that end 1e-5 beside a third, closer than anything that can be meshed as asked.
inline Model near_ends() {
  Model model;
  model.size = 0.5;
  model.outer.push_back({.items = {{{0, 0}}, {{8, 0}}, {{8, 6}}, {{0, 6}}}});
  model.lines.push_back({.name = "deck", .path = {.items = {{{1, 3}}, {{7, 3.4}}}}});
  for (const auto& [x, y, gap] : {std::array{3.2, 1.0, -1e-5}, std::array{3.5, 5.0, 2e-5}, std::array{3.7, 5.5, 1e-5}})
    model.lines.push_back({.name = {}, .path = {.items = {{{x, y}}, {{x, 3 + 0.4 * (x - 1) / 6 + gap}}}}});
  return model;
}

}  // namespace quadline::shapes
