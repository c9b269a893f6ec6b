#include <optional>
#include <string_view>

#include "base/check.hpp"
#include "io/mesh_formats.hpp"
#include "io/svg/svg.hpp"
#include "io/text/atomic_file.hpp"
#include "quadline/errors.hpp"
#include "quadline/io/mesh_io.hpp"

namespace quadline {
namespace {

struct Format {
  std::string_view name;
  std::string (*to_bytes)(const Mesh& mesh);
};
constexpr Format kFormats[] = {
    {"vtu", to_vtu}, {"msh", to_msh}, {"inp", to_inp}, {"svg", to_svg}, {"json", to_mesh_json},
};

const Format* format_of(std::string_view name) {
  for (const Format& format : kFormats)
    if (name == format.name) return &format;
  return nullptr;
}

std::string lower_case(std::string text) {
  for (char& c : text)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return text;
}

template <class Elements>
bool all_below(const Elements& elements, std::size_t n_nodes) {
  for (const auto& element : elements)
    for (const NodeIndex node : element)
      if (node >= n_nodes) return false;
  return true;
}

bool all_below(const std::vector<std::uint32_t>& values, std::size_t bound) {
  for (const std::uint32_t value : values)
    if (value >= bound) return false;
  return true;
}

/// The arrays fit each other: the writers rely on it.
void check_arrays(const Mesh& mesh) {
  const std::size_t n = mesh.points.size();
  QUADLINE_CHECK(mesh.quad_region.size() == mesh.quads.size());
  QUADLINE_CHECK(mesh.triangle_region.size() == mesh.triangles.size());
  QUADLINE_CHECK(all_below(mesh.quad_region, mesh.regions.size()));
  QUADLINE_CHECK(all_below(mesh.triangle_region, mesh.regions.size()));
  QUADLINE_CHECK(all_below(mesh.quads, n) && all_below(mesh.triangles, n));
  for (const EdgeSet& curve : mesh.curves) QUADLINE_CHECK(all_below(curve.edges, n));
  for (const NodeSet& set : mesh.node_sets) QUADLINE_CHECK(all_below(set.nodes, n));
}

}  // namespace

std::optional<MeshFile> find_mesh_file(const std::string& text) {
  const std::size_t colon = text.find(':');
  if (colon != text.npos && format_of(text.substr(0, colon)))
    return MeshFile{text.substr(colon + 1), text.substr(0, colon)};
  const std::filesystem::path path = text;
  const std::string extension = path.extension().string();
  const std::string format = lower_case(extension.substr(extension.empty() ? 0 : 1));
  if (format_of(format)) return MeshFile{path, format};
  return std::nullopt;
}

MeshFile mesh_file(const std::string& text) {
  if (const std::optional<MeshFile> file = find_mesh_file(text)) {
    if (file->path.empty())
      throw InputError(ErrorCode::InvalidOption, "no file is named behind the format", Where{text, {}, {}});
    return *file;
  }
  if (text.empty()) throw InputError(ErrorCode::InvalidOption, "the name of a file to write is empty");
  const std::string extension = std::filesystem::path(text).extension().string();
  throw InputError(ErrorCode::UnknownFormat,
                   "the format '" + extension + "' is unknown: use .vtu, .msh, .inp, .svg or .json" +
                       (extension.empty() ? ", or name the format: vtu:" + text : ""),
                   Where{text, {}, {}});
}

void write_mesh(const Mesh& mesh, const MeshFile& file) {
  const Format* format = format_of(file.format);
  QUADLINE_CHECK(format);
  check_arrays(mesh);
  write_atomically(file.path, format->to_bytes(mesh));
}

}  // namespace quadline
