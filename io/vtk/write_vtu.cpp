// VTK XML unstructured grid [VTKFormats]: one piece, arrays appended raw in blocks that are compressed by themselves.
//
// Names stand in the field data as one-element arrays "line/stringer-7" = 3, where 3 is the value of "curve" on the
// cells of that line. Arrays of strings would be plainer, but readers outside VTK (meshio) refuse files that hold one.

#include <libdeflate.h>

#include <bit>
#include <cstring>
#include <limits>
#include <memory>
#include <new>

#include "base/utf8.hpp"
#include "io/mesh_formats.hpp"
#include "io/text/names.hpp"
#include "io/text/number_text.hpp"
#include "io/vtk/vtk_data.hpp"
#include "quality/face_corners.hpp"

namespace quadline {
namespace {

constexpr std::size_t kBlockBytes = 1 << 20;
constexpr int kCompressionLevel = 1;  // higher levels cost much more time than they save bytes

/// The arrays behind the XML header.
class Appended {
 public:
  Appended() : compressor_(libdeflate_alloc_compressor(kCompressionLevel)) {
    if (!compressor_) throw std::bad_alloc();
  }

  /// Adds an array: a header of 8-byte counts, then the compressed blocks. Returns its offset.
  template <class T>
  std::size_t add(const std::vector<T>& values) {
    const std::size_t offset = bytes_.size();
    const char* const data = reinterpret_cast<const char*>(values.data());
    const std::size_t size = values.size() * sizeof(T);
    const std::size_t n_blocks = (size + kBlockBytes - 1) / kBlockBytes;
    std::vector<std::uint64_t> head = {n_blocks, kBlockBytes, size % kBlockBytes};
    head.resize(3 + n_blocks);
    bytes_.resize(offset + head.size() * sizeof head[0]);
    for (std::size_t i = 0; i < n_blocks; ++i)
      head[3 + i] = add_block(data + i * kBlockBytes, std::min(kBlockBytes, size - i * kBlockBytes));
    std::memcpy(bytes_.data() + offset, head.data(), head.size() * sizeof head[0]);
    return offset;
  }

  const std::string& bytes() const { return bytes_; }

 private:
  std::size_t add_block(const char* data, std::size_t size) {
    const std::size_t start = bytes_.size();
    const std::size_t bound = libdeflate_zlib_compress_bound(compressor_.get(), size);
    bytes_.resize(start + bound);
    const std::size_t n = libdeflate_zlib_compress(compressor_.get(), data, size, bytes_.data() + start, bound);
    bytes_.resize(start + n);
    return n;
  }

  struct Free {
    void operator()(libdeflate_compressor* c) const { libdeflate_free_compressor(c); }
  };
  std::unique_ptr<libdeflate_compressor, Free> compressor_;
  std::string bytes_;
};

/// The cells in the order of the file: quads, triangles, edges of curves, points.
struct Cells {
  std::vector<std::int64_t> connectivity, offsets;
  std::vector<std::uint8_t> types;
  std::vector<std::int32_t> region, curve, point;  ///< index into regions, curves, node sets; -1: none
  std::vector<float> beta, scaled_jacobian;        ///< no number on edges and points

  template <std::size_t N>
  void add(VtkCell type, const std::array<NodeIndex, N>& nodes) {
    for (const NodeIndex node : nodes) connectivity.push_back(node);
    offsets.push_back(static_cast<std::int64_t>(connectivity.size()));
    types.push_back(type);
  }
  void tag(std::int64_t of_region, std::int64_t of_curve, std::int64_t of_point) {
    region.push_back(static_cast<std::int32_t>(of_region));
    curve.push_back(static_cast<std::int32_t>(of_curve));
    point.push_back(static_cast<std::int32_t>(of_point));
  }
  void measure(double of_beta, double of_jacobian) {
    beta.push_back(static_cast<float>(of_beta));
    scaled_jacobian.push_back(static_cast<float>(of_jacobian));
  }
};

void add_faces(const Mesh& mesh, Cells& cells) {
  for (std::size_t i = 0; i < mesh.quads.size(); ++i) {
    const QuadPoints quad = corners(mesh, mesh.quads[i]);
    cells.add(kVtkQuad, mesh.quads[i]);
    cells.tag(mesh.quad_region[i], -1, -1);
    cells.measure(quad_distortion(quad), scaled_jacobian(quad));
  }
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const auto triangle = corners(mesh, mesh.triangles[i]);
    cells.add(kVtkTriangle, mesh.triangles[i]);
    cells.tag(mesh.triangle_region[i], -1, -1);
    cells.measure(triangle_distortion(triangle[0], triangle[1], triangle[2]), scaled_jacobian(triangle));
  }
}

void add_curves_and_points(const Mesh& mesh, Cells& cells) {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  for (std::size_t c = 0; c < mesh.curves.size(); ++c) {
    for (const auto& edge : mesh.curves[c].edges) {
      cells.add(kVtkLine, edge);
      cells.tag(-1, static_cast<std::int64_t>(c), -1);
      cells.measure(kNone, kNone);
    }
  }
  for (std::size_t p = 0; p < mesh.node_sets.size(); ++p) {
    for (const NodeIndex node : mesh.node_sets[p].nodes) {
      cells.add(kVtkVertex, std::array{node});
      cells.tag(-1, -1, static_cast<std::int64_t>(p));
      cells.measure(kNone, kNone);
    }
  }
}

Cells cells_of(const Mesh& mesh) {
  Cells cells;
  const std::size_t n_faces = mesh.quads.size() + mesh.triangles.size();
  cells.connectivity.reserve(4 * n_faces);
  cells.offsets.reserve(n_faces);
  for (auto* ids : {&cells.region, &cells.curve, &cells.point}) ids->reserve(n_faces);
  for (auto* values : {&cells.beta, &cells.scaled_jacobian}) values->reserve(n_faces);
  add_faces(mesh, cells);
  add_curves_and_points(mesh, cells);
  return cells;
}

std::string xml_attribute(std::string_view text) {
  std::string out;
  for (const char c : printable(text)) {
    switch (c) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '"':
        out += "&quot;";
        break;
      default:
        out += c;
    }
  }
  return out;
}

