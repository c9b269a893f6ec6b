// VTK XML unstructured grids [VTKFormats]: text, base64 and raw arrays, compressed with zlib or not. The names are
// found where write_vtu.cpp puts them.

#include <bit>
#include <pugixml.hpp>

#include "io/found/found_mesh.hpp"
#include "io/mesh_formats.hpp"
#include "io/text/cursor.hpp"
#include "io/vtk/vtk_data.hpp"

namespace quadline {
namespace {

class Reader {
 public:
  explicit Reader(const SourceFile& file) : file_(file) {}
  Mesh read();

 private:
  void parse_xml();
  void read_encoding(const pugi::xml_node& root);
  void read_names(const pugi::xml_node& field_data);
  void read_piece(const pugi::xml_node& piece);
  template <class T>
  std::vector<T> values(const pugi::xml_node& array);
  std::vector<std::int64_t> cell_values(const pugi::xml_node& piece, const char* name, std::size_t n_cells);
  struct Tags {
    std::int64_t region, curve, point;  ///< -1: none
  };
  void add_cell(std::int64_t type, const std::array<NodeIndex, 4>& n, const Tags& tags);
  [[noreturn]] void fail(const pugi::xml_node& at, const std::string& message) const {
    file_.fail_at_byte(static_cast<std::size_t>(std::max<std::ptrdiff_t>(at.offset_debug(), 0)), message);
  }

  /// Bytes that the arrays may still take: many array tags may point at the same bytes, and a few bytes may claim to
  /// inflate to a thousand times as many; meshes hardly to ten times.
  std::size_t allowance() const {
    constexpr std::size_t kMostInflation = 64, kSmall = std::size_t{1} << 20;
    const std::size_t all =
        encoding_.compressed ? kMostInflation * file_.bytes.size() + kSmall : 2 * file_.bytes.size();
    return all - std::min(all, n_decoded_);
  }
  std::size_t declared(const pugi::xml_node& piece, const char* name) const;

