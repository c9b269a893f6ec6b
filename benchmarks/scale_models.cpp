#include "scale_models.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <string>

namespace quadline {

namespace {

Path straight(Point a, Point b) { return {.items = {{a, {}}, {b, {}}}, .circle = {}, .where = "path"}; }

Path circle(Point center, double radius) { return {.items = {}, .circle = Circle{center, radius}, .where = "hole"}; }

Path manhole(Point center, double length, double width) {
  const double r = width / 2, h = (length - width) / 2;
  const auto at = [&](double x, double y) { return center + Point{x, y}; };
  return {.items = {{at(-h, -r), {}},
                    {at(h, -r), {}},
                    {at(h, r), at(h + r, 0)},
                    {at(-h, r), {}},
                    {at(-h, -r), at(-h - r, 0)}},
          .circle = {},
          .where = "manhole"};
}

Model rectangle(double width, double height) {
  Model m;
  m.outer = {{.items = {{{0, 0}, {}}, {{width, 0}, {}}, {{width, height}, {}}, {{0, height}, {}}},
              .circle = {},
              .where = "outer"}};
  return m;
}

void add_line(Model& m, const Path& path) {
  m.lines.push_back({.name = "line-" + std::to_string(m.lines.size()), .path = path, .size = {}});
}

}  // namespace

Model panel(double quads) {
  constexpr double kBay = 800;
  const double bays = std::max(2.0, quads / (0.94 * (quads >= 400 ? 64 : 16)));
  const int ny = std::max(1, static_cast<int>(std::lround(std::sqrt(bays / 1.6))));
  const int nx = std::max(2, static_cast<int>(std::lround(bays / ny)));
  const double width = nx * kBay, height = ny * kBay;
  Model m = rectangle(width, height);
  for (int j = 1; j < ny; ++j) add_line(m, straight({0, j * kBay}, {width, j * kBay}));
  for (int i = 3; i < nx; i += 3) add_line(m, straight({i * kBay, 0}, {i * kBay, height}));
  double area = width * height;
  for (int j = 0; j < ny; ++j)
    for (int i = 0; i < nx; ++i) {
      const Point center{(i + 0.5) * kBay, (j + 0.5) * kBay};
      if (i % 3 == 1 && j % 2 == 0) {
        m.holes.push_back(manhole(center, 600, 400));
        area -= 200 * 400 + std::numbers::pi * 200 * 200;
      } else if ((i + 2 * j) % 7 == 3) {
        m.holes.push_back(circle(center, 150));
        area -= std::numbers::pi * 150 * 150;
      } else if ((2 * i + j) % 5 == 0) {
        add_line(m, straight({center.x, j * kBay}, {center.x, j * kBay + 500}));
      }
    }
  m.size = std::sqrt(area / quads);
  return m;
}

Model random_lines(double quads) {
  constexpr double kCell = 500;
  std::uint64_t state = 20;
  const auto number = [&](double low, double high) {  // the same on every machine
    state = state * 6364136223846793005u + 1442695040888963407u;
    return low + (high - low) * static_cast<double>(state >> 11) * 0x1p-53;
  };
  const int n = std::max(1, static_cast<int>(std::lround(std::sqrt(quads / 100))));
  Model m = rectangle(n * kCell, n * kCell);
  double area = n * kCell * n * kCell;
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      const Point center{(i + 0.5) * kCell, (j + 0.5) * kCell};
      const double what = number(0, 1);
      if (what < 0.15) {
        const double radius = number(30, 150);
        m.holes.push_back(circle(center, radius));
        area -= std::numbers::pi * radius * radius;
      } else if (what < 0.83) {
        const double angle = number(0, std::numbers::pi), half = number(60, 215);
        const Point along{half * std::cos(angle), half * std::sin(angle)};
        add_line(m, straight(center - along, center + along));
      }
    }
  m.size = std::sqrt(area / quads);
  return m;
}

Model plain(double quads) {
  Model m = rectangle(1000, 1000);
  m.size = 1000 / std::sqrt(quads);
  return m;
}

}  // namespace quadline
