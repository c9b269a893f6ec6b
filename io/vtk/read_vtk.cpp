// Legacy VTK files [VTKFormats], versions 2 to 5, text and binary: points and cells of an unstructured grid.

#include <algorithm>
#include <bit>
#include <iterator>

#include "io/mesh_formats.hpp"
#include "io/text/cursor.hpp"
#include "io/vtk/vtk_data.hpp"

namespace quadline {
namespace {

class Reader {
 public:
  explicit Reader(const SourceFile& file) : file_(file), in_(file) {}
  Mesh read();

 private:
  void read_head();
  void read_points();
  void read_cells();
  void skip_metadata();
  void skip_fields();
  std::size_t count();  ///< of things of which each takes a byte at least
  std::vector<std::int64_t> integers(std::size_t n, std::string_view type);
  void build();

  const SourceFile& file_;
  Cursor in_;
  bool binary_ = false;
  int version_ = 0;
  std::vector<std::int64_t> connectivity_, offsets_, types_;
  FoundMesh found_;
};

std::size_t Reader::count() {
  const auto n = in_.number<std::int64_t>();
  if (n < 0 || static_cast<std::uint64_t>(n) > in_.left())
    in_.fail("a count of " + std::to_string(n) + " is more than the file holds");
  return static_cast<std::size_t>(n);
}

std::vector<std::int64_t> Reader::integers(std::size_t n, std::string_view type) {
  const bool wide = type == "vtktypeint64" || type == "long";
  if (!wide && type != "vtktypeint32" && type != "int")
    in_.fail("numbers of type '" + std::string(type.substr(0, 20)) + "' are not read here");
  in_.line();
  std::vector<std::int64_t> out(n);
  for (auto& value : out)
    value = !binary_ ? in_.number<std::int64_t>() : wide ? in_.raw<std::int64_t>() : in_.raw<std::int32_t>();
  return out;
}

void Reader::read_head() {
  constexpr std::string_view kMark = "# vtk DataFile Version ";
  const std::string_view mark = in_.line();
  if (mark.size() <= kMark.size()) in_.fail("the version is missing");
  version_ = mark[kMark.size()] - '0';
  in_.line();  // title
  const std::string_view kind = in_.next_word();
  if (kind != "ASCII" && kind != "BINARY") in_.fail("ASCII or BINARY was expected");
  binary_ = kind == "BINARY";
  in_.set_binary(binary_);
  in_.set_swapped(std::endian::native == std::endian::little);  // the files are big-endian
  if (in_.next_word() != "DATASET" || in_.next_word() != "UNSTRUCTURED_GRID")
    in_.fail("DATASET UNSTRUCTURED_GRID was expected");
}

void Reader::read_points() {
  const std::size_t n = count();
  const std::string_view type = in_.next_word();
  if (type != "double" && type != "float") in_.fail("points must be of type double or float");
  in_.line();
  const auto value = [&] {
    return !binary_ ? in_.number<double>() : type == "double" ? in_.raw<double>() : in_.raw<float>();
  };
  for (std::size_t i = 0; i < n; ++i) {
    const double x = value(), y = value();
    found_.mesh.points.push_back({x, y});
    found_.z.push_back(value());
  }
}

/// Since version 5 offsets and nodes are arrays of their own; before, each cell starts with the number of its nodes.
void Reader::read_cells() {
  const std::size_t n = count(), size = count();
  if (version_ >= 5) {
    if (in_.next_word() != "OFFSETS") in_.fail("OFFSETS was expected");
    offsets_ = integers(n, in_.next_word());
    if (in_.next_word() != "CONNECTIVITY") in_.fail("CONNECTIVITY was expected");
    connectivity_ = integers(size, in_.next_word());
    return;
  }
  const std::vector<std::int64_t> values = integers(size, "int");
  offsets_ = {0};
  for (std::size_t i = 0; i < values.size();) {
    const std::int64_t n_nodes = values[i++];
    if (n_nodes < 0 || static_cast<std::uint64_t>(n_nodes) > values.size() - i) in_.fail("a cell has too many nodes");
    for (std::int64_t j = 0; j < n_nodes; ++j) connectivity_.push_back(values[i++]);
    offsets_.push_back(static_cast<std::int64_t>(connectivity_.size()));
  }
  if (offsets_.size() != n + 1) in_.fail("the number of cells is wrong");
}

/// What VTK notes about an array; an empty line ends it.
void Reader::skip_metadata() {
  in_.line();
  while (in_.left() > 0 && !in_.line().empty()) continue;
}

/// Data on the whole mesh.
void Reader::skip_fields() {
  struct Width {
    const char* type;
    std::size_t bytes;
  };
  static constexpr Width kWidths[] = {{"double", 8}, {"float", 4}, {"long", 8},         {"vtktypeint64", 8},
                                      {"int", 4},    {"short", 2}, {"vtktypeint32", 4}, {"unsigned_char", 1}};
  in_.next_word();  // name of the whole
  for (std::size_t n_arrays = count(); n_arrays > 0;) {
    if (in_.next_word() == "METADATA") {  // belongs to the array before
      skip_metadata();
      continue;
    }
    const std::size_t n_components = count(), n_tuples = count();
    const std::string_view type = in_.next_word();
    const auto width =
        std::find_if(std::begin(kWidths), std::end(kWidths), [&](const Width& w) { return w.type == type; });
    if (width == std::end(kWidths)) in_.fail("arrays of type '" + std::string(type.substr(0, 20)) + "' are not read");
    in_.line();
    if (n_components > 0 && n_tuples > in_.left() / n_components / (binary_ ? width->bytes : 1))
      in_.fail("the file ends too early");
    const std::size_t n = n_components * n_tuples;
    if (binary_) in_.move_to(in_.at() + n * width->bytes);
    for (std::size_t i = 0; !binary_ && i < n; ++i) in_.next_word();
    --n_arrays;
  }
}

void Reader::build() {
  Mesh& mesh = found_.mesh;
  if (offsets_.size() != types_.size() + 1) file_.fail("cells and cell types differ in number");
  for (std::size_t i = 0; i < types_.size(); ++i) {
    const std::int64_t start = offsets_[i], end = offsets_[i + 1];
    if (start < 0 || end < start || static_cast<std::uint64_t>(end) > connectivity_.size())
      file_.fail("the offset " + std::to_string(end) + " is wrong");
    const VtkCellNodes cell{types_[i], connectivity_.data() + start, static_cast<std::size_t>(end - start)};
    const auto n = checked_nodes(cell, 0, mesh.points.size(), file_);
    if (types_[i] == kVtkQuad) mesh.quads.push_back(n);
    if (types_[i] == kVtkTriangle) mesh.triangles.push_back({n[0], n[1], n[2]});
  }
  mesh.regions = {"domain"};
  mesh.quad_region.assign(mesh.quads.size(), 0);
  mesh.triangle_region.assign(mesh.triangles.size(), 0);
}

Mesh Reader::read() {
  read_head();
  for (bool has_types = false; !has_types;) {
    const std::string_view keyword = in_.next_word();
    if (keyword == "POINTS") {
      read_points();
    } else if (keyword == "CELLS") {
      read_cells();
    } else if (keyword == "CELL_TYPES") {
      types_ = integers(count(), "int");
      has_types = true;  // data on points and cells may follow
    } else if (keyword == "METADATA") {
      skip_metadata();
    } else if (keyword == "FIELD") {
      skip_fields();
    } else {
      in_.fail("POINTS, CELLS or CELL_TYPES was expected");
    }
  }
  build();
  return plane_mesh(std::move(found_), file_);
}

}  // namespace

Mesh parse_vtk(std::string_view bytes, const std::string& file) {
  const SourceFile source{bytes, file};
  return Reader(source).read();
}

}  // namespace quadline
