#include "cli/commands.hpp"
#include "io/atomic_file.hpp"
#include "io/mesh_io.hpp"
#include "quadline/errors.hpp"

namespace quadline {

int run(const DrawArguments& arguments) {
  std::string extension = arguments.output.extension().string();
  if (extension != ".svg" && extension != ".SVG")
    throw InputError("the format '" + extension + "' is unknown: use .svg", Where{arguments.output.string(), {}, {}});
  check_can_write(arguments.output);
  write_mesh(read_mesh(arguments.mesh), arguments.output);
  return kDone;
}

}  // namespace quadline
