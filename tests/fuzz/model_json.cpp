// Model JSON: a model, or an InputError.
#include <cstddef>
#include <cstdint>

#include "io/model_formats.hpp"
#include "quadline/errors.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    quadline::read_model_json({reinterpret_cast<const char*>(data), size}, "fuzz.json");
  } catch (const quadline::InputError&) {
  }
  return 0;
}
