#pragma once

#include <array>
#include <cstddef>
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

/// What Q-Morph did: how often each of the cases of [Owen1999] and [Lee2003] came up.
///
/// Every quad of a normal step has two side edges and a top edge: the sum over `side_*` is twice that over `quads`, and
/// that over `top_*` the same. Of a step that was refused nothing counts but the refusal.
struct MorphCounts {
  std::size_t n_triangles = 0;  ///< before the first step
  /// Quads of the normal step, by the states of the base edge: `[at its tail][at its head]`; 0: a side edge is sought,
  /// 1: the next front edge is the side edge, 2: the end of an open line.
  std::array<std::array<std::size_t, 3>, 3> quads{};
  std::size_t side_neighbour = 0;        ///< side edges: the next front edge, in state 1
  std::size_t side_chosen = 0;           ///< an edge near the wanted direction
  std::size_t side_swapped = 0;          ///< an edge that a swap gave
  std::size_t side_split_parity = 0;     ///< a part of an edge which as a whole would leave odd loops
  std::size_t side_split_length = 0;     ///< a part of an edge which as a whole is far too long
  std::size_t side_split_direction = 0;  ///< a new edge, to a node on the edge that the wanted direction meets
  std::size_t top_found = 0;             ///< top edges that were there
  std::size_t top_swapped = 0;           ///< that swaps gave
  std::size_t seams = 0;
  std::size_t transition_seams = 0;      ///< at a sharp corner, between front edges of very different length
  std::size_t transition_splits = 0;     ///< at any other
  std::size_t closures_of_4 = 0;         ///< loops of four front edges that became a quad
  std::size_t closures_of_6_by_2 = 0;    ///< loops of six that became two quads
  std::size_t closures_of_6_by_3 = 0;    ///< and three, round a new node
  std::size_t completion_triangles = 0;  ///< triangles that the front left
  std::size_t completion_quads = 0;      ///< what became of them
  std::size_t refused_side = 0;          ///< steps refused for want of a side edge
  std::size_t refused_top = 0;           ///< of a top edge
  std::size_t refused_shape = 0;         ///< because of what the four edges would have enclosed

  MorphCounts& operator+=(const MorphCounts& other);
  friend bool operator==(const MorphCounts&, const MorphCounts&) = default;
};

/// Where the quads of the cells came from.
struct CellOrigins {
  struct Share {
    std::size_t n_cells = 0, n_quads = 0;
    friend bool operator==(const Share&, const Share&) = default;
  };
  Share grids;   ///< cells that became grids, with rings round their holes
  Share fronts;  ///< cells that Q-Morph meshed
  Share halved;  ///< cells whose triangles, or pairs of them, were halved
  Share copies;  ///< cells that have the mesh of another one, moved
};

/// What a run did.
struct Report {
  double tolerance = 0;                                   ///< distance below which points are one, model units
  std::size_t n_cells = 0, n_curves = 0, n_vertices = 0;  ///< of the arrangement that the model makes
  std::vector<Finding> findings;                          ///< of the model, then of the fall-backs
  std::vector<StageTime> stages;                          ///< in their order
  CellOrigins cells;                                      ///< of the last attempt
  MorphCounts qmorph;               ///< of all cells, each with the triangles whose quads the mesh has
  Quality before_smoothing;         ///< as Q-Morph leaves the mesh
  Quality quality;                  ///< of the final mesh
  std::vector<CellCorner> corners;  ///< of the model, with a bound below 1
  std::vector<WorstQuad> worst;     ///< of the final mesh
  std::vector<LineQuality> lines;   ///< of the final mesh along each of its curves, in the order of Mesh::curves
};

}  // namespace quadline
