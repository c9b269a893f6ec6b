#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "domain/size/size_field.hpp"
#include "mesh/work_mesh.hpp"

namespace quadline::shapes {

using QuadList = std::vector<std::array<std::uint32_t, 4>>;
using EdgeList = std::vector<std::array<std::uint32_t, 2>>;

/// A mesh of quads. Its rim and `lines` are constraints; their nodes are fixed where the rim turns, or a line ends or
/// meets something, and on curves elsewhere.
WorkMesh quad_mesh(const std::vector<Point>& points, const QuadList& quads, const EdgeList& lines = {});

/// nx x ny squares of side h.
WorkMesh grid(int nx, int ny, double h = 1, const EdgeList& lines = {});

/// A square of n x n cells of side h, each cut in two triangles at random and every triangle in three quads; the inner
/// nodes are moved by up to a fifth of h. About two thirds of the nodes are irregular. With `line`, a line constraint
/// runs along the middle row over the middle half.
WorkMesh split_triangles(int n, double h, std::uint32_t seed, bool line);

/// A grid in which about `share` of the inner edges were turned at random: pairs of irregular nodes, reflex quads.
WorkMesh turned_grid(int nx, int ny, double h, double share, std::uint32_t seed, bool line);

SizeField constant_size(double h);

struct Figures {
  std::size_t n_quads = 0, n_nodes = 0, n_irregular = 0;
  double irregular_share = 0;
  double least_jacobian = 1, mean_beta = 0;  ///< mean beta: geometric, with 1e-3 for what is inverted
};
Figures figures(const WorkMesh& mesh);

/// Constraint edges as sorted pairs of points, to compare before and after.
std::vector<std::array<Point, 2>> constraint_edges(const WorkMesh& mesh);

double area(const WorkMesh& mesh);

/// Guarded Laplacian smoothing of the free nodes, as simple as can be.
void smooth_simply(WorkMesh& mesh, int sweeps);

}  // namespace quadline::shapes
