#include "quality/irregular_nodes.hpp"

#include <algorithm>
#include <cstddef>

#include "geom/element.hpp"
#include "quality/regular_quads.hpp"

namespace quadline {

namespace {

// Finds the nodes whose number of faces does not suit them. Corners of faces are joined across edges that are no
// curve: each group so made is a wedge between curves, or all that is round an inner node.
class Irregularity {
 public:
  Irregularity(const Mesh& mesh, const MeshEdges& edges) : mesh_(mesh), edges_(edges) {}

  std::vector<std::uint8_t> find_all() {
    mark_curves();
    join_wedges();
    const std::size_t n_corners = group_.size();
    std::vector<double> angle(n_corners, 0);
    std::vector<int> faces(n_corners, 0);
    std::vector<std::uint8_t> bad(mesh_.points.size(), 0);
    for (std::size_t c = 0; c < n_corners; ++c) {
      const std::size_t g = find(c);
      angle[g] += corner(c);
      ++faces[g];
    }
    for (std::size_t c = 0; c < n_corners; ++c) {
      if (find(c) != c) continue;
      const NodeIndex v = node(c);
      bad[v] |= on_curve_[v] ? quads_off(angle[c], faces[c]) != 0 : faces[c] != 4;
    }
    return bad;
  }

 private:
  void mark_curves() {
    is_curve_.assign(edges_.count() + 1, 0);  // the last: edges that are none of the mesh
    for (const EdgeSet& set : mesh_.curves)
      for (const auto& [a, b] : set.edges) is_curve_[edges_.find(a, b)] = 1;
    on_curve_.assign(mesh_.points.size(), 0);
    for (std::size_t e = 0; e < edges_.count(); ++e) {
      if (edges_.sides(e).size() == 1) is_curve_[e] = 1;
      if (is_curve_[e])
        for (const NodeIndex v : edges_.nodes(e)) on_curve_[v] = 1;
    }
  }

  std::size_t n_quads() const { return mesh_.quads.size(); }
  std::size_t first_corner(std::size_t face) const {
    return face < n_quads() ? 4 * face : 4 * n_quads() + 3 * (face - n_quads());
  }
  std::size_t n_sides(std::size_t face) const { return face < n_quads() ? 4 : 3; }
  NodeIndex node_at(std::size_t face, std::size_t i) const {
    return face < n_quads() ? mesh_.quads[face][i] : mesh_.triangles[face - n_quads()][i];
  }
  std::size_t face_of(std::size_t corner) const {
    return corner < 4 * n_quads() ? corner / 4 : n_quads() + (corner - 4 * n_quads()) / 3;
  }
  NodeIndex node(std::size_t corner) const {
    const std::size_t f = face_of(corner);
    return node_at(f, corner - first_corner(f));
  }
  double corner(std::size_t c) const {
    const std::size_t f = face_of(c), n = n_sides(f), i = c - first_corner(f);
    return corner_angle(mesh_.points[node_at(f, (i + n - 1) % n)], mesh_.points[node_at(f, i)],
                        mesh_.points[node_at(f, (i + 1) % n)]);
  }

  void join_wedges() {
    group_.resize(4 * mesh_.quads.size() + 3 * mesh_.triangles.size());
    for (std::size_t c = 0; c < group_.size(); ++c) group_[c] = static_cast<std::uint32_t>(c);
    const auto corner_at = [&](const Side& s, bool at_a) {
      const std::size_t i = s.corner, n = n_sides(s.face);
      return first_corner(s.face) + (s.forward == at_a ? i : (i + 1) % n);
    };
    for (std::size_t e = 0; e < edges_.count(); ++e) {
      if (is_curve_[e]) continue;
      const std::span<const Side> sides = edges_.sides(e);
      for (std::size_t i = 1; i < sides.size(); ++i)
        for (const bool at_a : {true, false}) {
          const std::size_t p = find(corner_at(sides[i], at_a)), q = find(corner_at(sides[i - 1], at_a));
          group_[std::max(p, q)] = static_cast<std::uint32_t>(std::min(p, q));
        }
    }
  }
  std::size_t find(std::size_t c) {
    while (group_[c] != c) c = group_[c] = group_[group_[c]];
    return c;
  }

  const Mesh& mesh_;
  const MeshEdges& edges_;
  std::vector<std::uint8_t> is_curve_, on_curve_;  // of edges; of nodes
  std::vector<std::uint32_t> group_;               // of corners: union-find
};

}  // namespace

std::vector<std::uint8_t> irregular_nodes(const Mesh& mesh, const MeshEdges& edges) {
  return Irregularity(mesh, edges).find_all();
}

}  // namespace quadline
