#include "io/read_model.hpp"

#include <fstream>
#include <iterator>
#include <string>

#include "io/read_model_formats.hpp"
#include "quadline/errors.hpp"

namespace quadline {

namespace {

std::string whole_file(const std::filesystem::path& file) {
  std::error_code error;
  if (std::filesystem::is_directory(file, error))
    throw InputError("is a directory, not a model file", {.file = file.string(), .place = {}, .point = {}});
  std::ifstream in(file, std::ios::binary);
  if (!in)
    throw InputError("cannot be opened: check the name and the rights",
                     {.file = file.string(), .place = {}, .point = {}});
  std::string text((std::istreambuf_iterator<char>(in)), std::istreambuf_iterator<char>());
  if (in.bad()) throw InputError("cannot be read", {.file = file.string(), .place = {}, .point = {}});
  return text;
}

}  // namespace

Model read_model(const std::filesystem::path& file) {
  const std::string extension = file.extension().string();
  if (extension == ".json") return read_model_json(whole_file(file), file.string());
  if (extension == ".poly") return read_model_poly(whole_file(file), file);
  throw InputError("unknown model format '" + extension + "': give a .json (model v1) or .poly file",
                   {.file = file.string(), .place = {}, .point = {}});
}

}  // namespace quadline
