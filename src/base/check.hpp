#pragma once

#include <string>

#include "quadline/errors.hpp"

namespace quadline {

[[noreturn]] inline void check_failed(const char* condition, const char* file, int line) {
  throw InternalError(std::string("internal check failed: ") + condition + " (" + file + ":" + std::to_string(line) +
                      ")");
}

}  // namespace quadline

/// A cheap check of our own work; stays on in release. Throws InternalError.
#define QUADLINE_CHECK(condition) ((condition) ? void(0) : ::quadline::check_failed(#condition, __FILE__, __LINE__))

/// A check that costs; on in debug builds only.
#ifdef NDEBUG
#define QUADLINE_DEBUG_CHECK(condition) void(0)
#else
#define QUADLINE_DEBUG_CHECK(condition) QUADLINE_CHECK(condition)
#endif
