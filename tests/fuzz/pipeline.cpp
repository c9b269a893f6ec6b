// The whole pipeline on a few lines, holes and points: a mesh, a Failure with a reason, or an InputError.
#include <cstdlib>

#include "decode.hpp"
#include "quadline/errors.hpp"
#include "quadline/generate.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace quadline;
  const Model model = decode_model(data, size, 6);
  Context context;
  try {
    const MeshResult result = generate(model, {}, context);
    if (result.failure && (result.failure->stage == "internal" || result.failure->reason.empty())) std::abort();
  } catch (const InputError&) {
  }
  return 0;
}
