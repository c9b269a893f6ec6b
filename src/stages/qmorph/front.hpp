#pragma once

#include "mesh/work_mesh.hpp"

namespace quadline {

/// State of a front edge at one of its ends [Lee2003 section 4, Owen1999].
enum class State : std::uint8_t {
  Open = 0,    ///< a side edge is sought
  Closed = 1,  ///< the neighbouring front edge is the side edge
  LineEnd = 2  ///< the end of an open line: a side edge is sought near the normal
};

/// The unmeshed angle at a front node, between the front edge that arrives and the one that leaves.
struct Corner {
  HalfId in, out;
  NodeId node;
  Angle angle{};  ///< counter-clockwise from `out` to the twin of `in`
  int quads = 1;  ///< how many quads shall fill the angle; 0: it shall be seamed
  State state = State::Open;
};

/// A front half-edge has an unmeshed triangle on its left, and a quad, a constraint or the outside on its right. So a
/// line with triangles on both sides carries two, and no list of fronts has to be kept.
inline bool is_front(const WorkMesh& mesh, HalfId h) {
  return mesh.is_triangle(h) && (mesh.is_constraint(h) || !mesh.is_triangle(twin(h)));
}

/// The front half-edge that leaves the head of h; the twin of h at the end of an open line.
HalfId next_front(const WorkMesh& mesh, HalfId h);
/// The front half-edge that arrives at the tail of h.
HalfId previous_front(const WorkMesh& mesh, HalfId h);

Corner corner_after(const WorkMesh& mesh, HalfId h);
Corner corner_before(const WorkMesh& mesh, HalfId h);

/// True where a front, a line or a finished quad touches the node: its colour counts, and no quad may swallow it.
bool is_attached(const WorkMesh& mesh, NodeId v);

}  // namespace quadline
