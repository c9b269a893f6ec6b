#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "quadline/point.hpp"

namespace quadline {

/// Index into Mesh::points, from 0.
using NodeIndex = std::uint32_t;

/// What a curve of a mesh is in the model.
enum class CurveKind {
  Outer,  ///< an outer loop
  Hole,   ///< the loop of a hole
  Line,   ///< a line constraint
};

/// The mesh edges along one curve of the model, in order along it.
struct EdgeSet {
  std::string name;                             ///< the model's, or "outer-1", "hole-2", "line-3"; no two alike
  CurveKind kind = CurveKind::Line;             ///< what it is in the model
  std::vector<std::array<NodeIndex, 2>> edges;  ///< n_edges x 2, in the direction of the curve
};

/// The node of a point constraint.
struct NodeSet {
  std::string name;              ///< the model's, no two alike
  std::vector<NodeIndex> nodes;  ///< one from `generate`; meshes from files may have more
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
