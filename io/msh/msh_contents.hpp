#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "io/found/found_mesh.hpp"

namespace quadline {

/// What stands in an MSH file, as it stands there.
struct MshContents {
  using Groups = std::vector<int>;  ///< physical tags
  struct Element {
    std::int64_t number;
    int n_nodes;  ///< 1 point, 2 line, 3 triangle, 4 quad
    std::int64_t nodes[4];
    std::size_t at;  ///< in the file, for errors
    const Groups* groups;
  };
  using GroupId = std::pair<int, int>;  ///< dimension, physical tag

  bool is_binary = false;
  std::map<GroupId, std::string> names;
  std::vector<GroupId> named;                                ///< in the order of the file
  std::map<std::pair<int, std::int64_t>, Groups> of_entity;  ///< by (dimension, entity)
  std::set<Groups> of_elements;                              ///< version 2, where elements name their group
  Numbering nodes;                                           ///< of points and z of `found`
  std::vector<Element> elements;
  FoundMesh found;
};

/// Turns it into arrays, nodes and elements in the order of their numbers: groups of dimension 2, 1 and 0 become
/// regions, curves and node sets, named or "region-7", "line-7", "point-7". Faces without a group are in "domain".
/// @throws InputError  a number comes twice or names nothing.
FoundMesh found_mesh(MshContents contents, const SourceFile& file);

}  // namespace quadline
