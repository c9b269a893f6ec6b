#pragma once

#include <chrono>

#include "quadline/context.hpp"
#include "quadline/report.hpp"

namespace quadline {

/// Runs the stages by name and notes how long each took.
class StageClock {
 public:
  StageClock(Report& report, Context& context) : report_(report), context_(context) {}

  template <class Stage>
  auto run(const char* name, Stage stage) {
    context_.progress(name, 0);
    const auto start = std::chrono::steady_clock::now();
    struct Note {  // on the way out, whatever the stage returns
      Report& report;
      const char* name;
      std::chrono::steady_clock::time_point start;
      ~Note() {
        const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
        report.stages.push_back({name, elapsed.count()});
      }
    } note{report_, name, start};
    return stage();
  }

 private:
  Report& report_;
  Context& context_;
};

}  // namespace quadline
