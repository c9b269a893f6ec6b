#pragma once

#include <vector>

#include "stages/cleanup/cavity.hpp"
#include "stages/cleanup/fill_patch.hpp"

namespace quadline::cleanup {

/// Grows a cavity from a node, row by row, through patches whose rims have corners and sides only.
class PatchGrower {
 public:
  PatchGrower(const WorkMesh& mesh, const Sectors& sectors, const IdVector<NodeId, double>& size)
      : mesh_(mesh), size_(size), finder_(mesh, sectors) {}

  /// The smallest patch round the node; false: there is none.
  bool start(NodeId v);
  /// The next greater patch; false: the end.
  bool grow();

  const Cavity& cavity() const { return cavity_; }
  const std::vector<PatchNode>& rim() const { return rim_; }
  int corner_count() const { return n_corners_; }
  /// Cost of the rim once the patch is filled.
  int rim_cost() const { return rim_cost_; }

 private:
  bool make_convex();
  void add_face(FaceId f);
  void add_star(NodeId v, HalfId in_sector);
  bool add_row(std::size_t from, std::size_t to);
  void describe_rim();

  const WorkMesh& mesh_;
  const IdVector<NodeId, double>& size_;
  CavityFinder finder_;
  Point center_;
  std::vector<FaceId> faces_;
  IdVector<FaceId, std::uint32_t> mark_of_;
  std::uint32_t mark_ = 0;
  Cavity cavity_;
  std::vector<PatchNode> rim_;
  int n_rows_ = 0, n_corners_ = 0, rim_cost_ = 0;
  // Of `grow`, which is called too often to allocate
  struct Side {
    double distance;  // of its middle from the start
    std::size_t from, to;
  };
  std::vector<std::size_t> corners_;
  std::vector<Side> sides_;
  std::vector<FaceId> kept_;
};

}  // namespace quadline::cleanup
