// The whole pipeline on stiffened panels of growing size; `items_per_second` is quads per second.
#include <benchmark/benchmark.h>

#include <cmath>
#include <string>

#include "quadline/generate.hpp"

namespace {

using namespace quadline;

// Bays of 800 by 800 between through stiffeners, an opening in every third, a short carling in every fifth.
Model panel(double quads) {
  const int n = std::max(2, static_cast<int>(std::lround(std::sqrt(quads / 64))));
  const double bay = 800, side = n * bay;
  Model m;
  m.size = side / std::sqrt(quads);
  m.outer = {
      {.items = {{{0, 0}, {}}, {{side, 0}, {}}, {{side, side}, {}}, {{0, side}, {}}}, .circle = {}, .where = "outer"}};
  const auto line = [&](Point a, Point b) {
    m.lines.push_back({.name = "line-" + std::to_string(m.lines.size()),
                       .path = {.items = {{a, {}}, {b, {}}}, .circle = {}, .where = {}},
                       .size = {}});
  };
  for (int i = 1; i < n; ++i) line({0, i * bay}, {side, i * bay});
  for (int i = 3; i < n; i += 3) line({i * bay, 0}, {i * bay, side});
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      const Point centre{(i + 0.5) * bay, (j + 0.5) * bay};
      if ((i + j) % 3 == 0) m.holes.push_back({.items = {}, .circle = Circle{centre, 150}, .where = "hole"});
      if ((i + 2 * j) % 5 == 4 && (i + j) % 3 != 0) line({centre.x, j * bay}, centre);
    }
  return m;
}

void pipeline(benchmark::State& state) {
  const Model model = panel(static_cast<double>(state.range(0)));
  std::size_t quads = 0;
  for (auto _ : state) {
    Context context;
    quads += generate(model, {}, context).mesh.quads.size();
  }
  state.SetItemsProcessed(static_cast<std::int64_t>(quads));
}
BENCHMARK(pipeline)->RangeMultiplier(10)->Range(1000, 100000)->Unit(benchmark::kMillisecond);

}  // namespace
