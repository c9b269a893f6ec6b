#pragma once

#include <string>
#include <string_view>

#include "quadline/errors.hpp"

namespace quadline {

/// @param file  of which the folders are left out: they tell where it was built, which is nobody's business.
[[noreturn]] inline void check_failed(const char* condition, std::string_view file, int line) {
  file.remove_prefix(file.find_last_of("/\\") + 1);  // npos + 1 is 0
  throw InternalError(std::string("internal check failed: ") + condition + " (" + std::string(file) + ":" +
                      std::to_string(line) + ")");
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
