#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "quadline/point.hpp"

namespace quadline {

using NodeIndex = std::uint32_t;

enum class CurveKind { Outer, Hole, Line };

/// The mesh edges along one curve of the model, in order along it.
struct EdgeSet {
  std::string name;
  CurveKind kind = CurveKind::Line;
  std::vector<std::array<NodeIndex, 2>> edges;  ///< n_edges x 2, in the direction of the curve
};

/// The node of a point constraint.
struct NodeSet {
  std::string name;
  std::vector<NodeIndex> nodes;
};

/// A mesh as users see it: flat arrays, no connectivity.
struct Mesh {
  std::vector<Point> points;                        ///< n_nodes x 2, model units
  std::vector<std::array<NodeIndex, 4>> quads;      ///< n_quads x 4, counter-clockwise
  std::vector<std::array<NodeIndex, 3>> triangles;  ///< only in snapshots of early stages and in foreign meshes
  std::vector<std::uint32_t> quad_region;           ///< n_quads; index into `regions`
  std::vector<std::uint32_t> triangle_region;       ///< n_triangles; index into `regions`
  std::vector<std::string> regions;                 ///< names; cells that the model does not name are "domain"
  std::vector<EdgeSet> curves;                      ///< boundary loops ("outer-1", "hole-1", ...) and named lines
  std::vector<NodeSet> node_sets;                   ///< a node for every named point
};

}  // namespace quadline
