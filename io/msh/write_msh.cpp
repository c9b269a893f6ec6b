// Gmsh's MSH 4.1, text [GmshMSH]. Regions, curves and named points are physical groups of dimension 2, 1 and 0.
//
// Physical groups hang on entities, and an edge is in one entity only. So the curves are cut into entities that belong
// to the same set of curves; a node is classified on the entity of least dimension that it lies on, as Gmsh does it.

#include <algorithm>
#include <map>

#include "base/utf8.hpp"
#include "io/found/edge_groups.hpp"
#include "io/mesh_formats.hpp"
#include "io/text/names.hpp"
#include "io/text/number_text.hpp"

namespace quadline {
namespace {

enum GmshType : int { kLine = 1, kTriangle = 2, kQuad = 3, kPoint = 15 };

/// A piece of the mesh of one dimension, and the physical groups it is in.
struct Entity {
  int dimension;
  std::vector<std::uint32_t> groups;  ///< indices; the physical tag is one more
  std::vector<NodeIndex> nodes;       ///< classified on it
};

/// The mesh sorted by entities: points first, then curves, then regions.
class Entities {
 public:
  explicit Entities(const Mesh& mesh);

  std::vector<Entity> all;
  std::vector<NodeIndex> named_nodes;  ///< of the first entities
  std::vector<EdgeGroup> edge_groups;  ///< of the next
  std::size_t first_region = 0;        ///< the last are the regions
  int tag(std::size_t entity) const {  ///< counts from 1 in each dimension
    const std::size_t first = all[entity].dimension == 0   ? 0
                              : all[entity].dimension == 1 ? named_nodes.size()
                                                           : first_region;
    return static_cast<int>(entity - first + 1);
  }

 private:
  void classify_nodes(const Mesh& mesh);
};

Entities::Entities(const Mesh& mesh) {
  std::map<NodeIndex, std::vector<std::uint32_t>> sets_of_node;
  for (std::uint32_t s = 0; s < mesh.node_sets.size(); ++s) {
    for (const NodeIndex node : mesh.node_sets[s].nodes) {
      auto& sets = sets_of_node[node];
      if (sets.empty() || sets.back() != s) sets.push_back(s);
    }
  }
  for (const auto& [node, sets] : sets_of_node) {
    named_nodes.push_back(node);
    all.push_back({0, sets, {}});
  }
  edge_groups = quadline::edge_groups(mesh, false);
  for (const EdgeGroup& group : edge_groups) all.push_back({1, group.curves, {}});
  first_region = all.size();
  for (std::uint32_t r = 0; r < mesh.regions.size(); ++r) all.push_back({2, {r}, {}});
  classify_nodes(mesh);
}

void Entities::classify_nodes(const Mesh& mesh) {
  std::vector<std::uint32_t> entity_of(mesh.points.size(), UINT32_MAX);
  const auto claim = [&](NodeIndex node, std::size_t entity) {
    if (entity_of[node] == UINT32_MAX) entity_of[node] = static_cast<std::uint32_t>(entity);
  };
  for (std::size_t i = 0; i < named_nodes.size(); ++i) claim(named_nodes[i], i);
  for (std::size_t i = 0; i < edge_groups.size(); ++i)
    for (const auto& edge : edge_groups[i].edges)
      for (const NodeIndex node : edge) claim(node, named_nodes.size() + i);
  for (std::size_t i = 0; i < mesh.quads.size(); ++i)
    for (const NodeIndex node : mesh.quads[i]) claim(node, first_region + mesh.quad_region[i]);
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
    for (const NodeIndex node : mesh.triangles[i]) claim(node, first_region + mesh.triangle_region[i]);

  for (NodeIndex node = 0; node < entity_of.size(); ++node) {
    if (!mesh.regions.empty()) claim(node, first_region);  // nodes of no element
    if (entity_of[node] != UINT32_MAX) all[entity_of[node]].nodes.push_back(node);
  }
}

template <class... Numbers>
void append_line(std::string& out, Numbers... numbers) {
  ((append_number(out, numbers), out += ' '), ...);
  out.back() = '\n';
}

void write_names(const Mesh& mesh, std::string& out) {
  std::string lines;
  std::size_t count = 0;
  const auto add = [&](int dimension, std::size_t i, const std::string& name) {
    std::string text = printable(name);
    std::replace(text.begin(), text.end(), '"', '\'');
    if (text.ends_with('\\')) text.back() = '_';  // some readers would take it with the quote behind it
    lines += std::to_string(dimension) + ' ' + std::to_string(i + 1) + " \"" + text + "\"\n";
    ++count;
  };
  for (std::size_t i = 0; i < mesh.node_sets.size(); ++i) add(0, i, mesh.node_sets[i].name);
  for (std::size_t i = 0; i < mesh.curves.size(); ++i) add(1, i, mesh.curves[i].name);
  for (std::size_t i = 0; i < mesh.regions.size(); ++i) add(2, i, mesh.regions[i]);
  out += "$PhysicalNames\n" + std::to_string(count) + '\n' + lines + "$EndPhysicalNames\n";
}

class BoundingBox {
 public:
  void add(Point p) {
    lo_ = empty_ ? p : Point{std::min(lo_.x, p.x), std::min(lo_.y, p.y)};
    hi_ = empty_ ? p : Point{std::max(hi_.x, p.x), std::max(hi_.y, p.y)};
    empty_ = false;
  }
  void write(std::string& out) const {
    for (const Point p : {lo_, hi_}) {
      append_number(out, p.x);
      out += ' ';
      append_number(out, p.y);
      out += " 0 ";
    }
  }

