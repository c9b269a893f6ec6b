#pragma once

#include <string>
#include <vector>

#include "quadline/point.hpp"
#include "quadline/quality.hpp"

namespace quadline {

/// Something found in the input and mended, or worth a warning.
struct Finding {
  std::string text;      ///< one line: what was found and what was done
  std::string place;     ///< place in the file, if known
  Point at;              ///< model units
  bool is_loss = false;  ///< the mesh lacks something that the model holds
};

/// How long a stage took.
struct StageTime {
  std::string stage;     ///< as Context::on_progress names it; stands again for every further attempt
  double elapsed_s = 0;  ///< without the snapshots
};

/// What a run did.
struct Report {
  double tolerance = 0;                                   ///< distance below which points are one, model units
  std::size_t n_cells = 0, n_curves = 0, n_vertices = 0;  ///< of the arrangement that the model makes
  std::vector<Finding> findings;                          ///< of the model, then of the fall-backs
  std::vector<StageTime> stages;                          ///< in their order
  Quality before_smoothing;                               ///< as Q-Morph leaves the mesh
  Quality quality;                                        ///< of the final mesh
  std::vector<CellCorner> corners;                        ///< of the model, with a bound below 1
  std::vector<WorstQuad> worst;                           ///< of the final mesh
  std::vector<LineQuality> lines;  ///< of the final mesh along each of its curves, in the order of Mesh::curves
};

}  // namespace quadline
