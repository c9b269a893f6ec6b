#include "cli/threads.hpp"

#include <algorithm>
#include <atomic>
#include <system_error>
#include <thread>
#include <vector>

namespace quadline {

std::function<void(std::size_t n, const std::function<void(std::size_t)>& job)> run_on_threads(unsigned threads) {
  return [threads](std::size_t n, const std::function<void(std::size_t)>& job) {
    std::atomic<std::size_t> next = 0;
    const auto take_jobs = [&] {
      for (std::size_t i = next++; i < n; i = next++) job(i);
    };
    std::vector<std::jthread> others;
    std::size_t wanted = std::min<std::size_t>(threads, n);
    while (others.size() + 1 < wanted) {
      try {
        others.emplace_back(take_jobs);
      } catch (const std::system_error&) {
        wanted = others.size() + 1;  // those that are there take the jobs of the others
      }
    }
    take_jobs();
  };
}

}  // namespace quadline
