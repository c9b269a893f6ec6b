#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "quadline/mesh.hpp"

namespace quadline {

/// Least, mean, greatest and percentiles of one measure over a mesh.
struct Statistics {
  double min = 0, p1 = 0, p5 = 0, median = 0, p95 = 0, p99 = 0, max = 0, mean = 0;
};

/// What the sizes of neighbouring elements should not differ by more than.
constexpr double kGrowthLimit = 1.5;

/// Quality of the quads of a mesh.
struct Quality {
  std::size_t n_nodes = 0, n_quads = 0, n_triangles = 0;
  std::size_t n_inverted = 0;   ///< quads with a corner of 180 degrees or more, or no area
  std::size_t n_irregular = 0;  ///< interior nodes without four quads, curve nodes with a wedge off round(angle / 90)
  double beta_mean = 0;         ///< geometric mean of the distortion coefficient [Lee2003 eqs 1, 2]
  double beta_min = 0;
  Statistics scaled_jacobian;              ///< sine of a quad's worst corner, -1..1
  Statistics min_angle_deg;                ///< least corner angle of each quad
  Statistics max_angle_deg;                ///< greatest corner angle of each quad
  Statistics aspect;                       ///< longest over shortest edge of each quad, >= 1
  Statistics edge_length;                  ///< model units
  Statistics growth;                       ///< ratio, >= 1, of the widths of two quads across the edge that they share
  std::size_t n_growth_over = 0;           ///< such edges with a ratio above kGrowthLimit
  std::optional<Statistics> edge_to_size;  ///< edge length over the size field at its middle, where one is known
};

/// A corner of a cell, between two curves, in which quads cannot all have right angles: shared by the number of quads
/// that suits it best, it gives each the best angle, whose sine no mesh of the model can pass.
struct CellCorner {
  Point at;
  Point from;            ///< unit direction of the curve that has the corner on its left
  double angle_deg = 0;  ///< 0..360; 360 round the end of a line
  unsigned quads = 1;    ///< that share it at best
  double best_angle_deg = 0;
  double sj_bound = 0;  ///< upper bound on the least scaled Jacobian
};

/// One of the quads that are farthest from what can be had.
struct WorstQuad {
  std::size_t quad = 0;  ///< index into Mesh::quads
  Point at;              ///< mean of its corners
  double value = 0;      ///< the least over its corners of the sine over its bound; a negative sine by itself
  double scaled_jacobian = 0, sj_bound = 1;  ///< the sine and the bound at that corner
};

/// Least, mean and greatest edge length over the target size.
struct LengthToSize {
  double min = 0, mean = 0, max = 0;
};

/// Quality along one curve of a mesh: of the quads that have a node on it, and of its edges.
struct LineQuality {
  std::string name;
  CurveKind kind = CurveKind::Line;
  std::size_t n_edges = 0, n_quads = 0;
  std::size_t n_irregular = 0;  ///< irregular nodes on it, as in `Quality`
  double beta_mean = 0;         ///< geometric mean
  double beta_min = 0;
  double scaled_jacobian_mean = 0, scaled_jacobian_min = 0;
  double min_angle_deg = 0, max_angle_deg = 0;  ///< of the corners of its quads
  std::optional<LengthToSize> edge_to_size{};   ///< where the size is known
  std::optional<double> off_normal_deg{};  ///< mean of how far the free edges that leave it between its ends are from
                                           ///< 90 degrees to it; empty where there are none
};

/// Table 2 of [Lee2003]: "excellent", "good", "marginal" or "unacceptable".
std::string_view verdict(double beta);

/// Distortion coefficient beta of the quad a b c d [Lee2003 eqs 1, 2]: 1 for a rectangle, 0 for a degenerate or
/// inverted quad.
double distortion(Point a, Point b, Point c, Point d);

/// Every edge of the faces once, smaller node first, in ascending order: `n_edges x 2`.
std::vector<std::array<NodeIndex, 2>> edges_of(const Mesh& mesh);

/// For each quad the greatest growth across its sides: the ratio, >= 1, of its width to that of the neighbour, where
/// the width of a quad across a side is the distance between the middles of that side and of the opposite one. 1
/// where it has no neighbours.
std::vector<double> growth_of_quads(const Mesh& mesh);

/// Measures the quads of a mesh.
///
/// @param mesh  any mesh; triangles are counted, not measured.
/// @param size  target size at the middle of every edge, in the order of `edges_of(mesh)`; empty: unknown.
Quality measure(const Mesh& mesh, std::span<const double> size = {});

/// Measures the mesh along each of its curves, in their order.
///
/// @param size  as in `measure`.
/// Cost O(quads + n log n) for n quads and edges at curves.
std::vector<LineQuality> measure_lines(const Mesh& mesh, std::span<const double> size = {});

/// The five quads that are worst by scaled Jacobian over what the corner of the cell allows, the worst first, equal
/// ones by index; fewer where there are no more quads.
/// @param corners  those of the model (Report::corners); empty: unknown, all bounds are 1.
/// Cost O(quads + corners log corners).
std::vector<WorstQuad> worst_quads(const Mesh& mesh, std::span<const CellCorner> corners = {});

/// Upper bound on the least scaled Jacobian of any mesh with these corners: their least bound, 1 without any.
double jacobian_bound(std::span<const CellCorner> corners);

}  // namespace quadline
