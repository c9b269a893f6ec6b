#include "wild_models.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <string>
#include <utility>

namespace quadline {

namespace {

Model plate(double width, double height, double size) {
  Model m;
  m.size = size;
  m.outer = {{.items = {{{0, 0}, {}}, {{width, 0}, {}}, {{width, height}, {}}, {{0, height}, {}}},
              .circle = {},
              .where = "outer"}};
  return m;
}

Path chain(const std::vector<Point>& points) {
  Path path;
  for (const Point p : points) path.items.push_back({p, {}});
  return path;
}

Path circle(Point center, double radius) { return {.items = {}, .circle = Circle{center, radius}, .where = "hole"}; }

void add_line(Model& m, Path path) {
  m.lines.push_back({.name = "line-" + std::to_string(m.lines.size()), .path = std::move(path), .size = {}});
}

Point on_circle(Point center, double radius, double angle) {
  return {center.x + radius * std::cos(angle), center.y + radius * std::sin(angle)};
}

Model dense_soup(Dice& dice) {
  Model m = plate(10, 7, 0.5);
  for (int n = dice.whole(1, 60); n > 0; --n)
    add_line(m, chain({{dice.number(0, 10), dice.number(0, 7)}, {dice.number(0, 10), dice.number(0, 7)}}));
  return m;
}

Model star(Dice& dice) {  // lines through one place, nearly
  Model m = plate(10, 8, 0.5);
  const double miss = dice.whole(0, 1) ? 0 : 0.5 * std::pow(10, dice.number(-6, 0));
  for (int n = dice.whole(2, 12); n > 0; --n) {
    const Point c{5 + miss * dice.number(-1, 1), 4 + miss * dice.number(-1, 1)};
    const double angle = dice.number(0, 2 * std::numbers::pi);
    add_line(m, chain({on_circle(c, dice.whole(0, 1) ? 0 : -3, angle), on_circle(c, dice.number(1, 3.5), angle)}));
  }
  return m;
}

Model near_parallel(Dice& dice) {
  Model m = plate(10, 8, 0.5);
  for (int n = dice.whole(1, 4); n > 0; --n) {
    const Point a{dice.number(1, 4), dice.number(1, 7)}, b{dice.number(6, 9), dice.number(1, 7)};
    const auto off = [&](Point p) { return Point{p.x, p.y + 0.5 * std::pow(10, dice.number(-6, -0.5))}; };
    add_line(m, chain({a, b}));
    add_line(m, chain({off(a), off(b)}));
  }
  return m;
}

Model comb(Dice& dice) {  // a boundary with teeth
  const int teeth = dice.whole(2, 12);
  const double pitch = dice.number(0.2, 2), width = pitch * dice.number(0.1, 0.9);
  std::vector<Point> loop{{0, 0}, {teeth * pitch, 0}};
  for (int i = teeth; i-- > 0;) {
    const double right = i * pitch + width, top = dice.number(2, 6);
    for (const Point p : {Point{right, 1}, {right, top}, {i * pitch, top}, {i * pitch, 1}}) loop.push_back(p);
  }
  loop[1].x = (teeth - 1) * pitch + width;
  loop.erase(loop.begin() + 2);
  loop.pop_back();
  Model m;
  m.size = 0.5;
  m.outer = {chain(loop)};
  if (dice.whole(0, 1)) add_line(m, chain({{0, 0.5}, {loop[1].x, dice.number(0.1, 0.9)}}));
  return m;
}

Model polygon_with_holes(Dice& dice) {
  const auto polygon = [&](Point c, double low, double high) {
    std::vector<Point> loop;
    for (int n = dice.whole(3, 12), i = 0; i < n; ++i)
      loop.push_back(on_circle(c, dice.number(low, high), 2 * std::numbers::pi * i / n));
    return chain(loop);
  };
  Model m;
  m.size = dice.number(0.3, 1);
  m.outer = {polygon({0, 0}, 5, 9)};
  for (int n = dice.whole(0, 4), i = 0; i < n; ++i)
    m.holes.push_back(polygon(on_circle({0, 0}, 1.5, 2 * std::numbers::pi * i / n), 0.1, 0.9));
  if (dice.whole(0, 1))
    m.regions.push_back({.name = "r", .at = {0, 0}, .size = dice.number(0.1, 1), .where = "region"});
  return m;
}

Model tangents(Dice& dice) {  // circles, lines along their tangents, arcs that touch
  Model m = plate(10, 8, 0.5);
  const double r = dice.number(0.3, 1.8);
  if (dice.whole(0, 1)) {
    m.holes.push_back(circle({5, 4}, r));
  } else {
    add_line(m, circle({5, 4}, r));
  }
  add_line(m, chain({{dice.number(1, 5), 4 + r}, {dice.number(5, 9), 4 + r}}));
  const double angle = dice.number(0, 6), reach = dice.number(0.2, 2);
  const Point touch = on_circle({5, 4}, r, angle), along{-std::sin(angle), std::cos(angle)};
  add_line(m, chain({touch, touch + reach * along}));
  add_line(m, {.items = {{{5 + r, 4}, {}}, {{5 + 3 * r / 2, 4}, Point{5 + 1.25 * r, 4 + 0.25 * r}}},
               .circle = {},
               .where = {}});
  return m;
}

Model t_junctions(Dice& dice) {
  Model m = plate(10, 8, 0.5);
  for (int n = dice.whole(2, 12); n > 0; --n) {
    const double x = dice.whole(0, 20) * 0.5, y = dice.whole(0, 16) * 0.5, length = dice.whole(1, 10) * 0.5;
    if (dice.whole(0, 1)) {
      add_line(m, chain({{x, y}, {std::min(10.0, x + length), y}}));
    } else {
      add_line(m, chain({{x, y}, {x, std::min(8.0, y + length)}}));
    }
  }
  return m;
}

Model degenerate_grid(Dice& dice) {  // overlaps, touching holes, lines on the boundary, in whole numbers
  Model m = plate(6, 6, dice.number(0.3, 1.5));
  const auto at = [&] { return Point{1.0 * dice.whole(0, 6), 1.0 * dice.whole(0, 6)}; };
  for (int n = dice.whole(0, 3); n > 0; --n) {
    const double x = dice.whole(0, 5), y = dice.whole(0, 5);
    m.holes.push_back(chain({{x, y}, {x + 1, y}, {x + 1, y + 1}, {x, y + 1}}));
  }
  for (int n = dice.whole(0, 10); n > 0; --n) add_line(m, chain({at(), at(), at()}));
  for (int n = dice.whole(0, 3); n > 0; --n)
    m.points.push_back({.name = "p" + std::to_string(n), .at = at(), .size = {}, .where = "point"});
  return m;
}

Model tiny_gaps(Dice& dice) {  // ends from 1e-6 to 0.1 of the size off other lines, before and behind them
  Model m = plate(8, 6, 0.5);
  add_line(m, chain({{1, 3}, {7, dice.number(2, 4)}}));
  const Point a = m.lines[0].path.items[0].to, b = m.lines[0].path.items[1].to;
  for (int n = dice.whole(1, 6); n > 0; --n) {
    const double gap = 0.5 * std::pow(10, dice.number(-6, -1)) * (dice.whole(0, 1) ? 1 : -1);
    const Point foot = a + dice.number(0, 1) * (b - a);
    add_line(m, chain({{foot.x, foot.y + gap}, {dice.number(1, 7), dice.number(4.5, 5.8)}}));
  }
  return m;
}

Model mixed_sizes(Dice& dice) {
  Model m = plate(10, 7, 0.6);
  const auto size = [&] { return 0.6 * std::pow(10, dice.number(-1.2, 0.5)); };
  for (int n = dice.whole(1, 4); n > 0; --n) {
    add_line(m,
             chain({{dice.number(0.3, 9.7), dice.number(0.3, 6.7)}, {dice.number(0.3, 9.7), dice.number(0.3, 6.7)}}));
    m.lines.back().size = size();
  }
  for (int n = dice.whole(0, 3); n > 0; --n)
    m.points.push_back({.name = "p" + std::to_string(n),
                        .at = {dice.number(0.1, 9.9), dice.number(0.1, 6.9)},
                        .size = size(),
                        .where = "point"});
  m.regions.push_back({.name = "r", .at = {dice.number(0, 10), dice.number(0, 7)}, .size = size(), .where = "region"});
  return m;
}

}  // namespace

const std::vector<Family>& wild_families() {
  static const std::vector<Family> all = [] {
    std::vector<Family> list = families();
    const Family wild[] = {{"dense_soup", dense_soup},
                           {"star", star},
                           {"near_parallel", near_parallel},
                           {"comb", comb},
                           {"polygon_with_holes", polygon_with_holes},
                           {"tangents", tangents},
                           {"t_junctions", t_junctions},
                           {"degenerate_grid", degenerate_grid},
                           {"tiny_gaps", tiny_gaps},
                           {"mixed_sizes", mixed_sizes}};
    std::copy(std::begin(wild), std::end(wild), std::back_inserter(list));
    return list;
  }();
  return all;
}

}  // namespace quadline
