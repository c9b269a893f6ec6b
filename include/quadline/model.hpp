#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "quadline/point.hpp"

namespace quadline {

/// A step of a path: a straight line to `to`, or the circular arc to `to` through `via`.
struct PathItem {
  Point to;                    ///< model units, finite
  std::optional<Point> via{};  ///< a place on the arc between its ends, model units; empty: a straight line
};

/// A whole circle: an outer loop, a hole or a closed line.
///
/// Round a hole or a line `rings` rows of quads may lie, each `ring_width` wide, with nodes on common rays; where they
/// have no room, those that have are made, and a Finding says why.
struct Circle {
  Point center;       ///< model units
  double radius = 0;  ///< model units, > 0
  /// Element edges round it, even, kLeastCircleEdges to kMostCircleEdges; empty: as the sizes want.
  std::optional<std::uint32_t> edges{};
  std::optional<std::uint32_t> rings{};  ///< 1 to kMostRings; empty: one where `ring_width` is given, else none
  std::optional<double> ring_width{};    ///< of each ring, model units, > 0; empty: the length of an edge round it
};
inline constexpr std::uint32_t kLeastCircleEdges = 4, kMostCircleEdges = 1'000'000, kMostRings = 100;

/// A chain of straight lines and circular arcs, or a whole circle.
///
/// The first item is a point (no `via`). Loops close by themselves with a straight line; a line whose last point
/// equals its first is a closed line loop.
struct Path {
  std::vector<PathItem> items{};   ///< empty where `circle` is given
  std::optional<Circle> circle{};  ///< counter-clockwise, starting at angle 0
  std::string where{};             ///< place in the file: a JSON path such as "/lines/7/path", or "line 12"
};

/// A line constraint: element edges will follow it from end to end.
struct Line {
  std::string name{};            ///< empty: "line-3", by its place in Model::lines
  Path path{};                   ///< from end to end; may cross, touch and overlap others
  std::optional<double> size{};  ///< target edge length at the line, model units, > 0; empty: that of the cells beside
};

/// A point constraint: a mesh node will stand there.
struct NamedPoint {
  std::string name{};            ///< empty: "point-3", by its place in Model::points
  Point at{};                    ///< model units
  std::optional<double> size{};  ///< target edge length at the point, model units, > 0; empty: that of the cell
  std::string where{};           ///< place in the file, for messages
};

/// Names the cell (piece of the domain between the lines) that holds the point `at`.
struct Region {
  std::string name{};            ///< of the cell's quads, in Mesh::regions
  Point at{};                    ///< inside the cell, model units
  std::optional<double> size{};  ///< target edge length inside the cell, model units, > 0; empty: Model::size
  std::string where{};           ///< place in the file, for messages
};

/// The input: a plane domain with holes, line constraints, point constraints and regions ("model v1").
struct Model {
  std::string name{};                ///< for people only, as the next two
  std::string about{};               ///< a line on what it is
  std::string units{};               ///< "mm"; nothing is converted
  std::string file{};                ///< for messages only
  double size = 0;                   ///< target edge length, model units, > 0 unless Options::size is given
  std::vector<Path> outer{};         ///< one loop at least, in any direction
  std::vector<Path> holes{};         ///< loops inside the outer ones, in any direction
  std::vector<Line> lines{};         ///< parts outside the domain are trimmed
  std::vector<NamedPoint> points{};  ///< those outside the domain are dropped
  std::vector<Region> regions{};     ///< names of cells; the others are "domain"
};

}  // namespace quadline
