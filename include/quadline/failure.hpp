#pragma once

#include <string>

#include "quadline/point.hpp"

namespace quadline {

/// Why a mesh does not keep the promise.
struct Failure {
  std::string stage;   ///< where it was found: "verify", or "internal" for a defect of ours
  std::string reason;  ///< one line
  Point at;            ///< model units
};

}  // namespace quadline