std::string field_data(const Mesh& mesh) {
  std::string out = "<FieldData>\n";
  const auto add = [&](const char* kind, const std::string& name, std::size_t id) {
    out += "<DataArray type=\"Int32\" Name=\"" + std::string(kind) + '/' + xml_attribute(name) +
           "\" NumberOfTuples=\"1\" format=\"ascii\">";
    append_number(out, id);
    out += "</DataArray>\n";
  };
  for (std::size_t i = 0; i < mesh.regions.size(); ++i) add("region", mesh.regions[i], i);
  for (std::size_t i = 0; i < mesh.curves.size(); ++i) {
    const CurveKind kind = mesh.curves[i].kind;
    add(kind == CurveKind::Outer ? "outer" : kind == CurveKind::Hole ? "hole" : "line", mesh.curves[i].name, i);
  }
  for (std::size_t i = 0; i < mesh.node_sets.size(); ++i) add("point", mesh.node_sets[i].name, i);
  return out + "</FieldData>\n";
}

std::string array_tag(const char* type, const char* name, std::size_t offset, int components = 1) {
  std::string out = std::string("<DataArray type=\"") + type + "\" Name=\"" + name + '"';
  if (components > 1) out += " NumberOfComponents=\"" + std::to_string(components) + '"';
  return out + " format=\"appended\" offset=\"" + std::to_string(offset) + "\"/>\n";
}

}  // namespace

std::string to_vtu(const Mesh& mesh) {
  const Cells cells = cells_of(mesh);
  std::vector<double> xyz;
  xyz.reserve(3 * mesh.points.size());
  for (const Point p : mesh.points) xyz.insert(xyz.end(), {p.x, p.y, 0.0});

  Appended data;
  std::string out = "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"";
  out += std::endian::native == std::endian::little ? "LittleEndian" : "BigEndian";
  out += "\" header_type=\"UInt64\" compressor=\"vtkZLibDataCompressor\">\n<UnstructuredGrid>\n";
  out += field_data(mesh);
  out += "<Piece NumberOfPoints=\"" + std::to_string(mesh.points.size()) + "\" NumberOfCells=\"" +
         std::to_string(cells.types.size()) + "\">\n";
  out += "<Points>\n" + array_tag("Float64", "Points", data.add(xyz), 3) + "</Points>\n<Cells>\n";
  out += array_tag("Int64", "connectivity", data.add(cells.connectivity));
  out += array_tag("Int64", "offsets", data.add(cells.offsets));
  out += array_tag("UInt8", "types", data.add(cells.types));
  out += "</Cells>\n<CellData Scalars=\"scaled_jacobian\">\n";
  out += array_tag("Float32", "scaled_jacobian", data.add(cells.scaled_jacobian));
  out += array_tag("Float32", "beta", data.add(cells.beta));
  out += array_tag("Int32", "region", data.add(cells.region));
  out += array_tag("Int32", "curve", data.add(cells.curve));
  out += array_tag("Int32", "point", data.add(cells.point));
  out += "</CellData>\n</Piece>\n</UnstructuredGrid>\n<AppendedData encoding=\"raw\">\n_";
  out += data.bytes();
  return out += "\n</AppendedData>\n</VTKFile>\n";
}

}  // namespace quadline
