#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "io/found/found_mesh.hpp"

namespace quadline {

std::string upper_case(std::string_view text);  ///< ASCII letters only

/// The sets of one kind in an Abaqus file, as they are given: resolved when all is read, for they may name what comes
/// later.
class InpSets {
 public:
  struct Item {
    std::int64_t first, last, step;  ///< numbers of nodes or elements
    std::string other;               ///< the name of another set, in place of numbers
    std::size_t at;                  ///< in the file, for errors
  };
  struct Set {
    std::string name;  ///< as spelled first
    std::vector<Item> items;
  };

  /// The set of that name, whatever its case; made where there is none.
  Set& named(const std::string& name);
  bool has(const std::string& name) const { return by_name_.count(upper_case(name)) > 0; }
  const std::vector<Set>& all() const { return all_; }  ///< in the order of the file

  /// Indices of the members, in the order in which the set names them; numbers that are not there are passed over.
  /// @throws InputError  it names a set that is not there; the sets together are out of proportion to the file.
  std::vector<std::uint32_t> members(const Set& set, const Numbering& numbering, const SourceFile& file);

 private:
  void add_members(const Set& set, const Numbering& numbering, const SourceFile& file, int depth,
                   std::vector<std::uint32_t>& out);

  std::vector<Set> all_;
  std::map<std::string, std::size_t> by_name_;  ///< upper case
  std::size_t n_members_ = 0;                   ///< resolved so far
};

/// What stands in an Abaqus file, as it stands there.
struct InpContents {
  struct Element {
    std::size_t n_nodes;  ///< 2 line, 3 triangle, 4 quad
    std::int64_t nodes[4];
    std::size_t at;  ///< in the file, for errors
  };

  Numbering node_numbers;  ///< of points and z of `found`
  FoundMesh found;
  Numbering element_numbers;  ///< of `elements`
  std::vector<Element> elements;
  InpSets node_sets, element_sets;
};

/// Turns it into arrays, nodes and elements in the order of their numbers. A face is in the region of the first set
/// that names it, else in "domain"; every set with lines is a curve; node sets stay, but for those that only repeat an
/// element set or name all nodes.
/// @throws InputError  a number comes twice or names nothing.
FoundMesh found_mesh(InpContents contents, const SourceFile& file);

}  // namespace quadline
