#include "base/check.hpp"
#include "draw/svg.hpp"
#include "io/atomic_file.hpp"
#include "io/mesh_formats.hpp"
#include "io/mesh_io.hpp"

namespace quadline {
namespace {

struct Format {
  const char* extension;
  std::string (*to_bytes)(const Mesh& mesh);
};
constexpr Format kFormats[] = {
    {".vtu", to_vtu}, {".msh", to_msh}, {".inp", to_inp}, {".svg", to_svg}, {".json", to_mesh_json},
};

std::string lower_case_extension(const std::filesystem::path& file) {
  std::string extension = file.extension().string();
  for (char& c : extension)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return extension;
}

const Format* format_of(const std::filesystem::path& file) {
  const std::string extension = lower_case_extension(file);
  for (const Format& format : kFormats)
    if (extension == format.extension) return &format;
  return nullptr;
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

bool is_mesh_format(const std::filesystem::path& file) { return format_of(file) != nullptr; }

void write_mesh(const Mesh& mesh, const std::filesystem::path& file) {
  const Format* format = format_of(file);
  if (!format)
    throw InputError("unknown mesh format '" + file.extension().string() + "': use .vtu, .msh, .inp, .svg or .json",
                     Where{.file = file.string(), .place = {}, .point = {}});
  check_arrays(mesh);
  write_atomically(file, format->to_bytes(mesh));
}

}  // namespace quadline
