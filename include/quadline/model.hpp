#pragma once

#include <optional>
#include <string>
#include <vector>

#include "quadline/point.hpp"

namespace quadline {

/// A step of a path: a straight line to `to`, or the circular arc to `to` through `via`.
struct PathItem {
  Point to;
  std::optional<Point> via{};
};

struct Circle {
  Point center;
  double radius = 0;  ///< model units, > 0
};

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
  std::string name{};
  Path path{};
  std::optional<double> size{};  ///< target edge length at the line, model units
};

/// A point constraint: a mesh node will stand there.
struct NamedPoint {
  std::string name{};
  Point at{};
  std::optional<double> size{};  ///< target edge length at the point, model units
  std::string where{};
};

/// Names the cell (piece of the domain between the lines) that holds the point `at`.
struct Region {
  std::string name{};
  Point at{};
  std::optional<double> size{};  ///< target edge length inside the cell, model units
  std::string where{};
};

/// The input: a plane domain with holes, line constraints, point constraints and regions ("model v1").
struct Model {
  std::string name{};
  std::string about{};
  std::string units{};
  std::string file{};  ///< for messages only
  double size = 0;     ///< target edge length, model units, > 0
  std::vector<Path> outer{};
  std::vector<Path> holes{};
  std::vector<Line> lines{};
  std::vector<NamedPoint> points{};
  std::vector<Region> regions{};
};

}  // namespace quadline
