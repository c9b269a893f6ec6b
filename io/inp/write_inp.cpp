// Abaqus input [Abaqus], as CalculiX takes it [CalculiX]: nodes, elements and sets; sections and loads are the job's.
//
// An edge on which several lines run becomes one beam, not several that add their stiffness. So elements come in blocks
// of the same sets. A block that is all of one set carries its name; other sets are listed after the elements. (meshio
// takes names from the blocks only if each has one of its own.)

#include <algorithm>
#include <utility>

#include "base/utf8.hpp"
#include "io/found/edge_groups.hpp"
#include "io/mesh_formats.hpp"
#include "io/text/names.hpp"
#include "io/text/number_text.hpp"

namespace quadline {
namespace {

constexpr std::ptrdiff_t kColumns = 20;      // CalculiX reads 20 characters of a number, and no more
constexpr std::size_t kNumbersPerLine = 16;  // the most that Abaqus and CalculiX take in a set

/// Elements that are in the same sets.
struct Block {
  const char* type;
  std::vector<std::uint32_t> sets;  ///< indices of ElementSet
  std::vector<std::uint32_t> ids;   ///< from 1
  std::string nodes;                ///< the lines of the card
  bool is_line = false;
};

struct ElementSet {
  std::string name;
  std::vector<std::uint32_t> blocks;
};

/// Names under which things of the model stand in the file.
struct Names {
  explicit Names(const Mesh& mesh) {
    for (const auto& name : mesh.regions) regions.push_back(make(name));
    for (const EdgeSet& curve : mesh.curves) curves.push_back(make(curve.name));
    for (const NodeSet& set : mesh.node_sets) points.push_back(make(set.name));
  }

  SetNames all;
  std::string nodes = all.make("NALL"), quads = all.make("QUADS"), triangles = all.make("TRIANGLES"),
              lines = all.make("LINES");
  std::vector<std::string> regions, curves, points;
  std::string changed;  ///< comment lines

 private:
  std::string make(const std::string& name) {
    std::string made = all.make(name);
    if (made != name) changed += "**   " + made + " was '" + printable(name) + "'\n";
    return made;
  }
};

class Writer {
 public:
  explicit Writer(const Mesh& mesh) : mesh_(mesh), names_(mesh) {}
  std::string write();

 private:
  void add_faces();
  void add_lines();
  template <class Element>
  void add_element(Block& block, const Element& nodes);
  void add_block(Block block);
  void write_header();
  void write_nodes();
  void write_elements();
  void write_element_sets();
  void write_node_sets();
  void write_set(const std::string& card, const std::vector<std::uint32_t>& ids);
  void write_range(const std::string& card, std::size_t first, std::size_t last);

