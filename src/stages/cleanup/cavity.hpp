#pragma once

#include <array>
#include <span>
#include <vector>

#include "stages/cleanup/sectors.hpp"

namespace quadline::cleanup {

/// Quads that form a disk: its rim meets every node once, no constraint runs inside, all inner nodes are free.
struct Cavity {
  struct RimNode {
    NodeId node;
    HalfId half;         ///< rim half-edge that leaves the node, cavity on its left
    IdealValence ideal;  ///< of the sector that the cavity lies in
    int inside = 0;      ///< quads of the sector in the cavity
    int outside = 0;     ///< and the others
  };
  std::vector<FaceId> faces;
  std::vector<RimNode> rim;  ///< counter-clockwise
  std::vector<NodeId> inner;
  int inner_index = 0;  ///< sum of 4 - valence of the inner nodes
  int cost = 0;         ///< valence cost of all its sectors
};

/// What shall stand in the place of a cavity.
struct Replacement {
  std::vector<NodeId> inner;                        ///< nodes inside that stay; invalid: new
  std::vector<std::array<std::uint16_t, 4>> quads;  ///< 0 .. n_rim-1: the rim; then `inner`
};

/// What no replacement can go below: the sum of the signed differences of the valences is the same for all.
int least_cost(const Cavity& cavity);

/// Valence cost of all sectors of the cavity once the replacement stands in its place.
int cost_after(const Cavity& cavity, const Replacement& replacement);

/// Collects cavities; keeps the marks that this needs.
class CavityFinder {
 public:
  CavityFinder(const WorkMesh& mesh, const Sectors& sectors) : mesh_(mesh), sectors_(sectors) {}

  /// Fills `cavity` from its faces (no face twice). False: they do not form one. O(faces).
  bool collect(std::span<const FaceId> faces, Cavity& cavity);

 private:
  bool is_inside(HalfId h) const {
    const FaceId f = mesh_.topo().face(h);
    return f.valid() && face_mark_[f] == mark_;
  }
  bool walk_rim(HalfId start, std::size_t n_rim, Cavity& cavity);

  const WorkMesh& mesh_;
  const Sectors& sectors_;
  IdVector<FaceId, std::uint32_t> face_mark_;
  IdVector<NodeId, std::uint32_t> node_mark_;
  std::uint32_t mark_ = 0;
};

}  // namespace quadline::cleanup
