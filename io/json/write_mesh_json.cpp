// Our own format: the arrays of Mesh as they are. docs/output.md describes it.

#include "io/text/names.hpp"
#include "io/text/number_text.hpp"
#include "quadline/json.hpp"

namespace quadline {
namespace {

constexpr std::size_t kNumbersPerLine = 20;

/// Writes values with commas between them, so many on a line.
template <class Values, class Append>
void append_list(std::string& out, const Values& values, std::size_t per_line, Append append) {
  out += '[';
  std::size_t i = 0;
  for (const auto& value : values) {
    if (i > 0) out += ',';
    if (i % per_line == 0) out += "\n ";
    append(value);
    ++i;
  }
  out += ']';
}

template <std::size_t N>
void append_tuple(std::string& out, const std::array<NodeIndex, N>& nodes) {
  for (std::size_t i = 0; i < N; ++i) {
    out += i == 0 ? '[' : ',';
    append_number(out, nodes[i]);
  }
  out += ']';
}

template <class Elements>
void append_elements(std::string& out, const char* key, const Elements& elements) {
  out += std::string("\"") + key + "\": ";
  append_list(out, elements, 4, [&](const auto& element) { append_tuple(out, element); });
  out += ",\n";
}

void append_indices(std::string& out, const char* key, const std::vector<std::uint32_t>& values) {
  out += std::string("\"") + key + "\": ";
  append_list(out, values, kNumbersPerLine, [&](std::uint32_t value) { append_number(out, value); });
}

const char* kind_name(CurveKind kind) {
  switch (kind) {
    case CurveKind::Outer:
      return "outer";
    case CurveKind::Hole:
      return "hole";
    case CurveKind::Line:
      return "line";
  }
  return "line";
}

}  // namespace

std::string to_mesh_json(const Mesh& mesh) {
  constexpr std::size_t kBytesPerNode = 45, kBytesPerElement = 36;
  std::string out;
  out.reserve(kBytesPerNode * mesh.points.size() + kBytesPerElement * mesh.quads.size());
  out += "{\"format\": \"quadline-mesh\", \"version\": 1,\n\"points\": ";
  append_list(out, mesh.points, 3, [&](Point p) {
    out += '[';
    append_number(out, p.x);
    out += ',';
    append_number(out, p.y);
    out += ']';
  });
  out += ",\n";
  append_elements(out, "quads", mesh.quads);
  append_elements(out, "triangles", mesh.triangles);
  append_indices(out, "quad_region", mesh.quad_region);
  out += ",\n";
  append_indices(out, "triangle_region", mesh.triangle_region);
  out += ",\n\"regions\": ";
  append_list(out, mesh.regions, 1, [&](const std::string& name) { out += json_string(name); });
  out += ",\n\"curves\": ";
  append_list(out, mesh.curves, 1, [&](const EdgeSet& curve) {
    out += "{\"name\": " + json_string(curve.name) + ", \"kind\": \"" + kind_name(curve.kind) + "\", \"edges\": ";
    append_list(out, curve.edges, kNumbersPerLine / 2, [&](const auto& edge) { append_tuple(out, edge); });
    out += '}';
  });
  out += ",\n\"node_sets\": ";
  append_list(out, mesh.node_sets, 1, [&](const NodeSet& set) {
    out += "{\"name\": " + json_string(set.name) + ", ";
    append_indices(out, "nodes", set.nodes);
    out += '}';
  });
  return out += "}\n";
}

}  // namespace quadline
