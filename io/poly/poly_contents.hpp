#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "io/poly/planar_graph.hpp"

namespace quadline {

/// What stands in a .poly file, as it stands there.
struct PolyContents {
  struct Hole {
    Point at;
    std::size_t line;
  };
  struct Region {
    Point at;
    double attribute;
    double max_area;  ///< of a triangle in it; 0: none
    std::size_t line;
  };

  StraightLineGraph graph;
  long long first_number = 0;  ///< of the vertices, which are numbered without gaps
  std::vector<std::size_t> vertex_lines;
  std::string node_file;  ///< where the vertices stand; empty: in the .poly file
  std::vector<Hole> holes;
  std::vector<Region> regions;

  /// "line 12", or "line 12 of plate.node".
  std::string vertex_place(std::size_t i) const {
    return "line " + std::to_string(vertex_lines[i]) + (node_file.empty() ? "" : " of " + node_file);
  }
};

/// @param file  beside it stands the .node file, where the vertices are not in the text.
/// @throws InputError  with the line.
PolyContents parse_poly(std::string_view text, const std::filesystem::path& file);

}  // namespace quadline
