#include "quadline/faults.hpp"

#include <algorithm>
#include <array>
#include <limits>

#include "geom/predicates.hpp"
#include "quality/mesh_edges.hpp"
#include "search/box_tree.hpp"

namespace quadline {

namespace {

constexpr double kNothing = 1e-9;  // of the extent of the mesh

void note(MeshFault& fault, Point at) {
  if (fault.count++ == 0) fault.first = at;
}

class Search {
 public:
  explicit Search(const Mesh& mesh) : mesh_(mesh) {
    for (const auto& quad : mesh.quads) look_at(quad);
    for (const auto& triangle : mesh.triangles) look_at(triangle);
    find_duplicates();
    pair_sides();
    find_close_nodes();
  }

  std::vector<MeshFault> faults() && {
    return {repeating_, inverted_, not_convex_, duplicates_, folded_, coincident_, hanging_};
  }

 private:
  Point at(NodeIndex node) const { return mesh_.points[node]; }

  template <std::size_t N>
  void look_at(const std::array<NodeIndex, N>& element) {
    std::array<NodeIndex, 4> key;
    key.fill(UINT32_MAX);
    std::copy(element.begin(), element.end(), key.begin());
    std::sort(key.begin(), key.end());
    elements_.push_back(key);
    const auto end = key.begin() + N;
    const bool repeats = std::adjacent_find(key.begin(), end) != end;
    repeats_.push_back(repeats);
    if (repeats) return note(repeating_, at(element[0]));
    int left_turns = 0, right_turns = 0;
    for (std::size_t i = 0; i < N; ++i) {
      const int turn = orientation(at(element[i]), at(element[(i + 1) % N]), at(element[(i + 2) % N]));
      left_turns += turn > 0;
      right_turns += turn < 0;
    }
    if (left_turns == N) return;
    // A quad with two right turns crosses itself; one with one is an arrow head.
    note(right_turns > 1 ? inverted_ : not_convex_, at(element[0]));
  }

  void find_duplicates() {
    std::sort(elements_.begin(), elements_.end());
    for (std::size_t i = 1; i < elements_.size(); ++i)
      if (elements_[i] == elements_[i - 1]) note(duplicates_, at(elements_[i][0]));
  }

  /// Each edge has one element on a side at most; those with one element in all are the boundary. Elements that repeat
  /// a node do not count.
  void pair_sides() {
    const MeshEdges edges(mesh_);
    for (std::size_t e = 0; e < edges.count(); ++e) {
      int n_forward = 0, n_backward = 0;
      for (const Side& side : edges.sides(e))
        if (!repeats_[side.face]) ++(side.forward ? n_forward : n_backward);
      const auto [a, b] = edges.nodes(e);
      if (n_forward > 1 || n_backward > 1) note(folded_, midpoint(at(a), at(b)));
      if (n_forward + n_backward == 1) boundary_.push_back({a, b});
    }
  }

  /// Nodes of the boundary that lie on each other, or on an edge of it: what is conforming has neither.
  void find_close_nodes() {
    if (boundary_.empty()) return;
    std::vector<NodeIndex> nodes;
    for (const auto& edge : boundary_) nodes.insert(nodes.end(), edge.begin(), edge.end());
    std::sort(nodes.begin(), nodes.end());
    nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
    std::vector<Box> boxes;
    for (const NodeIndex node : nodes) boxes.push_back({at(node), at(node)});
    Box all = boxes[0];
    for (const Box& box : boxes) all = join(all, box);
    const double nothing = kNothing * distance(all.lo, all.hi);
    const BoxTree tree(boxes);
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      bool is_first = true;
      tree.query(inflated(boxes[i], nothing), [&](std::size_t other) {
        is_first &= other >= i || distance(at(nodes[i]), at(nodes[other])) > nothing;
      });
      if (!is_first) note(coincident_, at(nodes[i]));
    }
    for (const auto& edge : boundary_) {
      const Point a = at(edge[0]), b = at(edge[1]);
      tree.query(inflated(join({a, a}, {b, b}), nothing), [&](std::size_t i) {
        if (hangs_on(at(nodes[i]), a, b, nothing)) note(hanging_, at(nodes[i]));
      });
    }
  }

  static bool hangs_on(Point p, Point a, Point b, double nothing) {
    const Point along = b - a;
    const double length = norm(along), s = dot(p - a, along);
    return s > nothing * length && s < (length - nothing) * length && std::abs(cross(along, p - a)) <= nothing * length;
  }

  const Mesh& mesh_;
  std::vector<std::array<NodeIndex, 4>> elements_;  ///< their nodes, ascending
  std::vector<std::uint8_t> repeats_;               ///< whether they repeat a node
  std::vector<std::array<NodeIndex, 2>> boundary_;
  MeshFault repeating_{"elements that repeat a node", 0, {}}, inverted_{"inverted elements", 0, {}},
      not_convex_{"elements that are flat or not convex", 0, {}}, duplicates_{"duplicate elements", 0, {}},
      folded_{"edges with two elements on a side", 0, {}}, coincident_{"nodes at the place of another", 0, {}},
      hanging_{"hanging nodes", 0, {}};
};

}  // namespace

std::vector<MeshFault> find_faults(const Mesh& mesh) { return Search(mesh).faults(); }

}  // namespace quadline
