#pragma once

#include <cstdint>

#include "mesh/work_mesh.hpp"

namespace quadline::cleanup {

/// What clean-up wants of a sector: the quads round an inner node, or between neighbouring constraint edges of a node.
struct IdealValence {
  std::uint8_t ideal = 4;   ///< quads that suit the angle best
  std::uint8_t second = 0;  ///< nearly as good, where the angle lies near a threshold; 0: none
  std::uint8_t least = 3;   ///< fewer quads cannot be convex, or form a doublet
  bool is_tie = false;      ///< `second` is just as good
  bool on_curve = false;
};

/// A sector and the quads it has now.
struct Sector {
  IdealValence ideal;
  int quads = 0;
};

/// Cost of a sector that cannot be convex, and of a quad that smoothing left inverted: above any sum of valences that
/// one edit can touch.
constexpr int kBroken = 1000;

/// Cost of a sector with `quads` quads: 0 is ideal; grows with the square of the difference.
int valence_cost(const IdealValence& ideal, int quads);

/// The sectors of a mesh. The curves do not change during clean-up, so what their angles want is computed once.
class Sectors {
 public:
  explicit Sectors(const WorkMesh& mesh);

  /// The sector that holds the face of the outgoing half-edge `h`. O(valence).
  Sector at(HalfId h) const;
  /// Sum of the costs of the sectors of a node. O(valence).
  int cost(NodeId v) const;

 private:
  const WorkMesh& mesh_;
  IdVector<HalfId, IdealValence> ideal_;  // by the first half-edge (clockwise end) of the sector
};

}  // namespace quadline::cleanup
