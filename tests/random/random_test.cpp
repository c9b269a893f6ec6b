// Random models, by seed, through the whole pipeline: every one ends with a mesh that keeps its promise.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "invariants.hpp"
#include "quadline/generate.hpp"
#include "random_models.hpp"

namespace quadline {

void PrintTo(const Family& family, std::ostream* out) { *out << family.name; }

namespace {

constexpr int kModels = 25;  // of each family

Model model_of(const Family& family, int seed) {
  Dice dice(static_cast<std::uint64_t>(seed));
  return family.make(dice);
}

/// Meshes the model and says what is wrong with the mesh; empty where nothing is.
std::string faults(const Model& model, const Options& options, bool lines_stay_inside) {
  Context context;
  const MeshResult result = generate(model, options, context);
  if (const auto& failure = result.failure) return failure->stage + ": " + failure->reason;
  std::string all;
  for (const std::string& what : broken(model, result.mesh, lines_stay_inside)) all += what + "; ";
  if (result.report.quality.n_inverted != 0) all += "the report counts inverted quads; ";
  return all;
}

/// Applies f to every coordinate.
template <class F>
void move_all(Model& model, F f) {
  const auto move = [&](Path& path) {
    for (PathItem& item : path.items) {
      item.to = f(item.to);
      if (item.via) item.via = f(*item.via);
    }
    if (path.circle) path.circle->center = f(path.circle->center);
  };
  for (Path& path : model.outer) move(path);
  for (Path& path : model.holes) move(path);
  for (Line& line : model.lines) move(line.path);
  for (NamedPoint& point : model.points) point.at = f(point.at);
}

/// The other order and direction of everything.
void reverse_all(Model& model) {
  std::reverse(model.lines.begin(), model.lines.end());
  std::reverse(model.holes.begin(), model.holes.end());
  for (Path& path : model.outer) std::reverse(path.items.begin(), path.items.end());
  for (Line& line : model.lines)
    if (std::none_of(line.path.items.begin(), line.path.items.end(), [](const PathItem& i) { return i.via; }))
      std::reverse(line.path.items.begin(), line.path.items.end());
}

class Random : public testing::TestWithParam<Family> {};

TEST_P(Random, MeshKeepsThePromise) {
  for (int seed = 1; seed <= kModels; ++seed)
    EXPECT_EQ(faults(model_of(GetParam(), seed), {}, GetParam().lines_stay_inside), "") << "seed " << seed;
}

TEST_P(Random, OtherOptionsKeepItToo) {
  Options one_sided, front, coarse;
  one_sided.lines = LineFronts::OneSided;
  front.triangles = Triangles::Front;
  for (int seed = 1; seed <= 5; ++seed) {
    const Model model = model_of(GetParam(), seed);
    coarse.size = 3 * model.size;
    for (const Options& options : {one_sided, front, coarse})
      EXPECT_EQ(faults(model, options, GetParam().lines_stay_inside), "") << "seed " << seed;
  }
}

TEST_P(Random, MovedTurnedMirroredReorderedKeepsIt) {
  for (int seed = 1; seed <= 5; ++seed) {
    Model model = model_of(GetParam(), seed);
    reverse_all(model);
    move_all(model, [](Point p) { return Point{p.y + 3, p.x - 7}; });
    EXPECT_EQ(faults(model, {}, GetParam().lines_stay_inside), "") << "seed " << seed;
  }
}

TEST_P(Random, SameModelGivesTheSameMesh) {
  Context context;
  const Model model = model_of(GetParam(), 1);
  const MeshResult a = generate(model, {}, context), b = generate(model, {}, context);
  EXPECT_EQ(a.mesh.quads, b.mesh.quads);
  EXPECT_EQ(a.mesh.points, b.mesh.points);
}

TEST_P(Random, ScalingByAPowerOfTwoScalesTheMeshBitForBit) {
  const double k = 1024;
  const Model model = model_of(GetParam(), 1);
  Model large = model;
  move_all(large, [k](Point p) { return k * p; });
  large.size *= k;
  for (Path& hole : large.holes)
    if (hole.circle) hole.circle->radius *= k;
  for (Line& line : large.lines) {
    if (line.path.circle) line.path.circle->radius *= k;
    if (line.size) *line.size *= k;
  }
  for (NamedPoint& point : large.points)
    if (point.size) *point.size *= k;
  Context context;
  const MeshResult a = generate(model, {}, context), b = generate(large, {}, context);
  ASSERT_EQ(a.mesh.points.size(), b.mesh.points.size());
  EXPECT_EQ(a.mesh.quads, b.mesh.quads);
  for (std::size_t i = 0; i < a.mesh.points.size(); ++i) ASSERT_EQ(k * a.mesh.points[i], b.mesh.points[i]) << i;
}

INSTANTIATE_TEST_SUITE_P(Families, Random, testing::ValuesIn(families()),
                         [](const auto& family) { return family.param.name; });

}  // namespace
}  // namespace quadline
