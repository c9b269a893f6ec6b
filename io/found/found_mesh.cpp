#include "io/found/found_mesh.hpp"

#include <algorithm>
#include <cmath>

#include "base/constants.hpp"
#include "io/text/number_text.hpp"
#include "quality/mesh_edges.hpp"

namespace quadline {

void SourceFile::fail_at_line(std::size_t offset, const std::string& message) const {
  const auto end = bytes.begin() + static_cast<std::ptrdiff_t>(std::min(offset, bytes.size()));
  const auto line = std::count(bytes.begin(), end, '\n') + 1;
  throw InputError(ErrorCode::FileSyntax, message, Where{name, "line " + std::to_string(line), {}});
}

void SourceFile::fail_at_byte(std::size_t offset, const std::string& message) const {
  throw InputError(ErrorCode::FileSyntax, message, Where{name, "byte " + std::to_string(offset), {}});
}

void SourceFile::fail(const std::string& message, ErrorCode code) const {
  throw InputError(code, message, Where{name, {}, {}});
}

bool Numbering::close() {
  std::sort(entries_.begin(), entries_.end());
  const auto same = [](const auto& a, const auto& b) { return a.first == b.first; };
  return std::adjacent_find(entries_.begin(), entries_.end(), same) == entries_.end();
}

std::uint32_t Numbering::find(std::int64_t number) const {
  if (entries_.empty() || number < entries_.front().first || number > entries_.back().first) return UINT32_MAX;
  // Both are in the range of the entries, so that the difference does not overflow 64 unsigned bits.
  const auto guess = static_cast<std::uint64_t>(number) - static_cast<std::uint64_t>(entries_.front().first);
  if (guess < entries_.size() && entries_[guess].first == number) return entries_[guess].second;
  const auto at = std::lower_bound(entries_.begin(), entries_.end(), std::pair(number, std::uint32_t{0}));
  return at != entries_.end() && at->first == number ? at->second : UINT32_MAX;
}

namespace {

using Edge = std::array<NodeIndex, 2>;

/// The edges with an element on one side only, directed with it on their left.
class Boundary {
 public:
  explicit Boundary(const Mesh& mesh) : edges_(mesh) {}
  bool has(NodeIndex tail, NodeIndex head) const {
    const std::size_t edge = edges_.find(tail, head);
    if (edge == edges_.count()) return false;
    const std::span<const Side> sides = edges_.sides(edge);
    return sides.size() == 1 && sides[0].forward == (tail < head);
  }

