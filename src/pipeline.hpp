#pragma once

#include <chrono>
#include <vector>

#include "domain/domain.hpp"
#include "fallback.hpp"
#include "quadline/context.hpp"
#include "quadline/generate.hpp"

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

/// A mesh, and where it breaks the promise.
struct Attempt {
  MeshResult result;              ///< without its report
  std::vector<Trouble> troubles;  ///< where `result.failure` is set; empty: no cell is to blame
  std::vector<Finding> findings;  ///< the cells that were not meshed as asked
};

/// Once through the stages, from the size field to the verifier.
///
/// @param plan    how each cell is meshed.
/// @param report  gets the times and the qualities.
/// @throws Cancelled when `context` asks for it; other errors of the stages are failures of the attempt.
Attempt attempt_mesh(const FallbackPlan& plan, const Options& options, Report& report, Context& context);

}  // namespace quadline
