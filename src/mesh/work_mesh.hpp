#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "base/id.hpp"
#include "geom/angles.hpp"
#include "geom/element.hpp"
#include "quadline/point.hpp"
#include "topo/topology.hpp"

namespace quadline {

enum class NodeKind : std::uint8_t {
  Free,     ///< inside a cell: goes where smoothing wants it
  OnCurve,  ///< inside a curve: slides along it, or stays
  Fixed,    ///< at a vertex of the domain: stays
};

/// Where a node belongs.
struct NodeTag {
  NodeKind kind = NodeKind::Free;
  CurveId curve;    ///< OnCurve: which
  double s = 0;     ///< OnCurve: arc length along it
  VertexId vertex;  ///< Fixed: which
};

/// An edge that the mesh must have: between neighbouring nodes of a curve, in its direction.
struct Segment {
  NodeId a, b;
  CurveId curve;
};

/// Why a local operator may not be applied.
enum class Refusal { None, OnBoundary, OnConstraint, NotTriangles, WouldInvert };

/// The mesh that flows through the stages: connectivity, points, and what they belong to.
///
/// It is also the gate: the one place that knows what a constraint forbids. Editing goes through it, so that the
/// arrays follow the connectivity; `can_...` and `is_free` say what may be edited.
class WorkMesh {
 public:
  const Topology& topo() const { return topo_; }

  // Nodes
  Point point(NodeId v) const { return point_[v]; }
  const NodeTag& tag(NodeId v) const { return tag_[v]; }
  /// Belongs to no constraint: edits may move it and take it away.
  bool is_free(NodeId v) const { return tag_[v].kind == NodeKind::Free; }
  NodeId add_node(Point p, const NodeTag& tag = {});
  void move(NodeId v, Point p) { point_[v] = p; }  ///< free nodes
  void slide(NodeId v, double s, Point p);         ///< nodes on curves: to the place s of their curve, at p

  // Edges
  CurveId curve(EdgeId e) const { return curve_[e]; }
  /// Of a curve, or of a frozen face.
  bool is_constraint(EdgeId e) const { return is_constraint_[e] != 0; }
  bool is_constraint(HalfId h) const { return is_constraint(edge_of(h)); }
  /// The face on one side is outside the domain.
  bool is_boundary(EdgeId e) const { return is_outside(half_of(e, 0)) || is_outside(half_of(e, 1)); }
  void set_curve(EdgeId e, CurveId c) {
    curve_[e] = c;
    is_constraint_[e] = c.valid();
  }
  double edge_length(EdgeId e) const {
    return distance(point(topo_.tail(half_of(e, 0))), point(topo_.tail(half_of(e, 1))));
  }

  // Faces
  CellId cell(FaceId f) const { return cell_[f]; }
  void set_cell(FaceId f, CellId c) { cell_[f] = c; }
  /// Outside the domain: no face, or a face of no cell (as the triangulation has until `drop_outside`).
  bool is_outside(HalfId h) const {
    const FaceId f = topo_.face(h);
    return !f.valid() || !cell_[f].valid();
  }
  bool is_triangle(HalfId h) const { return topo_.face(h).valid() && topo_.is_triangle(topo_.face(h)); }
  QuadPoints quad_points(FaceId f) const;

  // Sectors: the gaps between neighbouring constraint edges round a node of a curve
  /// Calls `visit(first, last, angle)` for each sector inside the domain: from half-edge `first` counter-clockwise to
  /// half-edge `last`, both constraints and outgoing; the same where the node ends an open line (a full turn).
  template <class Visit>
  void for_each_sector(NodeId v, Visit visit) const;
  /// From a to b counter-clockwise, both outgoing half-edges of one node.
  Angle angle_between(HalfId a, HalfId b) const;

