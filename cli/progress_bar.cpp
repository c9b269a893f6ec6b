#include "cli/progress_bar.hpp"

#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string>

namespace quadline {

namespace {

constexpr auto kPause = std::chrono::milliseconds(100);
constexpr int kWidth = 30;

}  // namespace

ProgressBar::ProgressBar(bool wanted) {
  const char* terminal = std::getenv("TERM");
  is_on_ = wanted && ::isatty(STDERR_FILENO) == 1 && terminal && std::string_view(terminal) != "dumb";
}

void ProgressBar::show(std::string_view stage, double fraction) {
  if (!is_on_) return;
  const auto now = Clock::now();
  if (now - drawn_ < kPause) return;
  drawn_ = now;
  is_drawn_ = true;
  const double part = std::clamp(fraction, 0.0, 1.0);
  const int full = static_cast<int>(part * kWidth);
  const std::string bar = std::string(full, '#') + std::string(kWidth - full, '.');
  const std::chrono::duration<double> elapsed = now - start_;
  std::fprintf(stderr, "\r\x1b[K[%s] %3d %%  %.*s  %.1f s", bar.c_str(), static_cast<int>(100 * part),
               static_cast<int>(stage.size()), stage.data(), elapsed.count());
  std::fflush(stderr);
}

void ProgressBar::clear() {
  if (!is_drawn_) return;
  std::fputs("\r\x1b[K", stderr);
  std::fflush(stderr);
  is_drawn_ = false;
}

}  // namespace quadline
