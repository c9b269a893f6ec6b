// The front of [Owen1999] as [Lee2003] extends it to line constraints. We differ: corners choose the number of quads
// that fills them (one to four, by the nearest square angles and, at free nodes, the valence that results), of which
// the paper's states 0, 1 and 2 are the cases two or more, one, and four at the end of an open line.
#include "stages/qmorph/front.hpp"

#include <numbers>

namespace quadline {

namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kWidestInRadians = 165 * kPi / 180;  // no quad gets a wider corner on purpose
constexpr Angle kSeamBelow = degrees(30);             // [Lee2003], [Owen1999]
constexpr Angle kSeamAtMost = degrees(60);

double square(double x) { return x * x; }

// Deviation of a corner shared by k quads from a right angle, and of the node's valence from four.
double cost(double angle_rad, int k, int quads_there) {
  const double misfit = k == 0 ? angle_rad / (kPi / 6) : (angle_rad / k - kPi / 2) / (kPi / 6);
  return square(misfit) + square(quads_there + k - 4);
}

int quads_at_free_node(Angle angle, int quads_there) {
  const double angle_rad = radians(angle);
  int best = 4;
  double least = cost(angle_rad, 4, quads_there);
  for (int k = 3; k >= 1; --k) {
    if (angle_rad / k > kWidestInRadians) break;
    if (const double c = cost(angle_rad, k, quads_there); c < least) {
      least = c;
      best = k;
    }
  }
  if (angle < kSeamBelow || (angle < kSeamAtMost && cost(angle_rad, 0, quads_there) < least)) return 0;
  return best;
}

Corner corner(const WorkMesh& mesh, HalfId in, HalfId out) {
  const Topology& topo = mesh.topo();
  Corner c{in, out, topo.tail(out)};
  const bool line_end = out == twin(in);
  c.angle = line_end ? degrees(360) : mesh.angle_between(out, twin(in));
  if (mesh.is_free(c.node)) {
    int quads_there = 0;
    topo.for_each_out(c.node, [&](HalfId h) {
      if (topo.face(h).valid() && !topo.is_triangle(topo.face(h))) ++quads_there;
    });
    c.quads = quads_at_free_node(c.angle, quads_there);
  } else {
    c.quads = quads_for_angle(c.angle);
    // Two constraints may meet at any angle; a quad's edge may be seamed on to a constraint.
    const bool both_fixed = mesh.is_constraint(in) && mesh.is_constraint(out);
    if (c.angle < kSeamBelow && !both_fixed) c.quads = 0;
  }
  c.state = line_end ? State::LineEnd : c.quads <= 1 ? State::Closed : State::Open;
  return c;
}

}  // namespace

HalfId next_front(const WorkMesh& mesh, HalfId h) {
  HalfId g = mesh.topo().next(h);
  while (!is_front(mesh, g)) g = mesh.topo().next(twin(g));
  return g;
}

HalfId previous_front(const WorkMesh& mesh, HalfId h) {
  HalfId g = mesh.topo().prev(h);
  while (!is_front(mesh, g)) g = mesh.topo().prev(twin(g));
  return g;
}

Corner corner_after(const WorkMesh& mesh, HalfId h) { return corner(mesh, h, next_front(mesh, h)); }
Corner corner_before(const WorkMesh& mesh, HalfId h) { return corner(mesh, previous_front(mesh, h), h); }

bool is_attached(const WorkMesh& mesh, NodeId v) {
  bool attached = false;
  mesh.topo().for_each_out(v, [&](HalfId h) { attached |= mesh.is_constraint(h) || !mesh.is_triangle(h); });
  return attached;
}

}  // namespace quadline