  // The gate: what an edit may reach
  /// From the face on the left of h across it to the other.
  Refusal can_cross(HalfId h) const {
    if (is_constraint(h)) return Refusal::OnConstraint;
    return topo_.face(twin(h)).valid() ? Refusal::None : Refusal::OnBoundary;
  }
  /// Two triangles may become one quad.
  Refusal can_merge(EdgeId e) const {
    if (is_constraint(e)) return Refusal::OnConstraint;
    const FaceId f = topo_.face(half_of(e, 0)), g = topo_.face(half_of(e, 1));
    if (!f.valid() || !g.valid()) return Refusal::OnBoundary;
    return topo_.is_triangle(f) && topo_.is_triangle(g) ? Refusal::None : Refusal::NotTriangles;
  }
  /// Other faces may come in the place of a face; those of a cavity must reach each other by `can_cross` as well, and
  /// the nodes inside must be free.
  Refusal can_replace(FaceId f) const { return is_frozen(f) ? Refusal::OnConstraint : Refusal::None; }

  // Local operators; each has its question
  Refusal can_swap(EdgeId e) const;  ///< also exact convexity
  void swap_edge(EdgeId e);
  /// Splits an edge at p; where it is a constraint the tag says where on the curve the new node lies.
  NodeId split_edge(EdgeId e, Point p, const NodeTag& tag = {});
  void split_edge(EdgeId e, NodeId v);                            ///< the same at an isolated node
  NodeId split_face(FaceId f, Point p, const NodeTag& tag = {});  ///< a triangle into three
  void split_face(FaceId f, NodeId v);                            ///< the same at an isolated node
  /// See Topology::replace_cavity; the new faces get the cell of the first old one, which all must share. They must
  /// have every constraint that lies inside the cavity.
  void replace_cavity(std::span<const FaceId> faces, std::span<const Polygon> polygons, std::vector<FaceId>& made);

  /// Holds a face as it is until `thaw`: its nodes stay where they are, its edges count as constraints.
  void freeze(FaceId f);
  void thaw();
  bool is_frozen(FaceId f) const;

  // Whole mesh
  void build(std::vector<Point> points, std::vector<NodeTag> tags, std::span<const Polygon> polygons);
  /// Makes all that is not of the cell outside. @pre no segment is beside other cells alone.
  void keep_cell(CellId c);
  /// Removes the faces of no cell, and the nodes that are left without an edge.
  void drop_outside();
  /// Closes the gaps that deleted elements left.
  void compact();
  /// The same, and puts elements that are near each other near each other in memory: later stages walk the mesh.
  void sort_in_space();

  /// Nodes of curves in order, from the discretisation; the triangulation makes them edges.
  const std::vector<Segment>& segments() const { return segments_; }
  void add_segment(const Segment& s) { segments_.push_back(s); }
  void set_segments(std::vector<Segment> all) { segments_ = std::move(all); }

 private:
  void find_constraints_inside(std::span<const FaceId> faces);
  void fit();  ///< grows the arrays after the connectivity
  void follow(const Topology::Renumbering& map);
  Topology topo_;
  IdVector<NodeId, Point> point_;
  IdVector<NodeId, NodeTag> tag_;
  IdVector<EdgeId, CurveId> curve_;
  IdVector<EdgeId, std::uint8_t> is_constraint_;
  IdVector<FaceId, CellId> cell_;
  std::vector<Segment> segments_;
  // Of replace_cavity, which is called too often to allocate.
  std::vector<Segment> inside_;
  std::vector<HalfId> fresh_;
};

/// The valence (number of quads) that suits a node best: 4 inside, the sum over the sectors on curves.
int ideal_quads(const WorkMesh& mesh, NodeId v);

/// First broken invariant, empty when there is none: connectivity, orientation, simple faces, tags. O(n).
std::string defect(const WorkMesh& mesh);

template <class Visit>
void WorkMesh::for_each_sector(NodeId v, Visit visit) const {
  const HalfId start = topo_.out(v);
  if (!start.valid()) return;
  HalfId first_constraint;
  topo_.for_each_out(v, [&](HalfId h) {
    if (!first_constraint.valid() && is_constraint(h)) first_constraint = h;
  });
  if (!first_constraint.valid()) return;
  HalfId from = first_constraint;
  do {
    HalfId to = topo_.rotate_ccw(from);
    while (!is_constraint(to)) to = topo_.rotate_ccw(to);
    if (!is_outside(from)) visit(from, to, angle_between(from, to));
    from = to;
  } while (from != first_constraint);
}

}  // namespace quadline
