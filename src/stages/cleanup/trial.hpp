#pragma once

#include <span>
#include <vector>

#include "base/csr.hpp"
#include "stages/cleanup/cavity.hpp"
#include "stages/cleanup/star.hpp"

namespace quadline::cleanup {

/// How good some quads are.
struct PatchQuality {
  double least_jacobian = 1;
  double mean_beta = 1;
  int n_quads = 0;
  int n_broken = 0;        ///< quads that are not convex, or nearly so
  double size_error = 1;   ///< greatest factor between an edge and the limits of its size; 1: all within
  double size_spread = 0;  ///< mean of r + 1 / r - 2 with r = edge over size; about ln^2 r
};

/// Builds a replacement beside the mesh, with the quads round the cavity, smooths it there, and measures it: the mesh
/// itself changes only when the result is accepted.
class Trial {
 public:
  Trial(const WorkMesh& mesh, const IdVector<NodeId, double>& size) : mesh_(mesh), size_(size) {}

  /// False where the replacement cannot stand: an edge that exists outside the cavity would be made again.
  bool build(const Cavity& cavity, const Replacement& replacement);
  void smooth(int sweeps);

  /// Of the cavity and the quads round it as they are now in the mesh.
  PatchQuality quality_now() const;
  PatchQuality quality() const;

  /// Carries the trial out. `nodes`: all nodes of the replacement, rim first. `size` gets the new nodes' sizes.
  void commit(WorkMesh& mesh, IdVector<NodeId, double>& size, std::vector<NodeId>& nodes);

 private:
  using Quad = std::array<std::uint32_t, 4>;  // into nodes_
  struct Node {
    NodeId id;  // invalid: new
    Point at;
    double size;
    bool may_move;
  };
  bool duplicates_an_edge() const;
  void place_inner_nodes();
  void add_ring();
  void make_stars();
  std::uint32_t local(NodeId v);

  const WorkMesh& mesh_;
  const IdVector<NodeId, double>& size_;
  const Cavity* cavity_ = nullptr;
  std::uint32_t n_rim_ = 0, n_own_ = 0;  // own: rim and inner nodes, the rest belongs to the ring
  std::size_t n_own_quads_ = 0;
  std::vector<Node> nodes_;
  std::vector<Quad> quads_;  // the replacement, then the ring
  std::vector<FaceId> ring_;
  struct StarEntry {
    std::uint32_t next, opposite, previous;
  };
  Rows<StarEntry> stars_;  // of nodes_
  std::vector<StarQuad> star_quads_;
  struct Slot {
    std::uint32_t mark = 0, index = 0;
  };
  IdVector<NodeId, Slot> slot_;
  IdVector<FaceId, std::uint32_t> face_mark_;
  std::uint32_t mark_ = 0;
  std::vector<Polygon> polygons_;  // of a commit
  std::vector<FaceId> made_;
};

}  // namespace quadline::cleanup
