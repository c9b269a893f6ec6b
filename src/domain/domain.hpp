#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "base/id.hpp"
#include "geom/curve.hpp"
#include "quadline/mesh.hpp"
#include "quadline/model.hpp"
#include "quadline/report.hpp"

namespace quadline {

/// A curve, walked along or against its direction.
struct DirectedCurve {
  CurveId curve;
  bool reversed = false;
};

/// The planar arrangement of a model: what the mesh must follow. Made once, then only read.
struct Domain {
  struct Vertex {
    Point at;
  };
  struct Curve {
    VertexId tail{}, head{};    ///< differ always
    CurvePiece piece{};         ///< from tail to head
    CellId left{}, right{};     ///< invalid: outside the domain
    double size = 0;            ///< target edge length from lines along it, model units; infinity: none
    std::uint32_t edges = 0;    ///< that it is to have, whatever the sizes; 0: as the sizes want
    bool has_rings = false;     ///< of a hole in a grid: it asks for no lesser sizes round it
    bool is_auxiliary = false;  ///< not of the model: cuts a cell at an axis, see `cut_at_axes`, or ends rings
    bool is_boundary() const { return left.valid() != right.valid(); }
  };
  /// A connected piece of the domain, bounded by closed walks of curves with the cell on their left. A line that ends
  /// inside the cell is walked along both sides.
  struct Cell {
    std::vector<std::vector<DirectedCurve>> walks;  ///< the outer walk (counter-clockwise) first, then the inner ones
    std::vector<VertexId> lone_points;              ///< point constraints inside, on no curve
    std::uint32_t region = 0;                       ///< index into `regions`
    double size = 0;                                ///< target edge length inside, model units
    std::uint32_t rings = 0;                        ///< equal rows between two circles, as the model asks; 0: none
  };
  /// What one curve of the model became: its pieces in order, without those outside the domain.
  struct Path {
    std::string name;
    CurveKind kind;
    std::vector<DirectedCurve> curves;
    std::string where{};  ///< place in the file, for messages
  };
  struct PointUse {
    std::string name;
    VertexId vertex;
    double size;  ///< target edge length there, model units; infinity: none
  };

  IdVector<VertexId, Vertex> vertices;
  IdVector<CurveId, Curve> curves;
  IdVector<CellId, Cell> cells;
  std::vector<Path> paths;           ///< outer loops, holes, lines, in the order of the model
  std::vector<PointUse> points;      ///< in the order of the model, without those outside the domain
  std::vector<std::string> regions;  ///< names; 0 is "domain", for cells without a name
  std::vector<Finding> findings;     ///< what was found and mended
  double size = 0;                   ///< target edge length, model units
  double tolerance = 0;              ///< distance below which points are one, model units
  Box box;
};

}  // namespace quadline
