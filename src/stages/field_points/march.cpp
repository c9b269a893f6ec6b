// Rows of points from the constraints inwards, so that the triangles are halves of squares and their legs are ready to
// become side edges. After the frontal point placement of [Remacle2013], with the frame of the row that a point
// continues in place of a cross field: rows follow the features and meet half-way between them.
#include <cmath>
#include <numbers>
#include <queue>

#include "base/elementary.hpp"
#include "stages/field_points/insertion.hpp"

namespace quadline {

namespace {

constexpr Spacing kSpacing{0.7, 0.55, true};

struct Seed {
  NodeId node;
  Point direction;  // in which the next point of the row is wanted; unit
  double reach;     // its distance in parts of the local size
  bool sideways;    // whether rows may also leave to the left and right
};

// The inner directions of each sector of a constraint node: where its side edges will be.
void seeds_of(const WorkMesh& mesh, NodeId v, std::vector<Seed>& seeds) {
  mesh.for_each_sector(v, [&](HalfId first, HalfId, Angle angle) {
    const int k = quads_for_angle(angle);
    if (k == 1) return;
    const double turn = radians(angle) / k;
    const Point edge = mesh.point(mesh.topo().head(first)) - mesh.point(v);
    const Point along = (1 / norm(edge)) * edge;
    const double reach = std::fmin(1.4, 1 / sine(std::fmin(turn, std::numbers::pi / 2)));
    for (int i = 1; i < k; ++i) {
      const bool is_normal = i * turn == std::numbers::pi / 2;
      seeds.push_back({v, is_normal ? left_normal(along) : turned(along, i * turn), reach, false});
    }
  });
}

}  // namespace

void march_from_constraints(WorkMesh& mesh, const SizeField& size, Context& context) {
  const Topology& topo = mesh.topo();
  Insertion insertion(mesh, size);
  std::queue<Seed> queue;
  std::vector<Seed> seeds;
  const std::size_t n_start = topo.node_capacity();
  for (std::size_t i = 0; i < n_start; ++i) {
    seeds.clear();
    seeds_of(mesh, NodeId(i), seeds);
    for (const Seed& s : seeds) queue.push(s);
  }
  double steps = 0;
  while (!queue.empty()) {
    const Seed s = queue.front();
    queue.pop();
    if (static_cast<std::size_t>(++steps) % 4096 == 0)
      context.progress("field points", kMarchShare * steps / (steps + queue.size()));
    const Point from = mesh.point(s.node);
    const auto propose = [&](Point d, double reach) {
      const double h = size.at(from + (0.5 * reach * size.at(from)) * d);
      const Point p = from + (reach * h) * d;
      const FaceId f = insertion.walk(s.node, p);
      if (!f.valid()) return;
      if (const NodeId v = insertion.try_insert(p, f, kSpacing, d); v.valid()) queue.push({v, d, 1, true});
    };
    propose(s.direction, s.reach);
    if (!s.sideways) continue;
    propose(left_normal(s.direction), 1);
    propose(-1.0 * left_normal(s.direction), 1);
  }
}

}  // namespace quadline
