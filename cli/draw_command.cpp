#include <optional>

#include "cli/commands.hpp"
#include "cli/files.hpp"
#include "io/text/atomic_file.hpp"
#include "quadline/errors.hpp"
#include "quadline/io/mesh_io.hpp"

namespace quadline {

int run(const DrawArguments& arguments) {
  const std::optional<MeshFile> output = find_mesh_file(arguments.output);
  if (!output || output->format != "svg")
    throw InputError(ErrorCode::UnknownFormat, "is no picture: use .svg", Where{arguments.output, {}, {}});
  refuse_overwriting(output->path, {arguments.mesh});
  check_can_write(output->path);
  write_mesh(read_mesh(arguments.mesh), *output);
  return kDone;
}

}  // namespace quadline
