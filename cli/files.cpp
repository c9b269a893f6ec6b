#include "cli/files.hpp"

#include <sys/stat.h>
#include <unistd.h>

#include <system_error>

#include "quadline/errors.hpp"

namespace quadline {

namespace fs = std::filesystem;

namespace {

bool is_one(const struct stat& a, const struct stat& b) { return a.st_dev == b.st_dev && a.st_ino == b.st_ino; }

}  // namespace

bool is_standard_output(const fs::path& file) {
  struct stat a{}, b{};
  return ::stat(file.c_str(), &a) == 0 && ::fstat(STDOUT_FILENO, &b) == 0 && is_one(a, b);
}

bool is_same_file(const fs::path& a, const fs::path& b) {
  struct stat own{}, other{};
  if (::stat(a.c_str(), &own) == 0 && ::stat(b.c_str(), &other) == 0)
    return is_one(own, other) && (!S_ISCHR(own.st_mode) || is_standard_output(a));
  std::error_code error;
  const fs::path at = fs::weakly_canonical(a, error);
  return !error && at == fs::weakly_canonical(b, error);
}

std::vector<fs::path> files_of_model(const fs::path& model) {
  std::vector<fs::path> files{model};
  if (model.extension() == ".poly") files.push_back(fs::path(model).replace_extension(".node"));
  return files;
}

void refuse_overwriting(const fs::path& output, const std::vector<fs::path>& inputs) {
  for (const fs::path& input : inputs)
    if (is_same_file(output, input))
      throw InputError(ErrorCode::InvalidOption, "would overwrite what is read from it: choose another name",
                       Where{output.string(), {}, {}});
}

}  // namespace quadline
