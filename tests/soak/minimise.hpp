#pragma once

#include <functional>

#include "quadline/model.hpp"

namespace quadline {

/// The smallest model found that still shows the failure: without the lines, holes, points, regions, sizes and corners
/// that it does not need, and with coordinates of few digits.
/// @param fails     does this model still show it?
/// @param max_runs  calls of `fails` at most.
Model minimise(Model model, const std::function<bool(const Model&)>& fails, int max_runs);

}  // namespace quadline
