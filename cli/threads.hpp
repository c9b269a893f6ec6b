#pragma once

#include <cstddef>
#include <functional>

namespace quadline {

/// For `Context::run_all`: takes jobs in their order, up to `threads` at once; fewer where the system has no more.
std::function<void(std::size_t n, const std::function<void(std::size_t)>& job)> run_on_threads(unsigned threads);

}  // namespace quadline