  const Mesh& mesh_;
  Names names_;
  std::vector<Block> blocks_;
  std::vector<ElementSet> sets_;
  std::vector<std::vector<std::uint32_t>> faces_of_region_;  ///< ids
  std::uint32_t n_elements_ = 0;
  std::uint32_t first_line_ = 0;  ///< id of the first beam
  std::string out_;
};

template <class Element>
void Writer::add_element(Block& block, const Element& nodes) {
  append_number(block.nodes, block.ids.back());
  for (const NodeIndex node : nodes) {
    block.nodes += ',';
    append_number(block.nodes, node + 1);
  }
  block.nodes += '\n';
}

void Writer::add_block(Block block) {
  if (block.ids.empty()) return;
  for (const std::uint32_t set : block.sets) sets_[set].blocks.push_back(static_cast<std::uint32_t>(blocks_.size()));
  blocks_.push_back(std::move(block));
}

/// Quads keep their order in their ids, then triangles.
void Writer::add_faces() {
  const std::size_t n_regions = mesh_.regions.size();
  for (const auto& name : names_.regions) sets_.push_back({name, {}});
  std::vector<Block> quads, triangles;
  for (std::uint32_t r = 0; r < n_regions; ++r) {
    quads.push_back({"S4", {r}, {}, {}, false});
    triangles.push_back({"S3", {r}, {}, {}, false});
  }
  for (std::size_t i = 0; i < mesh_.quads.size(); ++i) {
    Block& block = quads[mesh_.quad_region[i]];
    block.ids.push_back(++n_elements_);
    add_element(block, mesh_.quads[i]);
  }
  for (std::size_t i = 0; i < mesh_.triangles.size(); ++i) {
    Block& block = triangles[mesh_.triangle_region[i]];
    block.ids.push_back(++n_elements_);
    add_element(block, mesh_.triangles[i]);
  }
  for (std::uint32_t r = 0; r < n_regions; ++r) {
    faces_of_region_.push_back(quads[r].ids);
    faces_of_region_[r].insert(faces_of_region_[r].end(), triangles[r].ids.begin(), triangles[r].ids.end());
    add_block(std::move(quads[r]));
    add_block(std::move(triangles[r]));
  }
}

void Writer::add_lines() {
  first_line_ = n_elements_ + 1;
  const auto first_set = static_cast<std::uint32_t>(sets_.size());
  for (const auto& name : names_.curves) sets_.push_back({name, {}});
  for (const EdgeGroup& group : edge_groups(mesh_, true)) {
    Block block{"B31", {}, {}, {}, true};
    for (const std::uint32_t curve : group.curves) block.sets.push_back(first_set + curve);
    for (const auto& edge : group.edges) {
      block.ids.push_back(++n_elements_);
      add_element(block, edge);
    }
    add_block(std::move(block));
  }
}

void Writer::write_header() {
  const bool has_lines = first_line_ <= n_elements_;
  out_ += "** Mesh by Quadline: " + std::to_string(mesh_.points.size()) + " nodes, " +
          std::to_string(mesh_.quads.size()) + " quads\n** A job includes it and gives every element a section:\n";
  out_ +=
      "**   *INCLUDE, INPUT=this-file.inp\n"
      "**   *MATERIAL, NAME=PLATE\n"
      "**   *ELASTIC\n"
      "**   210000., 0.3\n"
      "**   *SHELL SECTION, ELSET=" +
      names_.quads +
      ", MATERIAL=PLATE\n"
      "**   10.\n";
  if (has_lines) {
    out_ +=
        "** Beams: height along the normal n1 = 0,0,1, then width. In CalculiX Poisson's ratio 0 keeps them from "
        "being\n"
        "** too stiff where they are joined to shells.\n"
        "**   *MATERIAL, NAME=STIFFENER\n"
        "**   *ELASTIC\n"
        "**   210000., 0.\n"
        "**   *BEAM SECTION, ELSET=" +
        names_.lines +
        ", MATERIAL=STIFFENER, SECTION=RECT\n"
        "**   80., 10.\n"
        "**   0., 0., 1.\n";
  }
  if (!names_.changed.empty()) out_ += "** Names that the format does not take:\n" + names_.changed;
}

void Writer::write_nodes() {
  out_ += "*NODE\n";
  for (std::size_t i = 0; i < mesh_.points.size(); ++i) {
    append_number(out_, i + 1);
    out_ += ',';
    append_number_within(out_, mesh_.points[i].x, kColumns);
    out_ += ',';
    append_number_within(out_, mesh_.points[i].y, kColumns);
    out_ += ",0\n";
  }
}

void Writer::write_elements() {
  int n_parts = 0;
  for (Block& block : blocks_) {
    ElementSet& first = sets_[block.sets[0]];
    const bool is_part = block.is_line && (block.sets.size() > 1 || first.blocks.size() > 1);
    const std::string name = is_part ? names_.all.make("QUADLINE_PART_" + std::to_string(++n_parts)) : first.name;
    if (!is_part) first.blocks.clear();  // written
    out_ += std::string("*ELEMENT, TYPE=") + block.type + ", ELSET=" + name + '\n' + block.nodes;
    block.nodes = {};
  }
}

void Writer::write_range(const std::string& card, std::size_t first, std::size_t last) {
  if (first > last) return;
  out_ += card + ", GENERATE\n" + std::to_string(first) + ',' + std::to_string(last) + ",1\n";
}

void Writer::write_set(const std::string& card, const std::vector<std::uint32_t>& ids) {
  if (ids.empty()) return;
  bool is_run = ids.size() > 1;
  for (std::size_t i = 1; i < ids.size() && is_run; ++i) is_run = ids[i] == ids[i - 1] + 1;
  if (is_run) return write_range(card, ids.front(), ids.back());
  out_ += card;
  for (std::size_t i = 0; i < ids.size(); ++i) {
    out_ += i % kNumbersPerLine == 0 ? '\n' : ',';
    append_number(out_, ids[i]);
  }
  out_ += '\n';
}

void Writer::write_element_sets() {
  const std::size_t n_quads = mesh_.quads.size();
  write_range("*ELSET, ELSET=" + names_.quads, 1, n_quads);
  write_range("*ELSET, ELSET=" + names_.triangles, n_quads + 1, n_quads + mesh_.triangles.size());
  write_range("*ELSET, ELSET=" + names_.lines, first_line_, n_elements_);
  for (const ElementSet& set : sets_) {
    std::vector<std::uint32_t> ids;
    for (const std::uint32_t block : set.blocks)
      ids.insert(ids.end(), blocks_[block].ids.begin(), blocks_[block].ids.end());
    write_set("*ELSET, ELSET=" + set.name, ids);
  }
}

/// Nodes of regions in the order of their ids; of curves in the order along them.
void Writer::write_node_sets() {
  write_range("*NSET, NSET=" + names_.nodes, 1, mesh_.points.size());
  std::vector<std::uint32_t> last_seen(mesh_.points.size(), UINT32_MAX);
  std::uint32_t set = 0;
  const auto add = [&](std::vector<std::uint32_t>& ids, NodeIndex node) {
    if (last_seen[node] != set) ids.push_back(node + 1);
    last_seen[node] = set;
  };
  for (std::size_t r = 0; r < faces_of_region_.size(); ++r, ++set) {
    std::vector<std::uint32_t> ids;
    for (const std::uint32_t id : faces_of_region_[r]) {
      const std::size_t i = id - 1, n_quads = mesh_.quads.size();
      if (i < n_quads) {
        for (const NodeIndex node : mesh_.quads[i]) add(ids, node);
      } else {
        for (const NodeIndex node : mesh_.triangles[i - n_quads]) add(ids, node);
      }
    }
    std::sort(ids.begin(), ids.end());
    write_set("*NSET, NSET=" + names_.regions[r], ids);
  }
  for (std::size_t c = 0; c < names_.curves.size(); ++c, ++set) {
    std::vector<std::uint32_t> ids;
    for (const auto& edge : mesh_.curves[c].edges)
      for (const NodeIndex node : edge) add(ids, node);
    write_set("*NSET, NSET=" + names_.curves[c], ids);
  }
  for (std::size_t p = 0; p < names_.points.size(); ++p, ++set) {
    std::vector<std::uint32_t> ids;
    for (const NodeIndex node : mesh_.node_sets[p].nodes) add(ids, node);
    write_set("*NSET, NSET=" + names_.points[p], ids);
  }
}

std::string Writer::write() {
  constexpr std::size_t kBytesPerNode = 50, kBytesPerElement = 50;
  out_.reserve(kBytesPerNode * mesh_.points.size() + kBytesPerElement * mesh_.quads.size());
  add_faces();
  add_lines();
  write_header();
  write_nodes();
  write_elements();
  write_element_sets();
  write_node_sets();
  return std::move(out_);
}

}  // namespace

std::string to_inp(const Mesh& mesh) { return Writer(mesh).write(); }

}  // namespace quadline
