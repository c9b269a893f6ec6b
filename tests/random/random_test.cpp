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

constexpr int kModels = 50;  // of each family

Model model_of(const Family& family, int seed) {
  Dice dice(static_cast<std::uint64_t>(seed));
  return family.make(dice);
}

/// Meshes models, and holds every mesh against its model.
class Inspector {
 public:
  explicit Inspector(const Family& family) : family_(family) {}

  void inspect(const Model& model, const Options& options, const std::string& which) {
    Context context;
    const MeshResult result = generate(model, options, context);
    ++n_models_;
    for (const StageTime& time : result.report.stages) n_attempts_ += time.stage == "verify";
    if (const auto& failure = result.failure) {
      ++n_refused_;
      EXPECT_TRUE(family_.is_hard && !failure->reason.empty()) << which << ": " << failure->reason;
      return;
    }
    EXPECT_EQ(broken(model, result.mesh, family_.lines_stay_inside), std::vector<std::string>()) << which;
    EXPECT_EQ(result.report.quality.n_inverted, 0u) << which;
  }

  void expect_few_attempts() const {
    EXPECT_LE(n_refused_, n_models_ / 10);
    if (family_.is_hard) return;
    EXPECT_LE(n_attempts_, n_models_ * 11 / 10) << "the first mesh should do, nearly always";
  }

 private:
  const Family& family_;
  int n_models_ = 0, n_attempts_ = 0, n_refused_ = 0;
};

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

bool is_straight(const Path& path) {
  return std::none_of(path.items.begin(), path.items.end(), [](const PathItem& i) { return i.via.has_value(); });
}

/// The other order and direction of everything.
void reverse_all(Model& model) {
  std::reverse(model.lines.begin(), model.lines.end());
  std::reverse(model.holes.begin(), model.holes.end());
  for (Path& path : model.outer)
    if (is_straight(path)) std::reverse(path.items.begin(), path.items.end());
  for (Line& line : model.lines)
    if (is_straight(line.path)) std::reverse(line.path.items.begin(), line.path.items.end());
}

class Random : public testing::TestWithParam<Family> {};

TEST_P(Random, MeshKeepsThePromise) {
  Inspector inspector(GetParam());
  for (int seed = 1; seed <= kModels; ++seed)
    inspector.inspect(model_of(GetParam(), seed), {}, "seed " + std::to_string(seed));
  inspector.expect_few_attempts();
}

TEST_P(Random, OtherOptionsKeepItToo) {
  Options one_sided, delaunay, coarse, merge, split;
  one_sided.lines = LineFronts::OneSided;
  delaunay.triangles = Triangles::Delaunay;
  merge.method = Method::Merge;
  split.method = Method::Split;
  Inspector inspector(GetParam());
  for (int seed = 1; seed <= 5; ++seed) {
    const Model model = model_of(GetParam(), seed);
    coarse.size = 3 * model.size;
    inspector.inspect(model, one_sided, "one-sided, seed " + std::to_string(seed));
    inspector.inspect(model, delaunay, "delaunay, seed " + std::to_string(seed));
    inspector.inspect(model, coarse, "coarse, seed " + std::to_string(seed));
    inspector.inspect(model, merge, "merge, seed " + std::to_string(seed));
    inspector.inspect(model, split, "split, seed " + std::to_string(seed));
  }
  inspector.expect_few_attempts();
}

TEST_P(Random, MovedTurnedMirroredReorderedKeepsIt) {
  Inspector inspector(GetParam());
  for (int seed = 1; seed <= 5; ++seed) {
    Model model = model_of(GetParam(), seed);
    reverse_all(model);
    move_all(model, [](Point p) { return Point{p.y + 3, p.x - 7}; });
    inspector.inspect(model, {}, "seed " + std::to_string(seed));
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
