#pragma once

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <utility>
#include <vector>

#include "quadline/context.hpp"
#include "quadline/report.hpp"

namespace quadline {

/// Runs stages by name and notes how long each took.
class StageClock {
 public:
  template <class Stage>
  auto run(const char* name, const Context& context, Stage stage) {
    context.progress(name, 0);
    const auto start = std::chrono::steady_clock::now();
    struct Note {  // on the way out, whatever the stage returns or throws
      std::vector<StageTime>& times;
      const char* name;
      std::chrono::steady_clock::time_point start;
      ~Note() {
        const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
        times.push_back({name, elapsed.count()});
      }
    } note{times_, name, start};
    return stage();
  }

  /// The same for work whose parts, as `stage` returns them, may have run at the same time: notes the parts, each name
  /// once, with the share of the elapsed time that is theirs.
  template <class Stage>
  void run_parts(const char* name, const Context& context, Stage stage) {
    std::vector<StageTime> parts;
    StageClock whole;
    whole.run(name, context, [&] { parts = stage(); });
    double sum = 0;
    const std::size_t first = times_.size();
    for (const StageTime& part : parts) {
      sum += part.elapsed_s;
      const auto known = std::find_if(times_.begin() + static_cast<std::ptrdiff_t>(first), times_.end(),
                                      [&](const StageTime& time) { return time.stage == part.stage; });
      if (known == times_.end()) {
        times_.push_back(part);
      } else {
        known->elapsed_s += part.elapsed_s;
      }
    }
    for (std::size_t i = first; sum > 0 && i < times_.size(); ++i)
      times_[i].elapsed_s *= whole.times_[0].elapsed_s / sum;
  }

  std::vector<StageTime>& times() { return times_; }

 private:
  std::vector<StageTime> times_;
};

}  // namespace quadline
