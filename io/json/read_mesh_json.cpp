#include <nlohmann/json.hpp>

#include "io/json/parse_json.hpp"
#include "quadline/errors.hpp"
#include "quadline/json.hpp"

namespace quadline {
namespace {

using Json = nlohmann::json;

/// Takes values out of the document; errors name their JSON path.
class Reader {
 public:
  explicit Reader(std::string file) : file_(std::move(file)) {}
  Mesh read(const Json& root);

 private:
  [[noreturn]] void fail(const std::string& path, const std::string& message) const {
    throw InputError(ErrorCode::FileSyntax, message, Where{file_, path, {}});
  }
  const Json& list(const Json& object, const std::string& path, const char* key) const;
  std::string text(const Json& object, const std::string& path, const char* key) const;
  std::uint32_t index(const Json& value, const std::string& path, std::size_t bound) const;
  Point point(const Json& value, const std::string& path) const;
  template <std::size_t N>
  std::vector<std::array<NodeIndex, N>> tuples(const Json& object, const std::string& path, const char* key) const;
  std::vector<std::uint32_t> indices(const Json& object, const std::string& path, const char* key,
                                     std::size_t bound) const;
  std::vector<std::uint32_t> regions_of(const Json& root, const char* key, std::size_t n_elements) const;
  CurveKind kind(const Json& curve, const std::string& path) const;

  std::string file_;
  Mesh mesh_;
};

std::string item(const std::string& path, std::size_t i) { return path + '/' + std::to_string(i); }

const Json& Reader::list(const Json& object, const std::string& path, const char* key) const {
  const auto at = object.find(key);
  if (at == object.end()) fail(path, std::string("'") + key + "' is missing");
  if (!at->is_array()) fail(path + '/' + key, "must be a list");
  return *at;
}

std::string Reader::text(const Json& object, const std::string& path, const char* key) const {
  if (!object.is_object()) fail(path, "must be an object");
  const auto at = object.find(key);
  if (at == object.end() || !at->is_string()) fail(path, std::string("'") + key + "' must be a text");
  return at->get<std::string>();
}

std::uint32_t Reader::index(const Json& value, const std::string& path, std::size_t bound) const {
  if (!value.is_number_unsigned()) fail(path, "must be a whole number, 0 or more");
  const auto i = value.get<std::uint64_t>();
  if (i >= bound) fail(path, std::to_string(i) + " is too large: there are " + std::to_string(bound));
  return static_cast<std::uint32_t>(i);
}

Point Reader::point(const Json& value, const std::string& path) const {
  if (!value.is_array() || value.size() != 2 || !value[0].is_number() || !value[1].is_number())
    fail(path, "must be two numbers");
  return {value[0].get<double>(), value[1].get<double>()};
}

template <std::size_t N>
std::vector<std::array<NodeIndex, N>> Reader::tuples(const Json& object, const std::string& path,
                                                     const char* key) const {
  const Json& values = list(object, path, key);
  std::vector<std::array<NodeIndex, N>> out(values.size());
  for (std::size_t i = 0; i < values.size(); ++i) {
    const Json& value = values[i];
    const bool fits = value.is_array() && value.size() == N;
    for (std::size_t j = 0; j < N; ++j) {
      // Paths are made for errors only: a million of them would cost more than the reading.
      if (!fits || !value[j].is_number_unsigned() || value[j].get<std::uint64_t>() >= mesh_.points.size())
        fail(item(path + '/' + key, i),
             "must be " + std::to_string(N) + " node indices below " + std::to_string(mesh_.points.size()));
      out[i][j] = value[j].get<NodeIndex>();
    }
  }
  return out;
}

std::vector<std::uint32_t> Reader::indices(const Json& object, const std::string& path, const char* key,
                                           std::size_t bound) const {
  const Json& values = list(object, path, key);
  std::vector<std::uint32_t> out(values.size());
  for (std::size_t i = 0; i < values.size(); ++i) {
    const bool fits = values[i].is_number_unsigned() && values[i].get<std::uint64_t>() < bound;
    out[i] = fits ? values[i].get<std::uint32_t>() : index(values[i], item(path + '/' + key, i), bound);
  }
  return out;
}

std::vector<std::uint32_t> Reader::regions_of(const Json& root, const char* key, std::size_t n_elements) const {
  auto out = indices(root, "", key, mesh_.regions.size());
  if (out.size() != n_elements)
    fail(std::string("/") + key, "must have an entry for each of the " + std::to_string(n_elements) + " elements");
  return out;
}

CurveKind Reader::kind(const Json& curve, const std::string& path) const {
  const std::string kind = text(curve, path, "kind");
  if (kind == "outer") return CurveKind::Outer;
  if (kind == "hole") return CurveKind::Hole;
  if (kind != "line") fail(path + "/kind", "must be \"outer\", \"hole\" or \"line\"");
  return CurveKind::Line;
}

Mesh Reader::read(const Json& root) {
  if (!root.is_object() || root.value("format", Json()) != "quadline-mesh") {
    const bool is_model = root.is_object() && root.contains("outer");
    fail("", is_model ? "is a model, not a mesh" : "is no mesh: \"format\" must be \"quadline-mesh\"");
  }
  if (root.value("version", Json()) != 1) fail("/version", "must be 1");
  const Json& points = list(root, "", "points");
  mesh_.points.resize(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Json& p = points[i];
    const bool fits = p.is_array() && p.size() == 2 && p[0].is_number() && p[1].is_number();
    mesh_.points[i] = fits ? Point{p[0].get<double>(), p[1].get<double>()} : point(p, item("/points", i));
  }
  mesh_.quads = tuples<4>(root, "", "quads");
  mesh_.triangles = tuples<3>(root, "", "triangles");
  const Json& regions = list(root, "", "regions");
  for (std::size_t i = 0; i < regions.size(); ++i) {
    if (!regions[i].is_string()) fail(item("/regions", i), "must be a text");
    mesh_.regions.push_back(regions[i].get<std::string>());
  }
  mesh_.quad_region = regions_of(root, "quad_region", mesh_.quads.size());
  mesh_.triangle_region = regions_of(root, "triangle_region", mesh_.triangles.size());
  const Json& curves = list(root, "", "curves");
  for (std::size_t i = 0; i < curves.size(); ++i) {
    const std::string path = item("/curves", i), name = text(curves[i], path, "name");
    mesh_.curves.push_back({name, kind(curves[i], path), tuples<2>(curves[i], path, "edges")});
  }
  const Json& sets = list(root, "", "node_sets");
  for (std::size_t i = 0; i < sets.size(); ++i) {
    const std::string path = item("/node_sets", i), name = text(sets[i], path, "name");
    mesh_.node_sets.push_back({name, indices(sets[i], path, "nodes", mesh_.points.size())});
  }
  return std::move(mesh_);
}

}  // namespace

Mesh parse_mesh_json(std::string_view bytes, const std::string& file) {
  return Reader(file).read(parse_json(bytes, file));
}

}  // namespace quadline
