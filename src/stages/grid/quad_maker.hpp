#pragma once

#include <cstddef>
#include <vector>

#include "mesh/work_mesh.hpp"
#include "stages/grid/walk_nodes.hpp"

namespace quadline {

/// Collects the quads of a cell, and what is new of its nodes.
class QuadMaker {
 public:
  /// @param mesh  nodes and segments of the cell.
  explicit QuadMaker(const WorkMesh& mesh);

  const std::vector<Point>& points() const { return points_; }
  Point point(NodeId v) const { return points_[v.value]; }

  NodeId add_node(Point p);
  void add_quad(NodeId a, NodeId b, NodeId c, NodeId d) { quads_.emplace_back(a, b, c, d); }

  /// From the nodes of a hole to those of a rim round it, each beside its own.
  void add_rings(const std::vector<NodeId>& circle, const std::vector<NodeId>& rim, int rings);

  /// The nodes of a hole, counter-clockwise, each beside its node of the rim: from the one in the direction of the
  /// first on, round the hole as long as they fit better.
  std::vector<NodeId> circle_of(const NodeWalk& hole, Point centre, const std::vector<NodeId>& rim) const;

  /// The end: `mesh` gets it all.
  void build(WorkMesh& mesh, CellId c);

 private:
  std::size_t best_from(std::size_t first, std::size_t step, const std::vector<NodeId>& circle,
                        const std::vector<NodeId>& rim) const;

  std::vector<Point> points_;
  std::vector<NodeTag> tags_;
  std::vector<Polygon> quads_;
};

}  // namespace quadline