  const SourceFile& file_;
  pugi::xml_document document_;
  std::size_t appended_at_ = 0;  ///< offset of the appended data, behind its underscore; 0: none
  bool appended_base64_ = false;
  VtkEncoding encoding_;
  std::size_t n_decoded_ = 0;  ///< bytes of all arrays so far
  FoundMesh found_;
};

/// Appended raw bytes are no XML: they are cut off first.
void Reader::parse_xml() {
  std::string_view xml = file_.bytes;
  std::string closed;
  const std::size_t tag = xml.find("<AppendedData");
  if (tag != xml.npos) {
    const std::size_t end = xml.find('>', tag);
    if (end == xml.npos) file_.fail_at_byte(tag, "the file ends too early");
    const std::size_t mark = xml.find('_', end);
    if (mark == xml.npos) file_.fail_at_byte(end, "the appended data lack their underscore");
    appended_at_ = mark + 1;
    closed = std::string(xml.substr(0, end + 1)) + "</AppendedData></VTKFile>";
    xml = closed;
  }
  const pugi::xml_parse_result result = document_.load_buffer(xml.data(), xml.size());
  if (!result) file_.fail_at_byte(static_cast<std::size_t>(result.offset), std::string("XML: ") + result.description());
}

void Reader::read_encoding(const pugi::xml_node& root) {
  const std::string_view order = root.attribute("byte_order").as_string();
  const bool is_little = std::endian::native == std::endian::little;
  encoding_.swapped = order == (is_little ? "BigEndian" : "LittleEndian");
  encoding_.wide_headers = root.attribute("header_type").as_string() == std::string_view("UInt64");
  const std::string_view compressor = root.attribute("compressor").as_string();
  encoding_.compressed = !compressor.empty();
  if (encoding_.compressed && compressor != "vtkZLibDataCompressor")
    fail(root, "compressor '" + std::string(compressor) + "' is not read: zlib is");
  appended_base64_ = root.child("AppendedData").attribute("encoding").as_string() == std::string_view("base64");
}

template <class T>
std::vector<T> Reader::values(const pugi::xml_node& array) {
  const std::string_view format = array.attribute("format").as_string("ascii");
  const std::string_view type = array.attribute("type").as_string();
  const auto at = static_cast<std::size_t>(std::max<std::ptrdiff_t>(array.offset_debug(), 0));
  if (format == "ascii") {
    const SourceFile text{array.text().get(), file_.name};
    Cursor words(text);
    std::vector<T> out;
    for (std::string_view word = words.next_word(); !word.empty(); word = words.next_word()) {
      const auto value = parse_number<T>(word);
      if (!value) fail(array, "a number was expected, not '" + std::string(word.substr(0, 40)) + "'");
      out.push_back(*value);
    }
    return out;
  }
  std::string bytes;
  if (format == "appended") {
    const std::size_t offset = array.attribute("offset").as_ullong();
    if (appended_at_ == 0 || offset > file_.bytes.size() - appended_at_) fail(array, "the array's offset is wrong");
    const std::size_t start = appended_at_ + offset;
    bytes = vtk_binary(file_.bytes.substr(start), appended_base64_, encoding_, allowance(), file_, start);
  } else if (format == "binary") {
    bytes = vtk_binary(array.text().get(), true, encoding_, allowance(), file_, at);
  } else {
    fail(array, "array format '" + std::string(format) + "' is not read");
  }
  n_decoded_ += bytes.size();
  return vtk_values<T>(bytes, type, encoding_.swapped, file_, at);
}

pugi::xml_node array_named(const pugi::xml_node& parent, const char* name) {
  return parent.find_child_by_attribute("DataArray", "Name", name);
}

/// "line/stringer-7" with the value 3 names curve 3. Values must count up: other arrays are not ours.
void Reader::read_names(const pugi::xml_node& field_data) {
  Mesh& mesh = found_.mesh;
  for (const pugi::xml_node& array : field_data.children("DataArray")) {
    const std::string name = array.attribute("Name").as_string();
    const std::size_t slash = name.find('/');
    if (slash == std::string::npos) continue;
    const std::string kind = name.substr(0, slash), own = name.substr(slash + 1);
    const std::vector<std::int64_t> value = values<std::int64_t>(array);
    const auto is_next = [&](std::size_t count) {
      return value.size() == 1 && value[0] == static_cast<std::int64_t>(count);
    };
    if (kind == "region" && is_next(mesh.regions.size())) {
      mesh.regions.push_back(own);
    } else if (kind == "point" && is_next(mesh.node_sets.size())) {
      mesh.node_sets.push_back({own, {}});
    } else if ((kind == "outer" || kind == "hole" || kind == "line") && is_next(mesh.curves.size())) {
      mesh.curves.push_back({own, CurveKind::Line, {}});
    }
  }
}

std::vector<std::int64_t> Reader::cell_values(const pugi::xml_node& piece, const char* name, std::size_t n_cells) {
  const pugi::xml_node array = array_named(piece.child("CellData"), name);
  std::vector<std::int64_t> out;
  if (array) out = values<std::int64_t>(array);
  if (!array || out.size() != n_cells) out.assign(n_cells, -1);
  return out;
}

void Reader::add_cell(std::int64_t type, const std::array<NodeIndex, 4>& n, const Tags& tags) {
  Mesh& mesh = found_.mesh;
  const auto is_known = [](std::int64_t id, std::size_t count) {
    return id >= 0 && static_cast<std::uint64_t>(id) < count;
  };
  const auto region = static_cast<std::uint32_t>(is_known(tags.region, mesh.regions.size()) ? tags.region : 0);
  switch (type) {
    case kVtkVertex:
      if (is_known(tags.point, mesh.node_sets.size())) mesh.node_sets[tags.point].nodes.push_back(n[0]);
      break;
    case kVtkLine:
      if (is_known(tags.curve, mesh.curves.size())) mesh.curves[tags.curve].edges.push_back({n[0], n[1]});
      break;
    case kVtkTriangle:
      mesh.triangles.push_back({n[0], n[1], n[2]});
      mesh.triangle_region.push_back(region);
      break;
    default:
      mesh.quads.push_back(n);
      mesh.quad_region.push_back(region);
  }
}

std::size_t Reader::declared(const pugi::xml_node& piece, const char* name) const {
  const auto count = parse_number<std::int64_t>(piece.attribute(name).as_string());
  if (!count || *count < 0) fail(piece, std::string(name) + " is missing, or is no count");
  return static_cast<std::size_t>(*count);
}

void Reader::read_piece(const pugi::xml_node& piece) {
  const std::size_t first_node = found_.z.size();
  const std::vector<double> xyz = values<double>(piece.child("Points").child("DataArray"));
  if (xyz.size() % 3 != 0) fail(piece, "points must have three coordinates");
  if (xyz.size() / 3 != declared(piece, "NumberOfPoints"))
    fail(piece, "NumberOfPoints is not the number of its points, " + std::to_string(xyz.size() / 3));
  for (std::size_t i = 0; i < xyz.size(); i += 3) {
    found_.mesh.points.push_back({xyz[i], xyz[i + 1]});
    found_.z.push_back(xyz[i + 2]);
  }
  const pugi::xml_node cells = piece.child("Cells");
  const auto connectivity = values<std::int64_t>(array_named(cells, "connectivity"));
  const auto offsets = values<std::int64_t>(array_named(cells, "offsets"));
  const auto types = values<std::int64_t>(array_named(cells, "types"));
  if (types.size() != offsets.size()) fail(cells, "offsets and types differ in number");
  if (types.size() != declared(piece, "NumberOfCells"))
    fail(piece, "NumberOfCells is not the number of its cells, " + std::to_string(types.size()));
  const auto region = cell_values(piece, "region", types.size());
  const auto curve = cell_values(piece, "curve", types.size());
  const auto point = cell_values(piece, "point", types.size());
  std::int64_t start = 0;
  for (std::size_t i = 0; i < types.size(); ++i) {
    const std::int64_t end = offsets[i];
    if (end < start || static_cast<std::uint64_t>(end) > connectivity.size())
      fail(cells, "offset " + std::to_string(end) + " is wrong");
    const VtkCellNodes cell{types[i], connectivity.data() + start, static_cast<std::size_t>(end - start)};
    const auto nodes = checked_nodes(cell, first_node, found_.z.size() - first_node, file_);
    add_cell(types[i], nodes, {region[i], curve[i], point[i]});
    start = end;
  }
}

Mesh Reader::read() {
  parse_xml();
  const pugi::xml_node root = document_.child("VTKFile");
  const pugi::xml_node grid = root.child("UnstructuredGrid");
  if (!grid) file_.fail("no VTK unstructured grid in it");
  read_encoding(root);
  read_names(grid.child("FieldData"));
  if (found_.mesh.regions.empty()) found_.mesh.regions.push_back("domain");
  for (const pugi::xml_node& piece : grid.children("Piece")) read_piece(piece);
  return plane_mesh(std::move(found_), file_);
}

}  // namespace

Mesh parse_vtu(std::string_view bytes, const std::string& file) {
  const SourceFile source{bytes, file};
  return Reader(source).read();
}

}  // namespace quadline
