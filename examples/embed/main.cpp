// How to embed the mesher: build a model, mesh it, use the flat arrays.
#include <cstdio>

#include "quadline/generate.hpp"

int main() {
  quadline::Model model;
  model.size = 0.2;
  model.outer = {{.items = {{{0, 0}}, {{6, 0}}, {{6, 4}}, {{0, 4}}}}};
  model.lines = {{.name = "stiffener", .path = {.items = {{{1, 2}}, {{5, 2}}}}}};
  quadline::Context context;
  try {
    const quadline::MeshResult result = quadline::generate(model, {}, context);
    if (result.failure) {
      std::printf("no mesh: %s\n", result.failure->reason.c_str());
      return 3;
    }
    std::printf("%zu quads, %zu edges along the stiffener\n", result.mesh.quads.size(),
                result.mesh.curves.back().edges.size());
  } catch (const quadline::InputError& error) {
    std::printf("%s\n", error.what());
    return 2;
  }
  return 0;
}