 private:
  Point lo_, hi_;
  bool empty_ = true;
};

std::vector<BoundingBox> boxes(const Mesh& mesh, const Entities& entities) {
  std::vector<BoundingBox> out(entities.all.size());
  for (std::size_t i = 0; i < entities.edge_groups.size(); ++i)
    for (const auto& edge : entities.edge_groups[i].edges)
      for (const NodeIndex node : edge) out[entities.named_nodes.size() + i].add(mesh.points[node]);
  for (std::size_t i = 0; i < mesh.quads.size(); ++i)
    for (const NodeIndex node : mesh.quads[i]) out[entities.first_region + mesh.quad_region[i]].add(mesh.points[node]);
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
    for (const NodeIndex node : mesh.triangles[i])
      out[entities.first_region + mesh.triangle_region[i]].add(mesh.points[node]);
  return out;
}

void write_entities(const Mesh& mesh, const Entities& entities, std::string& out) {
  out += "$Entities\n";
  append_line(out, entities.named_nodes.size(), entities.edge_groups.size(), mesh.regions.size(), 0);
  const std::vector<BoundingBox> box = boxes(mesh, entities);
  for (std::size_t i = 0; i < entities.all.size(); ++i) {
    const Entity& entity = entities.all[i];
    append_number(out, entities.tag(i));
    out += ' ';
    if (entity.dimension == 0) {
      const Point p = mesh.points[entities.named_nodes[i]];
      append_number(out, p.x);
      out += ' ';
      append_number(out, p.y);
      out += " 0 ";
    } else {
      box[i].write(out);
    }
    append_number(out, entity.groups.size());
    for (const std::uint32_t group : entity.groups) {
      out += ' ';
      append_number(out, group + 1);
    }
    out += entity.dimension == 0 ? "\n" : " 0\n";  // what bounds a discrete entity need not be given
  }
  out += "$EndEntities\n";
}

void write_nodes(const Mesh& mesh, const Entities& entities, std::string& out) {
  std::size_t n_blocks = 0, n_nodes = 0;
  for (const Entity& entity : entities.all) {
    n_blocks += !entity.nodes.empty();
    n_nodes += entity.nodes.size();
  }
  out += "$Nodes\n";
  append_line(out, n_blocks, n_nodes, n_nodes ? 1 : 0, mesh.points.size());
  for (std::size_t i = 0; i < entities.all.size(); ++i) {
    const Entity& entity = entities.all[i];
    if (entity.nodes.empty()) continue;
    append_line(out, entity.dimension, entities.tag(i), 0, entity.nodes.size());
    for (const NodeIndex node : entity.nodes) append_line(out, node + 1);
    for (const NodeIndex node : entity.nodes) append_line(out, mesh.points[node].x, mesh.points[node].y, 0);
  }
  out += "$EndNodes\n";
}

/// Writes the blocks of the elements; their tags count up in the order of the file.
class ElementWriter {
 public:
  explicit ElementWriter(std::string& out) : out_(out) {}

