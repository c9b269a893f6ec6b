#include <fstream>
#include <vector>

#include "io/found_mesh.hpp"
#include "io/mesh_formats.hpp"
#include "io/mesh_io.hpp"

namespace quadline {
namespace {

std::string bytes_of(const std::filesystem::path& file) {
  const Where where{file.string(), {}, {}};
  std::error_code error;
  if (std::filesystem::is_directory(file, error)) throw InputError("is a folder, not a mesh", where);
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw InputError("cannot be opened", where);
  std::string bytes;
  for (std::vector<char> piece(1 << 20); stream;) {
    stream.read(piece.data(), static_cast<std::streamsize>(piece.size()));
    bytes.append(piece.data(), static_cast<std::size_t>(stream.gcount()));
  }
  if (stream.bad()) throw InputError("cannot be read", where);
  return bytes;
}

}  // namespace

/// The format follows what the file holds: extensions lie (a .json may be a model, a .msh comes from many programs).
Mesh read_mesh(const std::filesystem::path& file) {
  const std::string bytes = bytes_of(file);
  const std::string name = file.string();
  const std::string_view all = bytes;
  const std::size_t start = all.find_first_not_of(" \t\r\n");
  if (start == all.npos) SourceFile{all, name}.fail("the file is empty");
  const auto begins_with = [&](std::string_view text) { return all.substr(start, text.size()) == text; };
  if (begins_with("$MeshFormat")) return parse_msh(all, name);
  if (begins_with("<?xml") || begins_with("<VTKFile")) return parse_vtu(all, name);
  if (begins_with("{")) return parse_mesh_json(all, name);
  if (begins_with("*")) return parse_inp(all, name);
  SourceFile{all, name}.fail("no mesh that can be read: .vtu, .msh (2.2 and 4.1), .inp and .json can");
}

}  // namespace quadline
