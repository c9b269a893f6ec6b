#include "quadline/io/read_model.hpp"

#include <string>

#include "io/model_formats.hpp"
#include "io/text/read_bytes.hpp"
#include "quadline/errors.hpp"

namespace quadline {

Model read_model(const std::filesystem::path& file, std::optional<double> size) {
  std::string extension = file.extension().string();
  for (char& c : extension)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  if (extension == ".json") return read_model_json(read_bytes(file), file.string());
  if (extension == ".poly") {
    Model model = read_model_poly(read_bytes(file), file);
    // The areas are the file's only sizes: what overrides the model's size overrides them.
    for (Region& region : model.regions)
      if (size) region.size.reset();
    return model;
  }
  throw InputError(ErrorCode::UnknownFormat,
                   "the format '" + extension + "' is unknown: a model is a .json (model v1) or a .poly file",
                   Where{file.string(), {}, {}});
}

}  // namespace quadline
