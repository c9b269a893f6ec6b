#pragma once

namespace quadline {

/// The version of these headers, after semantic versioning. CMake refuses to build where its own differs.
inline constexpr const char* kVersion = "0.1.0";

}  // namespace quadline
