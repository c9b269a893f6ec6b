// How to embed the mesher: build a model, choose sizes by place, watch and stop a run, use the flat arrays.
#include <algorithm>
#include <cstdio>
#include <string>
#include <string_view>

#include "quadline/quadline.hpp"

int main() {
  quadline::Model model;
  model.size = 0.4;
  model.outer = {{.items = {{{0, 0}}, {{6, 0}}, {{6, 4}}, {{0, 4}}}}};
  model.lines = {{.name = "stiffener", .path = {.items = {{{1, 2}}, {{5, 2}}}}}};

  // Finer towards the left edge.
  quadline::Options options;
  options.size_at = [](quadline::Point p) { return 0.1 + 0.1 * p.x; };

  // A program with a window would draw a bar here, and stop when a button is pressed.
  std::string stages;
  bool is_stopped = false;
  quadline::Context context;
  context.on_progress = [&](std::string_view stage, double) {
    if (!stages.ends_with(stage)) stages += (stages.empty() ? "" : ", ") + std::string(stage);
  };
  context.is_cancelled = [&] { return is_stopped; };

  try {
    const quadline::MeshResult result = quadline::generate(model, options, context);
    if (result.failure) {
      std::printf("no mesh: %s\n", result.failure->reason.c_str());
      return 3;
    }
    const auto [finest, coarsest] = std::minmax_element(result.edge_sizes.begin(), result.edge_sizes.end());
    std::printf("quadline %s: %s\n", quadline::kVersion, stages.c_str());
    std::printf("%zu quads, %zu edges along the stiffener, sizes from %.2f to %.2f\n", result.mesh.quads.size(),
                result.mesh.curves.back().edges.size(), *finest, *coarsest);
    is_stopped = true;
    quadline::generate(model, options, context);
  } catch (const quadline::Cancelled&) {
    std::printf("stopped when asked to\n");
  } catch (const quadline::InputError& error) {
    std::printf("%s: %s\n", quadline::name_of(error.code()), error.what());
    return 2;
  }
  return 0;
}
