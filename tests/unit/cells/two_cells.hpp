#pragma once

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

}  // namespace quadline::shapes
