// The whole pipeline on models of growing size. `items_per_second` is quads per second; the other columns are the
// microseconds that each stage takes for a quad. A stage that is near-linear keeps its figure from line to line.
#include <benchmark/benchmark.h>

#include <map>
#include <string>

#include "quadline/generate.hpp"
#include "scale_models.hpp"

namespace {

void pipeline(benchmark::State& state, quadline::Model (*make)(double)) {
  const quadline::Model model = make(static_cast<double>(state.range(0)));
  std::size_t quads = 0;
  std::map<std::string, double> elapsed_s;
  for (auto _ : state) {
    quadline::Context context;
    const quadline::MeshResult result = quadline::generate(model, {}, context);
    if (result.failure) return state.SkipWithError(result.failure->reason.c_str());
    quads += result.mesh.quads.size();
    for (const quadline::StageTime& time : result.report.stages) elapsed_s[time.stage] += time.elapsed_s;
  }
  state.SetItemsProcessed(static_cast<std::int64_t>(quads));
  for (const auto& [stage, seconds] : elapsed_s) state.counters[stage] = 1e6 * seconds / static_cast<double>(quads);
}

BENCHMARK_CAPTURE(pipeline, panel, quadline::panel)
    ->RangeMultiplier(10)
    ->Range(1000, 100000)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(pipeline, lines, quadline::random_lines)
    ->RangeMultiplier(10)
    ->Range(1000, 100000)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(pipeline, plain, quadline::plain)
    ->RangeMultiplier(10)
    ->Range(1000, 100000)
    ->Unit(benchmark::kMillisecond);

}  // namespace
