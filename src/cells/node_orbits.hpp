#pragma once

#include <vector>

#include "domain/domain.hpp"
#include "domain/symmetry/symmetries.hpp"
#include "mesh/work_mesh.hpp"

namespace quadline {

/// The nodes of a mesh that the symmetries of its domain take to each other, to make them alike again after smoothing,
/// which takes one after the other.
class NodeOrbits {
 public:
  /// What is passed but the mesh must outlive this. O(n log n).
  NodeOrbits(const WorkMesh& mesh, const Domain& domain, const std::vector<Symmetry>& symmetries);

  /// Puts every node at the mean of where its images would have it, on curves by the arc length: by the largest group
  /// of symmetries under which it has all of them, with all their edges. An orbit stays as it is where a quad would
  /// lose more than a fifth of its scaled Jacobian. O(n).
  /// @param mesh  the same.
  void even_out(WorkMesh& mesh) const;

 private:
  struct Place {
    Point at;
    double s;  ///< of nodes on curves
  };
  using Group = std::vector<std::size_t>;  ///< symmetries, by their places
  struct Entry {
    NodeId node;  ///< free or on a curve
    std::size_t group;
  };
  bool may_move(const NodeTag& tag) const;
  bool has_images(const Topology& topo, NodeId v, const Group& group) const;
  Place mean_place(const WorkMesh& mesh, const Entry& entry) const;
  static void put(WorkMesh& mesh, NodeId v, const Place& place);
  const Domain& domain_;
  const std::vector<Symmetry>& symmetries_;
  std::vector<IdVector<NodeId, NodeId>> images_;  ///< by each symmetry
  std::vector<Group> groups_;
  std::vector<Entry> nodes_;  ///< that have images
};

}  // namespace quadline
