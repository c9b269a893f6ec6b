#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "quadline/mesh.hpp"

namespace quadline {

/// Limits on the quads of a mesh; an empty one is not looked at. A value equal to its limit passes.
struct Criteria {
  std::optional<double> min_angle_deg{};        ///< of every corner, degrees
  std::optional<double> max_angle_deg{};        ///< of every corner, degrees
  std::optional<double> max_aspect{};           ///< longest over shortest edge
  std::optional<double> min_scaled_jacobian{};  ///< least sine of a corner, signed [Knupp2001]
  std::optional<double> min_jacobian_ratio{};   ///< least over greatest Jacobian of the corners; HyperMesh's "Jacobian"
  std::optional<double> max_skew_deg{};         ///< 90 degrees less the angle between the lines of opposite mid-sides
  std::optional<double> max_taper{};            ///< 1 - least area of a corner's triangle over half the quad's area
  std::optional<double> min_beta{};             ///< distortion coefficient [Lee2003 eqs 1, 2]
  std::optional<double> max_growth{};           ///< width over that of a neighbour, the greater over the lesser
  std::optional<double> min_edge{};             ///< shortest edge, model units
  std::optional<double> max_edge{};             ///< longest edge, model units
  std::optional<double> min_edge_to_size{};     ///< shortest edge over the target size
  std::optional<double> max_edge_to_size{};     ///< longest edge over the target size
};

/// One limit of `Criteria` by its name.
struct CriteriaField {
  std::string_view name;  ///< of the member: "min_angle_deg"
  std::optional<double> Criteria::* limit;
  bool is_least;     ///< values below it fail, not values above
  bool to_size;      ///< needs the target size
  double low, high;  ///< where limits that mean anything lie; `high` may be infinity
};

/// All limits, in the order of the struct.
const std::vector<CriteriaField>& criteria_fields();

/// "csr-fine", "hypermesh-10mm" or "growth" (docs/measures.md gives figures and sources); empty for any other name.
std::optional<Criteria> named_criteria(std::string_view name);

/// A quad beyond a limit.
struct FailingQuad {
  std::size_t quad = 0;  ///< index into Mesh::quads
  Point at;              ///< mean of its corners
  double value = 0;      ///< what the limit is for, in its unit
};

/// How a mesh stands to one limit.
struct LimitResult {
  std::string_view name;   ///< as in `criteria_fields`
  double limit = 0;        ///< as asked
  bool is_checked = true;  ///< false: the limit is over the target size, which is unknown
  std::size_t n_failing = 0;
  std::vector<FailingQuad> worst;  ///< up to five, the worst first, equal ones by index
};

/// How a mesh stands to all limits that are given.
struct CriteriaResult {
  std::size_t n_failing = 0;        ///< quads that fail at least one limit
  std::vector<LimitResult> limits;  ///< in the order of `criteria_fields`
};

/// Holds the quads of a mesh against limits; triangles are not looked at.
/// @param size  target size of the whole mesh, model units, > 0; empty: limits over it are not checked.
/// Cost O(quads).
CriteriaResult evaluate(const Mesh& mesh, const Criteria& criteria, std::optional<double> size = {});

/// The same with local sizes.
/// @param size  target size at the middle of every edge, in the order of `edges_of(mesh)` (MeshResult::edge_sizes);
///              empty: unknown.
CriteriaResult evaluate(const Mesh& mesh, const Criteria& criteria, std::span<const double> size);

}  // namespace quadline
