// Random models, by seed, through the whole pipeline: every one ends with a mesh that keeps its promise or with one
// clear error.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <numbers>
#include <string>

#include "quadline/generate.hpp"

namespace quadline {
namespace {

/// The same numbers on every machine, unlike the distributions of <random>.
class Dice {
 public:
  explicit Dice(std::uint64_t seed) : state_(seed * 0x9E3779B97F4A7C15u + 1) {}
  double number(double low, double high) {
    state_ ^= state_ << 13;
    state_ ^= state_ >> 7;
    state_ ^= state_ << 17;
    return low + (high - low) * static_cast<double>(state_ >> 11) * 0x1p-53;
  }
  int whole(int low, int high) { return static_cast<int>(std::floor(number(low, high + 1))); }

 private:
  std::uint64_t state_;
};

Path straight(Point a, Point b) { return {.items = {{a, {}}, {b, {}}}, .circle = {}, .where = {}}; }

Model plate(double width, double height, double size) {
  Model m;
  m.size = size;
  m.outer = {{.items = {{{0, 0}, {}}, {{width, 0}, {}}, {{width, height}, {}}, {{0, height}, {}}},
              .circle = {},
              .where = "outer"}};
  return m;
}

void add_line(Model& m, const Path& path) {
  m.lines.push_back({.name = "line-" + std::to_string(m.lines.size()), .path = path, .size = {}});
}

Model line_soup(Dice& dice) {
  Model m = plate(10, 7, 0.5);
  for (int n = dice.whole(1, 8); n > 0; --n)
    add_line(m,
             straight({dice.number(0.3, 9.7), dice.number(0.3, 6.7)}, {dice.number(0.3, 9.7), dice.number(0.3, 6.7)}));
  return m;
}

Model stiffened(Dice& dice) {
  Model m = plate(12, 8, 0.5);
  for (int n = dice.whole(1, 4), i = 1; i <= n; ++i) {
    const double y = 8.0 * i / (n + 1);
    add_line(m, straight({0, y}, {dice.whole(0, 1) ? 12 : dice.number(4, 11), y}));
  }
  for (int n = dice.whole(0, 3), i = 1; i <= n; ++i) {
    const double x = 12.0 * i / (n + 1);
    add_line(m, straight({x, 0}, {x, dice.whole(0, 1) ? 8 : dice.number(2, 7)}));
  }
  return m;
}

Model holes(Dice& dice) {
  Model m = plate(10, 10, 0.6);
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      if (dice.whole(0, 1))
        m.holes.push_back(
            {.items = {}, .circle = Circle{{1.9 + 3.1 * i, 1.9 + 3.1 * j}, dice.number(0.2, 1.1)}, .where = "hole"});
  add_line(m, straight({dice.number(0.2, 0.6), dice.number(1, 9)}, {dice.number(9.4, 9.8), dice.number(1, 9)}));
  return m;
}

Model integer_grid(Dice& dice) {  // everything meets everything, exactly
  Model m = plate(8, 8, 1);
  for (int n = dice.whole(2, 7); n > 0; --n)
    add_line(m, straight({static_cast<double>(dice.whole(0, 8)), static_cast<double>(dice.whole(0, 8))},
                         {static_cast<double>(dice.whole(0, 8)), static_cast<double>(dice.whole(0, 8))}));
  return m;
}

Model star_polygon(Dice& dice) {
  Model m;
  m.size = 0.5;
  const int n = dice.whole(5, 14);
  Path loop{.items = {}, .circle = {}, .where = "outer"};
  for (int i = 0; i < n; ++i) {
    const double angle = 2 * std::numbers::pi * i / n, r = dice.number(2.5, 5);
    loop.items.push_back({{r * std::cos(angle), r * std::sin(angle)}, {}});
  }
  m.outer = {loop};
  m.points.push_back({.name = "middle", .at = {dice.number(-1, 1), dice.number(-1, 1)}, .size = {}, .where = "point"});
  add_line(m, straight({dice.number(-1.5, -0.2), dice.number(-1, 1)}, {dice.number(0.2, 1.5), dice.number(-1, 1)}));
  return m;
}

Model sizes(Dice& dice) {
  Model m = plate(10, 6, 0.8);
  add_line(m, straight({2, 2}, {dice.number(4, 6), dice.number(2, 5)}));
  m.lines.back().size = dice.number(0.1, 0.6);
  m.points.push_back({.name = "fine", .at = {8, 3}, .size = dice.number(0.05, 0.5), .where = "point"});
  add_line(m, {.items = {{{6.5, 1}, {}}, {{8.5, 1}, Point{7.5, 1.6}}}, .circle = {}, .where = {}});
  return m;
}

using Maker = Model (*)(Dice&);
struct Family {
  const char* name;
  Maker make;
};

class Random : public testing::TestWithParam<Family> {};

TEST_P(Random, EndsWithAMeshOrAClearError) {
  int meshed = 0;
  constexpr int kModels = 25;
  for (int seed = 1; seed <= kModels; ++seed) {
    Dice dice(static_cast<std::uint64_t>(seed));
    const Model model = GetParam().make(dice);
    Context context;
    try {
      const MeshResult result = generate(model, {}, context);
      EXPECT_TRUE(result.mesh.triangles.empty()) << GetParam().name << " " << seed;
      if (result.failure) {
        ADD_FAILURE() << GetParam().name << " " << seed << ": " << result.failure->stage << ": "
                      << result.failure->reason << " at (" << result.failure->at.x << ", " << result.failure->at.y
                      << ")";
        continue;
      }
      EXPECT_EQ(result.report.quality.n_inverted, 0u) << GetParam().name << " " << seed;
      ++meshed;
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()), "") << seed;
    }
  }
  EXPECT_GE(meshed, kModels * 9 / 10) << GetParam().name;
}

INSTANTIATE_TEST_SUITE_P(Families, Random,
                         testing::Values(Family{"line soup", line_soup}, Family{"stiffened", stiffened},
                                         Family{"holes", holes}, Family{"integer grid", integer_grid},
                                         Family{"star polygon", star_polygon}, Family{"sizes", sizes}),
                         [](const auto& family) {
                           std::string name = family.param.name;
                           for (char& c : name)
                             if (c == ' ') c = '_';
                           return name;
                         });

TEST(Random, SameModelGivesTheSameMesh) {
  Dice dice(5), again(5);
  Context context;
  const MeshResult a = generate(line_soup(dice), {}, context), b = generate(line_soup(again), {}, context);
  EXPECT_EQ(a.mesh.quads, b.mesh.quads);
  EXPECT_EQ(a.mesh.points, b.mesh.points);
}

TEST(Random, ScalingByAPowerOfTwoScalesTheMeshBitForBit) {
  Dice dice(7), again(7);
  Model model = line_soup(dice), large = line_soup(again);
  const double k = 1024;
  large.size *= k;
  for (PathItem& item : large.outer[0].items) item.to = k * item.to;
  for (Line& line : large.lines)
    for (PathItem& item : line.path.items) item.to = k * item.to;
  Context context;
  const MeshResult a = generate(model, {}, context), b = generate(large, {}, context);
  ASSERT_EQ(a.mesh.points.size(), b.mesh.points.size());
  EXPECT_EQ(a.mesh.quads, b.mesh.quads);
  for (std::size_t i = 0; i < a.mesh.points.size(); ++i) EXPECT_EQ(k * a.mesh.points[i], b.mesh.points[i]);
}

}  // namespace
}  // namespace quadline
