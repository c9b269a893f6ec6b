#pragma once

#include <functional>
#include <string>

#include "cells/attempt.hpp"

namespace quadline {

/// Attempts until one keeps the promise, or the plan knows nothing more: then the first, with what is told of all. The
/// report has all but the findings of the model, and measures.
/// @param file     of the model, for messages.
/// @param attempt  once through the stages as `plan` is now.
/// @throws InputError where the first needs more quads than allowed.
MeshResult chain_attempts(FallbackPlan& plan, const std::string& file,
                          const std::function<Attempt(CellCache&)>& attempt);

}  // namespace quadline
