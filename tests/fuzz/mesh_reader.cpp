// All mesh readers, on the same bytes: a mesh, or an InputError.
#include <cstddef>
#include <cstdint>

#include "io/mesh_formats.hpp"
#include "quadline/errors.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace quadline;
  for (const auto parse : {parse_msh, parse_vtu, parse_vtk, parse_inp, parse_mesh_json}) {
    try {
      parse({reinterpret_cast<const char*>(data), size}, "fuzz");
    } catch (const InputError&) {
    }
  }
  return 0;
}
