#pragma once

#include "domain/size/size_field.hpp"
#include "mesh/work_mesh.hpp"
#include "quadline/context.hpp"

namespace quadline {

/// A frame of two orthogonal directions, by the first; a unit vector.
using Frame = Point;

constexpr double kMarchShare = 0.6;  ///< of the stage's progress, where rows are marched first

/// How near a new point may come to what is there, in parts of the local size.
struct Spacing {
  double to_nodes;        ///< in the norm of the frame (largest of the two components), or Euclid's without a frame
  double to_constraints;  ///< to constraint edges
  bool framed;
};

/// Inserts points into a triangulation where they are not too near to what is there; the triangulation itself answers
/// what is near, so that no second search structure has to follow.
class Insertion {
 public:
  Insertion(WorkMesh& mesh, const SizeField& size) : mesh_(mesh), size_(size) {}

  /// Inserts a free node at p, which the triangle f holds; invalid where it comes too near.
  NodeId try_insert(Point p, FaceId f, const Spacing& spacing, Frame frame);

  /// The triangle that holds p, reached straight from the node v; invalid where a constraint is in the way.
  FaceId walk(NodeId v, Point p) const;

 private:
  bool too_near(Point p, FaceId f, double h, const Spacing& spacing, Frame frame);

  WorkMesh& mesh_;
  const SizeField& size_;
  std::vector<NodeId> near_;
};

/// Fills the cells by subdividing edges after the local size until none is too long [BorouchakiGeorge1997].
/// @param done  the part of the stage that is done before, 0..1, for the progress.
void subdivide_edges(WorkMesh& mesh, const SizeField& size, double done, Context& context);

/// Fills the cells in rows from the constraints inwards, at right angles to them [Remacle2013].
void march_from_constraints(WorkMesh& mesh, const SizeField& size, Context& context);

}  // namespace quadline
