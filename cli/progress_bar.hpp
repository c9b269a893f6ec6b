#pragma once

#include <chrono>
#include <string_view>

namespace quadline {

/// A bar on standard error, where that is a terminal; nothing elsewhere.
class ProgressBar {
 public:
  explicit ProgressBar(bool wanted);
  ~ProgressBar() { clear(); }
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  /// Draws at most ten times a second.
  void show(std::string_view stage, double fraction);
  /// Wipes the bar away: before other text goes to the terminal.
  void clear();

 private:
  using Clock = std::chrono::steady_clock;

  bool is_on_ = false, is_drawn_ = false;
  Clock::time_point start_ = Clock::now(), drawn_ = start_;
};

}  // namespace quadline
