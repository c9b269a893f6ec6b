#pragma once

#include <vector>

#include "quadline/model.hpp"
#include "tests/unit/grid/grid_shapes.hpp"

namespace quadline::shapes {

/// A plate of 12 x 12 from the origin, size 1, with round holes.
inline Model square_plate(const std::vector<Circle>& holes) {
  Model model;
  model.size = 1;
  model.outer.push_back({.items = {{{0, 0}}, {{12, 0}}, {{12, 12}}, {{0, 12}}}});
  for (const Circle& hole : holes) model.holes.push_back({.circle = hole});
  return model;
}

}  // namespace quadline::shapes
