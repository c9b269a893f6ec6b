#include "io/found/found_mesh.hpp"
#include "io/mesh_formats.hpp"
#include "io/text/read_bytes.hpp"
#include "quadline/io/mesh_io.hpp"

namespace quadline {

/// The format follows what the file holds: extensions lie (a .json may be a model, a .msh comes from many programs).
Mesh read_mesh(const std::filesystem::path& file) {
  const std::string bytes = read_bytes(file);
  const std::string name = file.string();
  const std::string_view all = bytes;
  const std::size_t start = all.find_first_not_of(" \t\r\n\xEF\xBB\xBF");  // a byte order mark as well
  if (start == all.npos) SourceFile{all, name}.fail("the file is empty");
  const auto begins_with = [&](std::string_view text) { return all.substr(start, text.size()) == text; };
  if (begins_with("$MeshFormat")) return parse_msh(all, name);
  if (begins_with("<?xml") || begins_with("<VTKFile")) return parse_vtu(all, name);
  if (begins_with("# vtk")) return parse_vtk(all, name);
  if (begins_with("{")) return parse_mesh_json(all, name);
  if (begins_with("*")) return parse_inp(all, name);
  SourceFile{all, name}.fail("no mesh that can be read: .vtu, .vtk, .msh (2.2 and 4.1), .inp and .json can",
                             ErrorCode::UnknownFormat);
}

}  // namespace quadline
