#include "cells/thin_quads.hpp"

#include <cmath>
#include <cstdint>

#include "quality/limits.hpp"
#include "search/box_tree.hpp"
#include "stages/verify/verify.hpp"

namespace quadline {

namespace {

bool is_sound(const WorkMesh& mesh, FaceId f) { return !mesh.topo().is_triangle(f) && is_sound(mesh.quad_points(f)); }

bool is_thin(const WorkMesh& mesh, FaceId f) {
  const QuadPoints q = mesh.quad_points(f);
  if (scaled_jacobian(q) < kThinJacobian) return true;
  const Polygon p = mesh.topo().polygon(f);
  for (int i = 0; i < 4; ++i)
    if (!mesh.is_free(p.nodes[i]) && angle_at(q[(i + 3) % 4], q[i], q[(i + 1) % 4]) > kWidestCorner) return true;
  return false;
}

}  // namespace

std::vector<FaceId> unsound_faces(const WorkMesh& mesh) {
  std::vector<FaceId> faces;
  for (const FaceId f : mesh.topo().faces())
    if (!is_sound(mesh, f)) faces.push_back(f);
  return faces;
}

Point centre_of(const WorkMesh& mesh, FaceId f) {
  const Polygon p = mesh.topo().polygon(f);
  Point sum;
  for (const NodeId v : p.corners()) sum += mesh.point(v);
  return (1.0 / p.n) * sum;
}

void freeze_thin_quads(WorkMesh& mesh) {
  const Topology& topo = mesh.topo();
  IdVector<FaceId, std::uint8_t> is_frozen(topo.face_capacity(), 0);
  std::vector<FaceId> work;
  for (const FaceId f : topo.faces()) work.push_back(f);
  while (!work.empty()) {
    const FaceId f = work.back();
    work.pop_back();
    if (is_frozen[f] || !is_sound(mesh, f) || !is_thin(mesh, f)) continue;
    mesh.freeze(f);
    is_frozen[f] = 1;
    const Polygon held = topo.polygon(f);
    for (const NodeId v : held.corners())  // they stay now, which makes other corners count
      topo.for_each_out(v, [&](HalfId h) {
        if (topo.face(h).valid()) work.push_back(topo.face(h));
      });
  }
}

void freeze_near(WorkMesh& mesh, const std::vector<Point>& places, double reach, const SizeField& size) {
  std::vector<Box> boxes;
  for (const Point p : places) {
    const double r = reach * size.at(p);
    boxes.push_back({{p.x - r, p.y - r}, {p.x + r, p.y + r}});
  }
  const BoxTree tree(boxes);
  for (const FaceId f : mesh.topo().faces()) {
    if (!is_sound(mesh, f)) continue;
    const Point c = centre_of(mesh, f);
    bool is_near = false;
    tree.query({c, c}, [&](std::uint32_t) { is_near = true; });
    if (is_near) mesh.freeze(f);
  }
}

}  // namespace quadline