 private:
  MeshEdges edges_;
};

bool is_chain(const std::vector<Edge>& edges) {
  for (std::size_t i = 1; i < edges.size(); ++i)
    if (edges[i][0] != edges[i - 1][1]) return false;
  return true;
}

/// Edges in the order and direction of a walk along them; unchanged where they branch. Starts at an end, of two ends at
/// the one that the given directions prefer; in a loop with the first edge.
std::vector<Edge> in_order(const std::vector<Edge>& edges) {
  if (is_chain(edges)) return edges;
  struct EdgeEnd {
    NodeIndex node;
    std::uint32_t edge;
    bool operator<(const EdgeEnd& b) const { return std::pair(node, edge) < std::pair(b.node, b.edge); }
  };
  std::vector<EdgeEnd> ends;
  for (std::uint32_t e = 0; e < edges.size(); ++e)
    for (const NodeIndex node : edges[e]) ends.push_back({node, e});
  std::sort(ends.begin(), ends.end());
  const auto at = [&](NodeIndex node) { return std::lower_bound(ends.begin(), ends.end(), EdgeEnd{node, 0}); };

  Edge first = edges[0];
  bool has_first = false;
  for (auto i = ends.begin(); i != ends.end();) {
    auto j = i;
    while (j != ends.end() && j->node == i->node) ++j;
    if (j - i > 2) return edges;
    if (j - i == 1) {
      const Edge edge = edges[i->edge];
      const bool starts_here = edge[0] == i->node;
      if (!has_first || starts_here) first = starts_here ? edge : Edge{edge[1], edge[0]};
      has_first = true;
    }
    i = j;
  }
  std::vector<Edge> out = {first};
  while (out.size() < edges.size()) {
    const auto [tail, here] = out.back();
    NodeIndex next = tail;
    for (auto end = at(here); end != ends.end() && end->node == here; ++end) {
      const Edge edge = edges[end->edge];
      const NodeIndex other = edge[0] == here ? edge[1] : edge[0];
      if (other != tail) next = other;
    }
    if (next == tail) return edges;  // several pieces
    out.push_back({here, next});
  }
  return out;
}

/// The kind of a closed chain that runs along the boundary, Line for any other: an outer loop has its elements inside.
CurveKind kind_of(const std::vector<Edge>& edges, const Boundary& boundary, const Mesh& mesh) {
  if (edges.size() < 3 || !is_chain(edges) || edges.back()[1] != edges.front()[0]) return CurveKind::Line;
  const bool along = boundary.has(edges[0][0], edges[0][1]);
  double twice_area = 0;
  const Point origin = mesh.points[edges[0][0]];
  for (const auto& [a, b] : edges) {
    if (along ? !boundary.has(a, b) : !boundary.has(b, a)) return CurveKind::Line;
    twice_area += cross(mesh.points[a] - origin, mesh.points[b] - origin);
  }
  return (twice_area > 0) == along ? CurveKind::Outer : CurveKind::Hole;
}

/// The closed chain through the nodes, in their order.
std::vector<Edge> loop_through(const std::vector<NodeIndex>& nodes) {
  std::vector<Edge> edges;
  for (std::size_t i = 0; i < nodes.size(); ++i) edges.push_back({nodes[i], nodes[(i + 1) % nodes.size()]});
  return edges;
}

void find_loops(Mesh& mesh) {
  const Boundary boundary(mesh);
  for (EdgeSet& curve : mesh.curves) {
    curve.edges = in_order(curve.edges);
    curve.kind = kind_of(curve.edges, boundary, mesh);
  }
  std::vector<EdgeSet> loops;
  std::vector<NodeSet> sets;
  for (NodeSet& set : mesh.node_sets) {
    EdgeSet loop{set.name, CurveKind::Line, {}};
    if (set.nodes.size() >= 3) loop.edges = loop_through(set.nodes);
    loop.kind = kind_of(loop.edges, boundary, mesh);
    if (loop.kind == CurveKind::Line) {
      sets.push_back(std::move(set));
    } else {
      loops.push_back(std::move(loop));
    }
  }
  mesh.node_sets = std::move(sets);
  mesh.curves.insert(mesh.curves.begin(), loops.begin(), loops.end());
}

template <std::size_t N>
double twice_area(const Mesh& mesh, const std::array<NodeIndex, N>& element) {
  double sum = 0;
  for (std::size_t i = 1; i + 1 < N; ++i) {
    const Point a = mesh.points[element[0]];
    sum += cross(mesh.points[element[i]] - a, mesh.points[element[i + 1]] - a);
  }
  return sum;
}

void turn_if_seen_from_below(Mesh& mesh) {
  double sum = 0;
  for (const auto& quad : mesh.quads) sum += twice_area(mesh, quad);
  for (const auto& triangle : mesh.triangles) sum += twice_area(mesh, triangle);
  if (!(sum < 0)) return;
  for (auto& quad : mesh.quads) std::swap(quad[1], quad[3]);
  for (auto& triangle : mesh.triangles) std::swap(triangle[1], triangle[2]);
}

void check_plane(const FoundMesh& found, const SourceFile& file) {
  constexpr double kFlat = 1e-9;  // of the size of the mesh
  Point lo{kInfinity, kInfinity}, hi{-kInfinity, -kInfinity};
  double z_lo = kInfinity, z_hi = -kInfinity;
  for (std::size_t i = 0; i < found.z.size(); ++i) {
    const Point p = found.mesh.points[i];
    if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(found.z[i]))
      file.fail("node " + std::to_string(i + 1) + " has a coordinate that is no finite number", ErrorCode::InvalidMesh);
    lo = {std::min(lo.x, p.x), std::min(lo.y, p.y)};
    hi = {std::max(hi.x, p.x), std::max(hi.y, p.y)};
    z_lo = std::min(z_lo, found.z[i]);
    z_hi = std::max(z_hi, found.z[i]);
  }
  if (z_hi - z_lo > kFlat * distance(lo, hi)) {
    std::string range;
    append_number(range, z_lo);
    range += " to ";
    append_number(range, z_hi);
    file.fail("the mesh does not lie in a plane z = constant: z goes from " + range, ErrorCode::InvalidMesh);
  }
}

}  // namespace

bool sort_nodes(Numbering& numbers, FoundMesh& found) {
  if (!numbers.close()) return false;
  std::vector<Point> points;
  std::vector<double> z;
  Numbering sorted;
  for (const auto& [number, index] : numbers.entries()) {
    sorted.add(number);
    points.push_back(found.mesh.points[index]);
    z.push_back(found.z[index]);
  }
  sorted.close();
  numbers = std::move(sorted);
  found.mesh.points = std::move(points);
  found.z = std::move(z);
  return true;
}

Mesh plane_mesh(FoundMesh found, const SourceFile& file) {
  if (found.mesh.quads.empty() && found.mesh.triangles.empty())
    file.fail("no quad or triangle in it", ErrorCode::InvalidMesh);
  check_plane(found, file);
  turn_if_seen_from_below(found.mesh);
  find_loops(found.mesh);
  return std::move(found.mesh);
}

}  // namespace quadline
