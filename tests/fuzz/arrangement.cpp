// Arrangement, nodes on curves and triangulation on a small whole-number grid, where everything meets everything.
#include "decode.hpp"
#include "domain/arrange/arrange.hpp"
#include "domain/size/size_field.hpp"
#include "mesh/work_mesh.hpp"
#include "quadline/errors.hpp"
#include "stages/discretize/discretize.hpp"
#include "stages/triangulate/triangulate.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace quadline;
  const Model model = decode_model(data, size, 12);
  Context context;
  try {
    const Domain domain = arrange(model, {}, context);
    const SizeField sizes = make_size_field(domain, {}, context);
    WorkMesh mesh = discretize(domain, sizes, {}, {}, context);
    triangulate(mesh, domain, context);
  } catch (const InputError&) {
  }
  return 0;
}
