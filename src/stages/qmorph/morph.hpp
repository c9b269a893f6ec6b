#pragma once

#include <utility>
#include <vector>

#include "domain/size/size_field.hpp"
#include "quadline/report.hpp"
#include "stages/qmorph/front.hpp"
#include "stages/qmorph/parity.hpp"

namespace quadline {

/// The worker of Q-Morph: one step of the front at a time. Every step either succeeds, or leaves a valid triangulation
/// ahead of the front and the front as it was.
class Morph {
 public:
  /// @throws InternalError  the edges round a cell are odd in number.
  Morph(WorkMesh& mesh, const SizeField& size);

  const WorkMesh& mesh() const { return mesh_; }
  /// Nodes whose corners the last successful step changed.
  const std::vector<NodeId>& touched() const { return touched_; }
  /// What the steps have done up to now.
  const MorphCounts& counts() const { return counts_; }
  /// Layers of quads between a front edge and where the front began.
  int level(EdgeId e) const { return e.value < level_.count() ? level_[e] : 0; }

  void set_level(EdgeId e, int level);

  // Steps; false: refused
  bool close_loop(HalfId base);           // closure.cpp: a loop of four or six edges
  bool seam(const Corner& corner);        // seam.cpp: joins the two front edges of a sharp corner
  bool transition(const Corner& corner);  // transition.cpp: one front edge much longer than its neighbour
  bool form_quad(HalfId base);            // form_quad.cpp: the normal step
  /// All triangles that are left, whatever the front.
  void complete();  // complete.cpp

  // Parts of the normal step
  enum class End { Tail, Head };  ///< of the base edge
  /// The far end of the side edge at a corner of the base edge, after swaps or splits; invalid: none.
  NodeId side_edge(const Corner& corner, End end);  // side_edge.cpp
  /// Half-edge from a to b, after swaps; invalid where it would cross a front, a constraint or a node.
  HalfId recover_edge(NodeId a, NodeId b);  // top_edge.cpp

 private:
  // side_edge.cpp
  NodeId reuse_edge(const Corner& corner, Point direction, double least_cosine, NodeId foot);
  NodeId swap_for_edge(const Corner& corner, HalfId cut, Point direction, double longest, NodeId foot);
  NodeId split_for_edge(const Corner& corner, HalfId cut, Point direction);
  NodeId shorten_edge(HalfId side);

  // form_quad.cpp
  bool enclosed_triangles(HalfId start, const std::vector<EdgeId>& rim, std::vector<FaceId>& inside) const;
  bool is_good_enough(const Polygon& quad) const;
  void put_quads(const std::vector<FaceId>& cavity, const std::vector<Polygon>& quads, int level);
  NodeId add_free_node(HalfId split, Point p);

  // local_smoothing.cpp
  void smooth_around(const std::vector<NodeId>& nodes);
  Point front_target(NodeId v) const;
  bool try_move(NodeId v, Point p);

  double size_at(Point p) const { return size_.at(p); }
  bool is_held(EdgeId e) const { return e == held_; }
  bool may_insert() const { return insertions_ > 0; }
  bool is_transition(NodeId v) const { return v.value < transition_.count() && transition_[v] != 0; }

  WorkMesh& mesh_;
  const SizeField& size_;
  Parity parity_;
  IdVector<EdgeId, int> level_;
  IdVector<NodeId, std::uint8_t> transition_;  // nodes made by a transition: their quads are not split again
  EdgeId held_;                                // a side edge that the rest of the step must not swap or split
  std::size_t insertions_;                     // nodes that may still be inserted: so the front ends for certain
  MorphCounts counts_;
  std::vector<NodeId> touched_;
  std::vector<EdgeId> suspects_;
};

}  // namespace quadline
