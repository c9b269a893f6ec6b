#include "io/inp/inp_contents.hpp"

#include <algorithm>

namespace quadline {

std::string upper_case(std::string_view text) {
  std::string out(text);
  for (char& c : out)
    if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
  return out;
}

InpSets::Set& InpSets::named(const std::string& name) {
  const auto [at, is_new] = by_name_.try_emplace(upper_case(name), all_.size());
  if (is_new) all_.push_back({name, {}});
  return all_[at->second];
}

std::vector<std::uint32_t> InpSets::members(const Set& set, const Numbering& numbering, const SourceFile& file) {
  std::vector<std::uint32_t> out;
  add_members(set, numbering, file, 0, out);
  return out;
}

void InpSets::add_members(const Set& set, const Numbering& numbering, const SourceFile& file, int depth,
                          std::vector<std::uint32_t>& out) {
  constexpr int kDeepest = 8;
  constexpr std::size_t kMembersPerByte = 4;  // short cards may claim long sets; the memory must stay in proportion
  for (const Item& item : set.items) {
    const std::size_t before = out.size();
    if (++n_members_ > kMembersPerByte * file.bytes.size()) file.fail_at_line(item.at, "the sets are too large");
    if (!item.other.empty()) {
      const auto other = by_name_.find(upper_case(item.other));
      if (other == by_name_.end()) file.fail_at_line(item.at, "there is no set '" + item.other + "'");
      if (depth == kDeepest) file.fail_at_line(item.at, "sets name each other too deeply");
      add_members(all_[other->second], numbering, file, depth + 1, out);
      continue;
    }
    if (item.first == item.last) {
      const std::uint32_t index = numbering.find(item.first);
      if (index != UINT32_MAX) out.push_back(index);
      continue;
    }
    const auto& entries = numbering.entries();
    auto entry = std::lower_bound(entries.begin(), entries.end(), std::pair(item.first, std::uint32_t{0}));
    for (; entry != entries.end() && entry->first <= item.last; ++entry) {
      const auto from_first = static_cast<std::uint64_t>(entry->first) - static_cast<std::uint64_t>(item.first);
      if (from_first % static_cast<std::uint64_t>(item.step) == 0) out.push_back(entry->second);
    }
    n_members_ += out.size() - before;
  }
}

namespace {

class Builder {
 public:
  Builder(InpContents& contents, const SourceFile& file) : contents_(contents), file_(file) {}
  FoundMesh build();

 private:
  using Element = InpContents::Element;

  void add_elements();
  void add_element_sets();
  void name_the_rest();
  void add_node_sets();
  bool is_sum(const InpSets::Set& set, std::size_t n_members) const;

  InpContents& contents_;
  const SourceFile& file_;
  std::vector<std::uint32_t> face_index_;  ///< of each element: into quads or triangles
  FoundMesh found_;
};

void Builder::add_elements() {
  Mesh& mesh = found_.mesh;
  face_index_.assign(contents_.elements.size(), UINT32_MAX);
  for (const auto& [number, i] : contents_.element_numbers.entries()) {
    const Element& element = contents_.elements[i];
    std::array<NodeIndex, 4> n{};
    for (std::size_t j = 0; j < element.n_nodes; ++j) {
      n[j] = contents_.node_numbers.find(element.nodes[j]);
      if (n[j] != UINT32_MAX) continue;
      file_.fail_at_line(
          element.at, "element " + std::to_string(number) + ": there is no node " + std::to_string(element.nodes[j]));
    }
    if (element.n_nodes == 4) {
      face_index_[i] = static_cast<std::uint32_t>(mesh.quads.size());
      mesh.quads.push_back(n);
    } else if (element.n_nodes == 3) {
      face_index_[i] = static_cast<std::uint32_t>(mesh.triangles.size());
      mesh.triangles.push_back({n[0], n[1], n[2]});
    }
  }
  mesh.quad_region.assign(mesh.quads.size(), UINT32_MAX);
  mesh.triangle_region.assign(mesh.triangles.size(), UINT32_MAX);
}

/// The sets QUADS, TRIANGLES and LINES of our own files, which hold all of a kind beside the sets that divide them.
bool Builder::is_sum(const InpSets::Set& set, std::size_t n_members) const {
  const std::string name = upper_case(set.name);
  const Mesh& mesh = found_.mesh;
  const std::size_t n_faces = mesh.quads.size() + mesh.triangles.size();
  return contents_.element_sets.all().size() > 1 &&
         ((name == "QUADS" && n_members == mesh.quads.size()) ||
          (name == "TRIANGLES" && n_members == mesh.triangles.size()) ||
          (name == "LINES" && n_members == contents_.elements.size() - n_faces));
}

void Builder::add_element_sets() {
  constexpr std::string_view kPart = "QUADLINE_PART_";  // pieces of lines that write_inp.cpp had to cut
  Mesh& mesh = found_.mesh;
  for (const InpSets::Set& set : contents_.element_sets.all()) {
    const auto all = contents_.element_sets.members(set, contents_.element_numbers, file_);
    if (is_sum(set, all.size()) || set.name.substr(0, kPart.size()) == kPart) continue;
    EdgeSet curve{set.name, CurveKind::Line, {}};
    const auto region = static_cast<std::uint32_t>(mesh.regions.size());
    bool has_faces = false;
    for (const std::uint32_t i : all) {
      const Element& element = contents_.elements[i];
      if (element.n_nodes == 2) {
        const auto node = [&](int j) { return contents_.node_numbers.find(element.nodes[j]); };
        curve.edges.push_back({node(0), node(1)});
        continue;
      }
      auto& of_faces = element.n_nodes == 4 ? mesh.quad_region : mesh.triangle_region;
      if (of_faces[face_index_[i]] != UINT32_MAX) continue;
      of_faces[face_index_[i]] = region;
      has_faces = true;
    }
    if (has_faces) mesh.regions.push_back(set.name);
    if (!curve.edges.empty()) mesh.curves.push_back(std::move(curve));
  }
}

void Builder::name_the_rest() {
  Mesh& mesh = found_.mesh;
  const auto rest = static_cast<std::uint32_t>(mesh.regions.size());
  bool has_rest = false;
  for (auto* regions : {&mesh.quad_region, &mesh.triangle_region}) {
    for (std::uint32_t& region : *regions) {
      has_rest |= region == UINT32_MAX;
      region = std::min(region, rest);
    }
  }
  if (has_rest) mesh.regions.push_back("domain");
}

void Builder::add_node_sets() {
  for (const InpSets::Set& set : contents_.node_sets.all()) {
    std::vector<NodeIndex> nodes = contents_.node_sets.members(set, contents_.node_numbers, file_);
    const bool is_all = upper_case(set.name) == "NALL" && nodes.size() == contents_.node_numbers.count();
    if (!is_all && !contents_.element_sets.has(set.name)) found_.mesh.node_sets.push_back({set.name, std::move(nodes)});
  }
}

FoundMesh Builder::build() {
  if (!sort_nodes(contents_.node_numbers, contents_.found)) file_.fail("a node number comes twice");
  if (!contents_.element_numbers.close()) file_.fail("an element number comes twice");
  found_ = std::move(contents_.found);
  add_elements();
  add_element_sets();
  name_the_rest();
  add_node_sets();
  return std::move(found_);
}

}  // namespace

FoundMesh found_mesh(InpContents contents, const SourceFile& file) { return Builder(contents, file).build(); }

}  // namespace quadline
