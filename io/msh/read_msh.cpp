// Gmsh's MSH 2.2 and 4.1, text and binary [GmshMSH]. Physical groups become regions, curves and node sets.

#include <algorithm>

#include "io/mesh_formats.hpp"
#include "io/msh/msh_contents.hpp"
#include "io/text/cursor.hpp"

namespace quadline {
namespace {

/// Elements of first order in a plane: nodes and dimension.
struct ElementType {
  int type, n_nodes, dimension;
};
constexpr ElementType kTypes[] = {{15, 1, 0}, {1, 2, 1}, {2, 3, 2}, {3, 4, 2}};

class Reader {
 public:
  explicit Reader(const SourceFile& file) : file_(file), in_(file) {}
  Mesh read();

 private:
  using Groups = MshContents::Groups;
  using Element = MshContents::Element;

  // Values in text or binary
  std::int64_t integer() { return binary_ ? in_.raw<std::int32_t>() : in_.number<std::int64_t>(); }
  std::int64_t size() { return binary_ ? in_.raw<std::int64_t>() : in_.number<std::int64_t>(); }
  double real() { return binary_ ? in_.raw<double>() : in_.number<double>(); }
  std::size_t count(std::size_t bytes_each);  ///< a `size` that the rest of the file can hold
  std::size_t checked(std::int64_t n, std::size_t bytes_each);

  void read_format();
  void read_names();
  void read_entities();
  void read_nodes_4();
  void read_nodes_2();
  void read_elements_4();
  void read_elements_2();
  void read_elements_2_binary(std::int64_t n_elements);
  void read_node(std::int64_t number);
  void read_element_nodes(Element& element, const ElementType& type);
  void skip_section(const std::string& name);
  const ElementType& type_of(std::int64_t type) const;
  const Groups* kept(Groups groups) { return &*contents_.of_elements.insert(std::move(groups)).first; }

