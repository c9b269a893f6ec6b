#pragma once

#include <span>

#include "quadline/point.hpp"

namespace quadline::cleanup {

/// A quad seen from one of its corners: the other three, counter-clockwise.
struct StarQuad {
  Point next, opposite, previous;
};

/// A better place for a node with the given quads round it: one guarded Newton step of the sum of the inverse mean
/// ratios of the corners that it takes part in [Knupp2000], and of the stretch of its edges against the target `size`.
/// Inverted corners are let in and pushed out [Garanzha2021]. Returns p itself where the step does not help.
Point better_place(Point p, std::span<const StarQuad> star, double size);

}  // namespace quadline::cleanup
