#include "io/msh/msh_contents.hpp"

#include <algorithm>

namespace quadline {
namespace {

constexpr int kNoGroup = -1;  // stands for the tag of faces without a group

class Builder {
 public:
  Builder(MshContents& contents, const SourceFile& file) : contents_(contents), file_(file) {}
  FoundMesh build();

 private:
  using Element = MshContents::Element;

  std::uint32_t index_of_group(int dimension, int tag);
  std::uint32_t region_of(const Element& element);
  NodeIndex node(const Element& element, int i) const;
  void add(const Element& element);
  [[noreturn]] void fail(const Element& element, const std::string& message) const;

  MshContents& contents_;
  const SourceFile& file_;
  std::map<MshContents::GroupId, std::uint32_t> index_of_group_;  ///< into regions, curves, node sets
  std::size_t n_members_ = 0;
  FoundMesh found_;
};

void Builder::fail(const Element& element, const std::string& message) const {
  const std::string text = "element " + std::to_string(element.number) + ": " + message;
  if (contents_.is_binary) file_.fail_at_byte(element.at, text);
  file_.fail_at_line(element.at + 1, text);  // behind the end of the line before
}

std::uint32_t Builder::index_of_group(int dimension, int tag) {
  Mesh& mesh = found_.mesh;
  const std::size_t next = dimension == 0   ? mesh.node_sets.size()
                           : dimension == 1 ? mesh.curves.size()
                                            : mesh.regions.size();
  const MshContents::GroupId group(dimension, tag);
  const auto [at, is_new] = index_of_group_.try_emplace(group, static_cast<std::uint32_t>(next));
  if (is_new) {
    static constexpr const char* kKinds[] = {"point-", "line-", "region-"};
    const auto given = contents_.names.find(group);
    std::string name = kKinds[dimension] + std::to_string(tag);
    if (tag == kNoGroup) name = "domain";
    if (given != contents_.names.end()) name = given->second;
    if (dimension == 0) mesh.node_sets.push_back({name, {}});
    if (dimension == 1) mesh.curves.push_back({name, CurveKind::Line, {}});
    if (dimension == 2) mesh.regions.push_back(name);
  }
  return at->second;
}

std::uint32_t Builder::region_of(const Element& element) {
  return index_of_group(2, element.groups->empty() ? kNoGroup : element.groups->front());
}

NodeIndex Builder::node(const Element& element, int i) const {
  const NodeIndex index = contents_.nodes.find(element.nodes[i]);
  if (index == UINT32_MAX) fail(element, "there is no node " + std::to_string(element.nodes[i]));
  return index;
}

void Builder::add(const Element& element) {
  Mesh& mesh = found_.mesh;
  std::array<NodeIndex, 4> n{};
  for (int i = 0; i < element.n_nodes; ++i) n[static_cast<std::size_t>(i)] = node(element, i);
  if (element.n_nodes == 4) {
    mesh.quads.push_back(n);
    mesh.quad_region.push_back(region_of(element));
    return;
  }
  if (element.n_nodes == 3) {
    mesh.triangles.push_back({n[0], n[1], n[2]});
    mesh.triangle_region.push_back(region_of(element));
    return;
  }
  // One entity may claim many groups for many elements; the memory must stay in proportion to the file.
  n_members_ += element.groups->size();
  if (n_members_ > file_.bytes.size()) fail(element, "the groups are too large");
  for (const int group : *element.groups) {
    if (element.n_nodes == 1) mesh.node_sets[index_of_group(0, group)].nodes.push_back(n[0]);
    if (element.n_nodes == 2) mesh.curves[index_of_group(1, group)].edges.push_back({n[0], n[1]});
  }
}

FoundMesh Builder::build() {
  if (!sort_nodes(contents_.nodes, contents_.found)) file_.fail("a node number comes twice");
  found_ = std::move(contents_.found);
  for (const auto& [dimension, tag] : contents_.named)
    if (dimension >= 0 && dimension <= 2) index_of_group(dimension, tag);
  std::stable_sort(contents_.elements.begin(), contents_.elements.end(),
                   [](const Element& a, const Element& b) { return a.number < b.number; });
  for (const Element& element : contents_.elements) add(element);
  return std::move(found_);
}

}  // namespace

FoundMesh found_mesh(MshContents contents, const SourceFile& file) { return Builder(contents, file).build(); }

}  // namespace quadline