  const SourceFile& file_;
  Cursor in_;
  bool binary_ = false;
  int version_ = 0;  ///< 2 or 4
  MshContents contents_;
};

std::size_t Reader::checked(std::int64_t n, std::size_t bytes_each) {
  if (n < 0 || static_cast<std::uint64_t>(n) > in_.left() / bytes_each)
    in_.fail("a count of " + std::to_string(n) + " is more than the file holds");
  return static_cast<std::size_t>(n);
}

std::size_t Reader::count(std::size_t bytes_each) { return checked(size(), bytes_each); }

const ElementType& Reader::type_of(std::int64_t type) const {
  for (const ElementType& known : kTypes)
    if (known.type == type) return known;
  in_.fail("element type " + std::to_string(type) +
           " is not read: only points, lines, triangles and quads of first order are");
}

void Reader::read_format() {
  const std::string_view version = in_.next_word();
  const auto file_type = in_.number<int>();
  const auto data_size = in_.number<int>();
  if (version.substr(0, 2) == "2." || version == "2") {
    version_ = 2;
  } else if (version == "4.1") {
    version_ = 4;
  } else {
    in_.fail("MSH version '" + std::string(version.substr(0, 20)) + "' is not read: 2.2 and 4.1 are");
  }
  if (data_size != 8) in_.fail("numbers of " + std::to_string(data_size) + " bytes are not read: 8 are");
  binary_ = file_type == 1;
  in_.set_binary(binary_);
  if (!binary_) return;
  in_.line();
  const std::size_t start = in_.at();
  if (in_.raw<std::int32_t>() == 1) return;
  in_.set_swapped(true);
  in_.move_to(start);
  if (in_.raw<std::int32_t>() != 1) in_.fail("the mark of the byte order is wrong");
}

void Reader::read_names() {
  const auto n = checked(in_.number<std::int64_t>(), 1);
  for (std::size_t i = 0; i < n; ++i) {
    const auto dimension = in_.number<int>(), tag = in_.number<int>();
    const std::string_view rest = in_.line();
    const std::size_t first = rest.find('"'), last = rest.rfind('"');
    if (first == rest.npos || first == last) in_.fail("a name in quotes was expected");
    const std::pair group(dimension, tag);
    if (contents_.names.try_emplace(group, rest.substr(first + 1, last - first - 1)).second)
      contents_.named.push_back(group);
  }
}

void Reader::read_entities() {
  std::size_t counts[4];
  for (auto& n : counts) n = count(1);
  for (int dimension = 0; dimension < 4; ++dimension) {
    for (std::size_t i = 0; i < counts[dimension]; ++i) {
      const std::int64_t tag = integer();
      for (int j = 0; j < (dimension == 0 ? 3 : 6); ++j) real();
      Groups& groups = contents_.of_entity[{dimension, tag}];
      for (std::size_t n = count(binary_ ? 4 : 1); n > 0; --n) groups.push_back(static_cast<int>(integer()));
      if (dimension == 0) continue;
      for (std::size_t n = count(binary_ ? 4 : 1); n > 0; --n) integer();
    }
  }
}

void Reader::read_node(std::int64_t number) {
  contents_.nodes.add(number);
  const double x = real(), y = real();
  contents_.found.mesh.points.push_back({x, y});
  contents_.found.z.push_back(real());
}

void Reader::read_nodes_4() {
  const std::size_t n_blocks = count(1);
  for (int i = 0; i < 3; ++i) size();
  for (std::size_t block = 0; block < n_blocks; ++block) {
    const std::int64_t dimension = integer();
    integer();
    const bool parametric = integer() != 0;
    const std::size_t n = count(binary_ ? 32 : 8);
    std::vector<std::int64_t> numbers(n);
    for (auto& number : numbers) number = size();
    for (const std::int64_t number : numbers) {
      read_node(number);
      for (std::int64_t i = 0; parametric && i < std::min<std::int64_t>(dimension, 3); ++i) real();
    }
  }
}

void Reader::read_nodes_2() {
  const auto n = checked(in_.number<std::int64_t>(), 8);
  if (binary_) in_.line();
  for (std::size_t i = 0; i < n; ++i) read_node(integer());
}

void Reader::read_element_nodes(Element& element, const ElementType& type) {
  element.n_nodes = type.n_nodes;
  for (int i = 0; i < type.n_nodes; ++i) element.nodes[i] = version_ == 4 ? size() : integer();
  contents_.elements.push_back(element);
}

void Reader::read_elements_4() {
  const Groups* const no_groups = kept({});
  const std::size_t n_blocks = count(1);
  for (int i = 0; i < 3; ++i) size();
  for (std::size_t block = 0; block < n_blocks; ++block) {
    const auto dimension = static_cast<int>(integer());
    const std::int64_t entity = integer();
    const ElementType& type = type_of(integer());
    const auto groups = contents_.of_entity.find({dimension, entity});
    for (std::size_t n = count(binary_ ? 16 : 4); n > 0; --n) {
      Element element{};
      element.at = in_.at();
      element.groups = groups == contents_.of_entity.end() ? no_groups : &groups->second;
      element.number = size();
      read_element_nodes(element, type);
    }
  }
}

void Reader::read_elements_2() {
  const auto n = in_.number<std::int64_t>();
  if (binary_) return read_elements_2_binary(n);
  for (std::size_t i = checked(n, 4); i > 0; --i) {
    Element element{};
    element.at = in_.at();
    element.number = integer();
    const ElementType& type = type_of(integer());
    Groups groups;
    for (std::size_t j = 0, n_tags = checked(integer(), 2); j < n_tags; ++j) {
      const auto tag = static_cast<int>(integer());
      if (j == 0 && tag != 0) groups = {tag};
    }
    element.groups = kept(std::move(groups));
    read_element_nodes(element, type);
  }
}

void Reader::read_elements_2_binary(std::int64_t n_elements) {
  in_.line();
  for (auto left = static_cast<std::int64_t>(checked(n_elements, 8)); left > 0;) {
    const ElementType& type = type_of(integer());
    const std::int64_t n = integer(), n_tags = integer();
    if (n < 1 || n > left || n_tags < 0) in_.fail("a block of elements has a wrong count");
    for (std::int64_t i = 0; i < n; ++i) {
      Element element{};
      element.at = in_.at();
      element.number = integer();
      Groups groups;
      for (std::int64_t j = 0; j < n_tags; ++j) {
        const auto tag = static_cast<int>(integer());
        if (j == 0 && tag != 0) groups = {tag};
      }
      element.groups = kept(std::move(groups));
      read_element_nodes(element, type);
    }
    left -= n;
  }
}

void Reader::skip_section(const std::string& name) {
  const std::size_t end = file_.bytes.find("$End" + name, in_.at());
  if (end == std::string_view::npos) in_.fail("section $" + name + " does not end");
  in_.move_to(end);
}

Mesh Reader::read() {
  for (std::string_view word = in_.next_word(); !word.empty(); word = in_.next_word()) {
    if (word[0] != '$' || word.substr(0, 4) == "$End") in_.fail("a section such as $Nodes was expected");
    const std::string name(word.substr(1));
    in_.line();
    if (name != "MeshFormat" && version_ == 0) in_.fail("the file must start with $MeshFormat");
    if (name == "MeshFormat") {
      read_format();
    } else if (name == "PhysicalNames") {
      read_names();
    } else if (name == "Entities" && version_ == 4) {
      read_entities();
    } else if (name == "Nodes") {
      version_ == 4 ? read_nodes_4() : read_nodes_2();
    } else if (name == "Elements") {
      version_ == 4 ? read_elements_4() : read_elements_2();
    } else {
      skip_section(name);
    }
    if (in_.next_word() != "$End" + name) in_.fail("$End" + name + " was expected");
  }
  contents_.is_binary = binary_;
  return plane_mesh(found_mesh(std::move(contents_), file_), file_);
}

}  // namespace

Mesh parse_msh(std::string_view bytes, const std::string& file) {
  const SourceFile source{bytes, file};
  return Reader(source).read();
}

}  // namespace quadline
