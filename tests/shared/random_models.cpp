#include "random_models.hpp"

#include <cmath>
#include <numbers>

namespace quadline {

double Dice::number(double low, double high) {
  state_ ^= state_ << 13;
  state_ ^= state_ >> 7;
  state_ ^= state_ << 17;
  return low + (high - low) * static_cast<double>(state_ >> 11) * 0x1p-53;
}

int Dice::whole(int low, int high) { return static_cast<int>(std::floor(number(low, high + 1))); }

namespace {

Path chain(const std::vector<Point>& points, const std::string& where = "path") {
  Path path;
  path.where = where;
  for (const Point p : points) path.items.push_back({p, {}});
  return path;
}

Path circle(Point center, double radius) { return {.items = {}, .circle = Circle{center, radius}, .where = "hole"}; }

Model plate(double width, double height, double size) {
  Model m;
  m.size = size;
  m.outer = {chain({{0, 0}, {width, 0}, {width, height}, {0, height}})};
  return m;
}

void add_line(Model& m, const Path& path) {
  m.lines.push_back({.name = "line-" + std::to_string(m.lines.size()), .path = path, .size = {}});
}

Model line_soup(Dice& dice) {  // lines that cross anywhere, at any angle
  Model m = plate(10, 7, 0.5);
  for (int n = dice.whole(1, 8); n > 0; --n) {
    const Point a{dice.number(0.3, 9.7), dice.number(0.3, 6.7)}, b{dice.number(0.3, 9.7), dice.number(0.3, 6.7)};
    add_line(m, chain({a, b}));
  }
  return m;
}

Model stiffened(Dice& dice) {
  Model m = plate(12, 8, 0.5);
  for (int n = dice.whole(1, 4), i = 1; i <= n; ++i) {
    const double y = 8.0 * i / (n + 1);
    add_line(m, chain({{0, y}, {dice.whole(0, 1) ? 12 : dice.number(4, 11), y}}));
  }
  for (int n = dice.whole(0, 3), i = 1; i <= n; ++i) {
    const double x = 12.0 * i / (n + 1);
    add_line(m, chain({{x, 0}, {x, dice.whole(0, 1) ? 8 : dice.number(2, 7)}}));
  }
  return m;
}

Model holes(Dice& dice) {  // and a line across them
  Model m = plate(10, 10, 0.6);
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      if (dice.whole(0, 1)) m.holes.push_back(circle({1.9 + 3.1 * i, 1.9 + 3.1 * j}, dice.number(0.2, 1.1)));
  const Point a{dice.number(0.2, 0.6), dice.number(1, 9)}, b{dice.number(9.4, 9.8), dice.number(1, 9)};
  add_line(m, chain({a, b}));
  return m;
}

Model integer_grid(Dice& dice) {  // everything meets everything, exactly
  Model m = plate(8, 8, 1);
  const auto corner = [&] {
    return Point{static_cast<double>(dice.whole(0, 8)), static_cast<double>(dice.whole(0, 8))};
  };
  for (int n = dice.whole(2, 7); n > 0; --n) {
    const Point a = corner(), b = corner();
    if (a == b) continue;
    add_line(m, chain({a, b}));
  }
  return m;
}

Model star_polygon(Dice& dice) {
  Model m;
  m.size = 0.5;
  const int n = dice.whole(5, 14);
  std::vector<Point> loop;
  for (int i = 0; i < n; ++i) {
    const double angle = 2 * std::numbers::pi * i / n, r = dice.number(2.5, 5);
    loop.push_back({r * std::cos(angle), r * std::sin(angle)});
  }
  m.outer = {chain(loop)};
  const Point at{dice.number(-1, 1), dice.number(-1, 1)};
  m.points.push_back({.name = "middle", .at = at, .size = {}, .where = "point"});
  const Point a{dice.number(-1.5, -0.2), dice.number(-1, 1)}, b{dice.number(0.2, 1.5), dice.number(-1, 1)};
  add_line(m, chain({a, b}));
  return m;
}

Model sizes(Dice& dice) {  // fine at a line and a point
  Model m = plate(10, 6, 0.8);
  const Point end{dice.number(4, 6), dice.number(2, 5)};
  add_line(m, chain({{2, 2}, end}));
  m.lines.back().size = dice.number(0.1, 0.6);
  m.points.push_back({.name = "fine", .at = {8, 3}, .size = dice.number(0.05, 0.5), .where = "point"});
  add_line(m, {.items = {{{6.5, 1}, {}}, {{8.5, 1}, Point{7.5, 1.6}}}, .circle = {}, .where = {}});
  return m;
}

Model islands(Dice& dice) {  // plates in the hole of a plate, and beside it; closed line loops
  Model m = plate(12, 8, 0.6);
  m.holes.push_back(chain({{2, 2}, {7, 2}, {7, 6}, {2, 6}}));
  const double w = dice.number(0.5, 3.5), h = dice.number(0.5, 2.5);
  m.outer.push_back(chain({{3, 3}, {3 + w, 3}, {3 + w, 3 + h}, {3, 3 + h}}));
  m.outer.push_back(chain({{13, 0}, {16, 0}, {14, dice.number(1, 8)}}));
  m.lines.push_back({.name = "pad", .path = circle({9.5, 4}, dice.number(0.4, 1.8)), .size = {}});
  return m;
}

Model near_misses(Dice& dice) {  // ends and lines that almost touch: from a hundredth of the size upwards
  Model m = plate(8, 6, 0.5);
  m.holes.push_back(circle({6, 3}, 0.8));
  const auto gap = [&] { return 0.5 * std::pow(10, dice.number(-2, 0)); };
  add_line(m, chain({{gap(), 1}, {8 - gap(), 1}}));
  add_line(m, chain({{dice.number(0.5, 2), 1 + gap()}, {dice.number(3, 4.5), 1 + gap()}}));
  add_line(m, chain({{2, 1 + gap()}, {2 + gap(), 6 - gap()}}));
  add_line(m, chain({{2 + gap(), 3}, {5.2 - gap(), 3}}));
  return m;
}

Model arcs(Dice& dice) {  // cross each other, the boundary and the hole, anywhere
  Model m = plate(10, 7, 0.5);
  m.outer[0].items.push_back({{0, 0}, Point{-dice.number(0.2, 3), 3.5}});
  m.holes.push_back(circle({5, 3.5}, dice.number(0.3, 1.5)));
  const auto place = [&] { return Point{dice.number(-1, 11), dice.number(-1, 8)}; };
  for (int n = dice.whole(1, 4); n > 0; --n) {
    const Point from = place(), via = place(), to = place();
    add_line(m, {.items = {{from, {}}, {to, via}}, .circle = {}, .where = "arc"});
  }
  return m;
}

Model fan(Dice& dice) {  // lines that leave a point at small angles
  Model m = plate(10, 6, 0.5);
  double angle = dice.number(-0.5, 0);
  for (int n = dice.whole(2, 6); n > 0; --n, angle += dice.number(0.05, 0.4)) {
    const double length = dice.number(1, 2.8);
    add_line(m, chain({{3, 3}, {3 + length * std::cos(angle), 3 + length * std::sin(angle)}}));
  }
  return m;
}

}  // namespace

const std::vector<Family>& families() {
  static const std::vector<Family> all = {{"line_soup", line_soup},
                                          {"stiffened", stiffened},
                                          {"holes", holes},
                                          {"integer_grid", integer_grid},
                                          {"star_polygon", star_polygon},
                                          {"sizes", sizes},
                                          {"islands", islands},
                                          {"near_misses", near_misses, true},
                                          {"arcs", arcs, false, 0.01},
                                          {"fan", fan}};
  return all;
}

}  // namespace quadline
