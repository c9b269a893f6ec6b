#include "invariants.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "pieces.hpp"
#include "quadline/point.hpp"

namespace quadline {

namespace {

using Edge = std::pair<NodeIndex, NodeIndex>;

constexpr double kRounding = 1e-9;  // of the model's extent, which is near 10
constexpr double kOnLine = 1e-7;

Edge ordered(NodeIndex a, NodeIndex b) { return {std::min(a, b), std::max(a, b)}; }

class Audit {
 public:
  Audit(const Model& model, const Mesh& mesh) : model_(model), mesh_(mesh) {
    for (const auto& quad : mesh.quads)
      for (std::size_t i = 0; i < 4; ++i) ++uses_[ordered(quad[i], quad[(i + 1) % 4])];
  }

  void check_shapes() {
    for (const auto& quad : mesh_.quads)
      for (std::size_t i = 0; i < 4; ++i) {
        const Point before = at(quad[(i + 3) % 4]), corner = at(quad[i]), after = at(quad[(i + 1) % 4]);
        if (!(cross(after - corner, before - corner) > 0)) return note("a quad is not convex", corner);
      }
    if (!mesh_.triangles.empty()) note("triangles are left", {});
  }

  void check_edges() {
    std::set<Edge> rim;
    for (const EdgeSet& curve : mesh_.curves)
      for (const auto& [a, b] : curve.edges) {
        if (!uses_.contains(ordered(a, b))) note("an edge of '" + curve.name + "' is not in the mesh", at(a));
        if (curve.kind != CurveKind::Line) rim.insert(ordered(a, b));
      }
    for (const auto& [edge, count] : uses_)
      if (count != (rim.contains(edge) ? 1 : 2)) note("an edge has the wrong number of quads", at(edge.first));
  }

  void check_loops() {
    double around = 0, inside = 0;
    for (const EdgeSet& curve : mesh_.curves) {
      if (curve.kind == CurveKind::Line) continue;
      double area = 0;
      for (std::size_t i = 0; i < curve.edges.size(); ++i) {
        const auto [a, b] = curve.edges[i];
        if (b != curve.edges[(i + 1) % curve.edges.size()][0]) note("'" + curve.name + "' is not closed", at(b));
        area += 0.5 * cross(at(a), at(b));
      }
      around += curve.kind == CurveKind::Outer ? std::fabs(area) : -std::fabs(area);
    }
    for (const auto& q : mesh_.quads) inside += 0.5 * cross(at(q[2]) - at(q[0]), at(q[3]) - at(q[1]));
    if (std::fabs(around - inside) > kRounding * around) note("the area is not that of the domain", {});
  }

  // Every piece of the domain has one outer loop, and each hole takes one from its Euler characteristic; an outer loop
  // inside a hole is a piece of its own.
  void check_euler() {
    const auto n = [](std::size_t count) { return static_cast<long>(count); };
    const long found = n(mesh_.points.size()) - n(uses_.size()) + n(mesh_.quads.size());
    if (found != n(model_.outer.size()) - n(model_.holes.size())) note("Euler's formula does not hold", {});
  }

  // Every edge of a line runs along one of its pieces; and what of a piece no edge covers is not in the domain.
  void check_lines() {
    const Ground ground(model_);
    for (const Line& line : model_.lines) {
      std::vector<std::array<NodeIndex, 2>> edges;
      for (const EdgeSet& curve : mesh_.curves)
        if (curve.name == line.name) edges.insert(edges.end(), curve.edges.begin(), curve.edges.end());
      std::vector<bool> is_on_line(edges.size());
      for (const Piece& piece : pieces_of(line.path, false)) {
        std::vector<std::pair<double, double>> covered;
        for (std::size_t i = 0; i < edges.size(); ++i) {
          const Point a = at(edges[i][0]), b = at(edges[i][1]);
          if (std::max(piece.distance_to(a), piece.distance_to(b)) > kOnLine) continue;
          is_on_line[i] = true;
          auto [low, high] = std::minmax({piece.along(a), piece.along(b)});
          if (piece.is_circle() && high - low > piece.length() / 2) {  // across the start
            covered.emplace_back(0, low);
            low = std::exchange(high, piece.length());
          }
          covered.emplace_back(low, high);
        }
        check_cover(line.name, piece, covered, ground);
      }
      for (std::size_t i = 0; i < edges.size(); ++i)
        if (!is_on_line[i]) note("an edge of '" + line.name + "' is off its line", at(edges[i][0]));
    }
  }

  void check_points() {
    for (const NamedPoint& point : model_.points) {
      const auto set = std::ranges::find(mesh_.node_sets, point.name, &NodeSet::name);
      if (set == mesh_.node_sets.end() || set->nodes.size() != 1 || !(at(set->nodes[0]) == point.at))
        note("no node at '" + point.name + "'", point.at);
    }
  }

  std::vector<std::string> notes;

 private:
  void check_cover(const std::string& name, const Piece& piece, std::vector<std::pair<double, double>> covered,
                   const Ground& ground) {
    constexpr int kSamples = 7;
    covered.emplace_back(piece.length(), piece.length());
    std::ranges::sort(covered);
    double end = 0;  // of what is covered so far
    for (const auto& [low, high] : covered) {
      if (low < end - kOnLine) note("two edges of '" + name + "' lie on each other", piece.at(low));
      for (int i = 1; low > end + kOnLine && i < kSamples; ++i) {
        const Point p = piece.at(end + (low - end) * i / kSamples);
        if (ground.is_well_inside(p)) {
          note("'" + name + "' is not covered", p);
          break;
        }
      }
      end = std::max(end, high);
    }
  }

  Point at(NodeIndex v) const { return mesh_.points[v]; }
  void note(const std::string& what, Point p) {
    notes.push_back(what + " at (" + std::to_string(p.x) + ", " + std::to_string(p.y) + ")");
  }

  const Model& model_;
  const Mesh& mesh_;
  std::map<Edge, int> uses_;
};

}  // namespace

std::vector<std::string> broken(const Model& model, const Mesh& mesh) {
  Audit audit(model, mesh);
  audit.check_shapes();
  audit.check_edges();
  audit.check_loops();
  audit.check_euler();
  audit.check_lines();
  audit.check_points();
  return audit.notes;
}

std::vector<std::string> broken(const Mesh& mesh) {
  const Model none;
  Audit audit(none, mesh);
  audit.check_shapes();
  audit.check_edges();
  return audit.notes;
}

}  // namespace quadline
