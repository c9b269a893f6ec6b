#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "base/id.hpp"

namespace quadline {

/// The half-edges of an edge differ in the last bit; nothing is stored for it.
constexpr HalfId twin(HalfId h) { return HalfId(h.value ^ 1u); }
constexpr EdgeId edge_of(HalfId h) { return EdgeId(h.value >> 1); }
constexpr HalfId half_of(EdgeId e, int side = 0) { return HalfId(2 * std::size_t{e.value} + side); }

/// The corners of a triangle or a quad, counter-clockwise.
struct Polygon {
  std::array<NodeId, 4> nodes;
  int n = 0;

  Polygon() = default;
  Polygon(NodeId a, NodeId b, NodeId c) : nodes{a, b, c, NodeId()}, n(3) {}
  Polygon(NodeId a, NodeId b, NodeId c, NodeId d) : nodes{a, b, c, d}, n(4) {}
  std::span<const NodeId> corners() const& { return {nodes.data(), static_cast<std::size_t>(n)}; }
  std::span<const NodeId> corners() const&& = delete;  // it would outlive its nodes
};

/// Connectivity of a plane mesh of triangles and quads, as half-edges; no coordinates.
///
/// A half-edge runs from `tail` to `head` with its face on the left; an invalid face is the outside, whose half-edges
/// are linked as well. Slots of deleted elements are re-used: iterate over `nodes()`, `edges()` and `faces()`, which
/// skip them, and `compact` at the end of a stage.
class Topology {
 public:
  /// The live elements of a kind in the order of their ids, for range-based loops. Elements may be removed on the way;
  /// slots that are added on the way are not met.
  template <class IdType>
  class Live {
   public:
    class Iterator {
     public:
      Iterator(const Topology& topo, IdType at, IdType end) : topo_(topo), at_(at), end_(end) { skip_deleted(); }
      IdType operator*() const { return at_; }
      Iterator& operator++() {
        ++at_.value;
        skip_deleted();
        return *this;
      }
      bool operator!=(const Iterator& other) const { return at_ != other.at_; }

     private:
      void skip_deleted() {
        while (at_ != end_ && !topo_.is_live(at_)) ++at_.value;
      }
      const Topology& topo_;
      IdType at_, end_;
    };
    Live(const Topology& topo, std::size_t capacity) : topo_(topo), end_(capacity) {}
    Iterator begin() const { return {topo_, IdType(0), end_}; }
    Iterator end() const { return {topo_, end_, end_}; }

   private:
    const Topology& topo_;
    IdType end_;
  };
  Live<NodeId> nodes() const { return {*this, node_capacity()}; }
  Live<EdgeId> edges() const { return {*this, edge_capacity()}; }
  Live<FaceId> faces() const { return {*this, face_capacity()}; }

  // Size: live elements, and slots (live or not)
  std::size_t node_count() const { return out_.count() - free_nodes_.size(); }
  std::size_t edge_count() const { return half_.count() / 2 - free_edges_.size(); }
  std::size_t face_count() const { return first_.count() - free_faces_.size(); }
  std::size_t node_capacity() const { return out_.count(); }
  std::size_t edge_capacity() const { return half_.count() / 2; }
  std::size_t face_capacity() const { return first_.count(); }
  bool is_live(NodeId v) const { return out_[v] != kDeleted; }
  bool is_live(EdgeId e) const { return half_[half_of(e)].tail.valid(); }
  bool is_live(FaceId f) const { return first_[f].valid(); }

  // Walking
  NodeId tail(HalfId h) const { return half_[h].tail; }
  NodeId head(HalfId h) const { return half_[twin(h)].tail; }
  HalfId next(HalfId h) const { return half_[h].next; }
  HalfId prev(HalfId h) const { return half_[h].prev; }
  FaceId face(HalfId h) const { return half_[h].face; }
  HalfId first(FaceId f) const { return first_[f]; }
  /// An outgoing half-edge; invalid where the node has no edge.
  HalfId out(NodeId v) const { return out_[v] == kDeleted ? HalfId() : out_[v]; }
  /// The next outgoing half-edge of the same node.
  HalfId rotate_ccw(HalfId h) const { return twin(prev(h)); }
  HalfId rotate_cw(HalfId h) const { return next(twin(h)); }
  /// Half-edge from a to b; invalid where there is none. O(valence).
  HalfId find(NodeId a, NodeId b) const;
  bool is_triangle(FaceId f) const { return next(next(next(first_[f]))) == first_[f]; }
  int sides(FaceId f) const { return is_triangle(f) ? 3 : 4; }
  Polygon polygon(FaceId f) const;
  int edge_valence(NodeId v) const;