  /// Adds a block of the elements that `index` names.
  template <class Element>
  void add(int dimension, int tag, GmshType type, const std::vector<Element>& elements,
           const std::vector<std::uint32_t>& index) {
    if (index.empty()) return;
    append_line(text_, dimension, tag, static_cast<int>(type), index.size());
    for (const std::uint32_t i : index) {
      append_number(text_, ++n_elements_);
      for (const NodeIndex node : elements[i]) {
        text_ += ' ';
        append_number(text_, node + 1);
      }
      text_ += '\n';
    }
    ++n_blocks_;
  }
  void finish() {
    out_ += "$Elements\n";
    append_line(out_, n_blocks_, n_elements_, n_elements_ ? 1 : 0, n_elements_);
    out_ += text_;
    out_ += "$EndElements\n";
  }
  void reserve(std::size_t bytes) { text_.reserve(bytes); }

 private:
  std::string& out_;
  std::string text_;
  std::size_t n_blocks_ = 0, n_elements_ = 0;
};

std::vector<std::uint32_t> counted(std::size_t n) {
  std::vector<std::uint32_t> out(n);
  for (std::size_t i = 0; i < n; ++i) out[i] = static_cast<std::uint32_t>(i);
  return out;
}

std::vector<std::vector<std::uint32_t>> sorted_by(const std::vector<std::uint32_t>& region, std::size_t n_regions) {
  std::vector<std::vector<std::uint32_t>> out(n_regions);
  for (std::size_t i = 0; i < region.size(); ++i) out[region[i]].push_back(static_cast<std::uint32_t>(i));
  return out;
}

void write_elements(const Mesh& mesh, const Entities& entities, std::string& out) {
  constexpr std::size_t kBytesPerElement = 40;
  ElementWriter writer(out);
  writer.reserve(kBytesPerElement * (mesh.quads.size() + mesh.triangles.size()));
  for (std::size_t i = 0; i < entities.named_nodes.size(); ++i)
    writer.add(0, entities.tag(i), kPoint, std::vector{std::array{entities.named_nodes[i]}}, {0});
  for (std::size_t i = 0; i < entities.edge_groups.size(); ++i) {
    const auto& edges = entities.edge_groups[i].edges;
    writer.add(1, static_cast<int>(i + 1), kLine, edges, counted(edges.size()));
  }
  const auto quads = sorted_by(mesh.quad_region, mesh.regions.size());
  const auto triangles = sorted_by(mesh.triangle_region, mesh.regions.size());
  for (std::size_t r = 0; r < mesh.regions.size(); ++r) {
    writer.add(2, static_cast<int>(r + 1), kQuad, mesh.quads, quads[r]);
    writer.add(2, static_cast<int>(r + 1), kTriangle, mesh.triangles, triangles[r]);
  }
  writer.finish();
}

}  // namespace

std::string to_msh(const Mesh& mesh) {
  constexpr std::size_t kBytesPerNode = 50, kBytesPerElement = 40;
  const Entities entities(mesh);
  std::string out;
  out.reserve(kBytesPerNode * mesh.points.size() + kBytesPerElement * mesh.quads.size());
  out += "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n";
  write_names(mesh, out);
  write_entities(mesh, entities, out);
  write_nodes(mesh, entities, out);
  write_elements(mesh, entities, out);
  return out;
}

}  // namespace quadline
