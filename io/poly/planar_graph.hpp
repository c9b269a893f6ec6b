#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "quadline/point.hpp"
#include "search/box_tree.hpp"

namespace quadline {

/// A segment of a straight-line graph, and where it stood in a file.
struct GraphSegment {
  std::uint32_t a, b;  ///< indices of its end points
  int marker = 0;
  std::size_t number = 0;  ///< in the file
  std::size_t line = 0;    ///< of the file
};

struct StraightLineGraph {
  std::vector<Point> points;
  std::vector<GraphSegment> segments;
};

/// Makes the graph planar: points at the same place become one, segments are split where they cross, or where the end
/// of another lies on them (all within 1e-9 of the extent), and of those that are there twice the first stays.
///
/// @return  for each point given, the one that its segments use now; points made at crossings come after them.
/// @throws InputError  segments that cross so flatly that splitting does not part them; with the lines.
/// Cost O((n + k) log n) for k crossings of boxes.
std::vector<std::uint32_t> make_planar(StraightLineGraph& graph, const std::string& file);

/// The faces of a planar straight-line graph, exactly. Half-edge 2 i runs from a to b of segment i, 2 i + 1 back.
class PlanarFaces {
 public:
  static constexpr std::uint32_t kOutside = 0;  ///< the unbounded face

  /// @pre  no two segments cross, no point lies on a segment (as `make_planar` leaves it).
  explicit PlanarFaces(const StraightLineGraph& graph);

  std::uint32_t face_count() const { return n_faces_; }
  /// The face on the left of a half-edge.
  std::uint32_t face(std::uint32_t half) const { return face_[half]; }
  std::uint32_t tail(std::uint32_t half) const {
    const GraphSegment& segment = graph_.segments[half / 2];
    return half % 2 == 0 ? segment.a : segment.b;
  }
  std::uint32_t head(std::uint32_t half) const { return tail(half ^ 1u); }
  /// The half-edge that leaves the tail of this one, next to it clockwise.
  std::uint32_t rotate_cw(std::uint32_t half) const { return clockwise_[half]; }
  /// The face that holds p. Where p lies on a segment, one of those beside it.
  std::uint32_t face_at(Point p) const;

 private:
  static constexpr std::uint32_t kNone = UINT32_MAX;

  void sort_round_points();
  std::vector<std::uint32_t> number_cycles();
  std::uint32_t half_right_of(Point p) const;

  const StraightLineGraph& graph_;
  std::vector<std::uint32_t> clockwise_;  ///< of each half-edge
  std::vector<std::uint32_t> face_;       ///< of each half-edge
  std::uint32_t n_faces_ = 1;
  BoxTree tree_;  ///< of the segments
};

}  // namespace quadline