  /// Calls `visit(HalfId)` for each outgoing half-edge of v, counter-clockwise.
  template <class Visit>
  void for_each_out(NodeId v, Visit visit) const {
    const HalfId start = out(v);
    if (!start.valid()) return;
    HalfId h = start;
    do {
      const HalfId following = rotate_ccw(h);
      visit(h);
      h = following;
    } while (h != start);
  }
  /// Calls `visit(HalfId)` for each half-edge of f, counter-clockwise.
  template <class Visit>
  void for_each_half(FaceId f, Visit visit) const {
    const HalfId start = first_[f];
    HalfId h = start;
    do {
      const HalfId following = next(h);
      visit(h);
      h = following;
    } while (h != start);
  }

  // Editing. All are O(1) or linear in what they touch. Precondition of each: what its name says exists.
  NodeId add_node();
  void remove_node(NodeId v);  ///< isolated nodes only

  /// Makes the mesh of `polygons` over `n_nodes` nodes; whatever was there is gone. Faces may meet in a node only;
  /// where three or more fans do, their order round it need not be that of the plane.
  void build(std::size_t n_nodes, std::span<const Polygon> polygons);

  /// Triangle into three, round `v` (isolated). Slot f stays one of them; returns the two new faces.
  std::array<FaceId, 2> split_face(FaceId f, NodeId v);

  /// Edge a-b into a-v and v-b, `v` isolated; triangles beside it are split in two, the outside is not. Edge e becomes
  /// a-v (a: tail of half_of(e)). Returns the new edge v-b.
  EdgeId split_edge(EdgeId e, NodeId v);

  /// Turns the diagonal of the two triangles beside e; e stays the edge.
  void swap_edge(EdgeId e);

  /// Takes a face away: its place becomes outside. Edges without a face go; nodes stay.
  void remove_face(FaceId f);

  /// Replaces the faces of a cavity by polygons that fill the same boundary; the general edit.
  ///
  /// Edges between two faces of the cavity go and are made anew where the polygons ask for them; nodes that no longer
  /// have an edge are removed. Nodes of the polygons that were not in the cavity must be isolated.
  ///
  /// @param made   the new faces, in the order of `polygons`.
  /// @param fresh  the new edges, by one of their half-edges.
  void replace_cavity(std::span<const FaceId> faces, std::span<const Polygon> polygons, std::vector<FaceId>& made,
                      std::vector<HalfId>& fresh);

  /// Maps from old ids to new ones; invalid: deleted.
  struct Renumbering {
    IdVector<NodeId, NodeId> node;
    IdVector<EdgeId, EdgeId> edge;
    IdVector<FaceId, FaceId> face;
  };
  /// Closes the gaps that deleted elements left, in the order of the ids.
  Renumbering compact();
  /// Closes the gaps and puts the faces into the given order; edges and nodes in the order in which faces meet them.
  /// @param order  every live face once.
  Renumbering reorder(std::span<const FaceId> order);

  /// First broken invariant as text, empty when there is none. O(n).
  const char* defect() const;

 private:
  struct Half {
    NodeId tail;
    HalfId next, prev;
    FaceId face;
  };
  static constexpr HalfId kDeleted{UINT32_MAX - 1};

  void apply(const Renumbering& map, std::size_t n_nodes, std::size_t n_edges, std::size_t n_faces);
  EdgeId add_edge(NodeId a, NodeId b);
  void free_edge(EdgeId e);
  FaceId add_face(HalfId first);
  void link(HalfId a, HalfId b) {
    half_[a].next = b;
    half_[b].prev = a;
  }
  void close_triangle(FaceId f, HalfId a, HalfId b, HalfId c);
  void unlink_edge(EdgeId e);
  const char* defect_of_halves() const;
  const char* defect_of_faces() const;
  const char* defect_of_nodes() const;

  IdVector<HalfId, Half> half_;
  IdVector<NodeId, HalfId> out_;
  IdVector<FaceId, HalfId> first_;
  std::vector<NodeId> free_nodes_;
  std::vector<EdgeId> free_edges_;
  std::vector<FaceId> free_faces_;
  struct {
    std::vector<HalfId> rim, open;
    std::vector<EdgeId> inside;
    std::vector<NodeId> nodes;
  } scratch_;  // of replace_cavity, which is called too often to allocate
};

}  // namespace quadline
