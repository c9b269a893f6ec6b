// The whole pipeline on a few lines, holes and points: a mesh that is sound and covers the domain, a Failure with a
// reason, or an InputError.
#include <cmath>
#include <cstdlib>

#include "decode.hpp"
#include "quadline/errors.hpp"
#include "quadline/generate.hpp"
#include "tests/shared/invariants.hpp"

namespace {

using namespace quadline;

/// The area outside all holes, which are rectangles of whole squares on the grid of 8 by 8 that is the plate.
int area_of(const Model& model) {
  int area = 0;
  for (int x = 0; x < 8; ++x)
    for (int y = 0; y < 8; ++y) {
      bool is_cut = false;
      for (const Path& hole : model.holes) {
        const Point a = hole.items[0].to, b = hole.items[2].to, p{x + 0.5, y + 0.5};
        is_cut |= (a.x < p.x) != (b.x < p.x) && (a.y < p.y) != (b.y < p.y);
      }
      area += !is_cut;
    }
  return area;
}

double area_of(const Mesh& mesh) {
  double area = 0;
  for (const auto& [a, b, c, d] : mesh.quads) {
    const auto& p = mesh.points;
    area += 0.5 * cross(p[c] - p[a], p[d] - p[b]);
  }
  return area;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const Model model = decode_model(data, size, 6);
  Context context;
  try {
    const MeshResult result = generate(model, {}, context);
    if (result.failure) {
      if (result.failure->stage == "internal" || result.failure->reason.empty()) std::abort();
    } else if (!broken(result.mesh).empty() || std::fabs(area_of(result.mesh) - area_of(model)) > 1e-9) {
      std::abort();
    }
  } catch (const InputError&) {
  }
  return 0;
}
