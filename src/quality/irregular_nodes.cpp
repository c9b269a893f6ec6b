#include "quality/irregular_nodes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "geom/element.hpp"

namespace quadline {

namespace {

// Finds the nodes whose number of faces does not suit them. Corners of faces are joined across edges that are no
// curve: each group so made is a wedge between curves, or all that is round an inner node.
class Irregularity {
 public:
  Irregularity(const Mesh& mesh, const std::vector<Side>& sides) : mesh_(mesh), sides_(sides) {}

  std::vector<std::uint8_t> find_all() {
    mark_curves();
    join_wedges();
    const std::size_t n_corners = group_.size();
    std::vector<double> angle(n_corners, 0);
    std::vector<std::uint32_t> faces(n_corners, 0);
    std::vector<std::uint8_t> bad(mesh_.points.size(), 0);
    for (std::size_t c = 0; c < n_corners; ++c) {
      const std::size_t g = find(c);
      angle[g] += corner(c);
      ++faces[g];
    }
    for (std::size_t c = 0; c < n_corners; ++c) {
      if (find(c) != c) continue;
      const NodeIndex v = node(c);
      bad[v] |= on_curve_[v] ? !suits(angle[c], faces[c]) : faces[c] != 4;
    }
    return bad;
  }

 private:
  static bool suits(double angle, std::uint32_t faces) {
    const double degrees = angle * 180 / std::numbers::pi;
    const double least = std::max(1.0, std::round((degrees - 2) / 90)),
                 most = std::max(1.0, std::round((degrees + 2) / 90));
    return faces >= least && faces <= most;
  }

  void mark_curves() {
    on_curve_.assign(mesh_.points.size(), 0);
    std::vector<std::array<NodeIndex, 2>> curve_edges;
    for (const EdgeSet& set : mesh_.curves)
      for (const auto& [a, b] : set.edges) curve_edges.push_back({std::min(a, b), std::max(a, b)});
    std::sort(curve_edges.begin(), curve_edges.end());
    curve_.assign(sides_.size(), 0);
    for (std::size_t i = 0; i < sides_.size(); ++i) {
      const Side& s = sides_[i];
      const bool shared =
          (i > 0 && same_edge(s, sides_[i - 1])) || (i + 1 < sides_.size() && same_edge(s, sides_[i + 1]));
      curve_[i] =
          !shared || std::binary_search(curve_edges.begin(), curve_edges.end(), std::array<NodeIndex, 2>{s.a, s.b});
      if (curve_[i]) on_curve_[s.a] = on_curve_[s.b] = 1;
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
    for (std::size_t i = 1; i < sides_.size(); ++i) {
      if (curve_[i] || !same_edge(sides_[i], sides_[i - 1])) continue;
      for (const bool at_a : {true, false}) {
        const std::size_t p = find(corner_at(sides_[i], at_a)), q = find(corner_at(sides_[i - 1], at_a));
        group_[std::max(p, q)] = static_cast<std::uint32_t>(std::min(p, q));
      }
    }
  }
  std::size_t find(std::size_t c) {
    while (group_[c] != c) c = group_[c] = group_[group_[c]];
    return c;
  }

  const Mesh& mesh_;
  const std::vector<Side>& sides_;
  std::vector<std::uint8_t> curve_, on_curve_;  // of sides; of nodes
  std::vector<std::uint32_t> group_;            // of corners: union-find
};

}  // namespace

std::vector<std::uint8_t> irregular_nodes(const Mesh& mesh, const std::vector<Side>& sides) {
  return Irregularity(mesh, sides).find_all();
}

}  // namespace quadline
