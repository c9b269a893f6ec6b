// Random models, by seed, through the whole pipeline: every one ends with a mesh that keeps its promise.
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <optional>
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
    EXPECT_EQ(broken(model, result.mesh), std::vector<std::string>()) << which;
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
  for (Region& region : model.regions) region.at = f(region.at);
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
  for (int seed = 1; seed <= 2; ++seed) {
    const std::string which = ", seed " + std::to_string(seed);
    Model turned = model_of(GetParam(), seed), mirrored = turned, reordered = turned;
    move_all(turned, [](Point p) { return Point{0.8 * p.x - 0.6 * p.y + 3, 0.6 * p.x + 0.8 * p.y - 7}; });
    move_all(mirrored, [](Point p) { return Point{p.y, p.x}; });
    reverse_all(reordered);
    inspector.inspect(turned, {}, "turned" + which);
    inspector.inspect(mirrored, {}, "mirrored" + which);
    inspector.inspect(reordered, {}, "reordered" + which);
  }
}

/// All that a mesh holds, its coordinates times k.
void expect_same(const Mesh& a, const Mesh& b, double k) {
  ASSERT_FALSE(a.quads.empty());
  EXPECT_EQ(a.quads, b.quads);
  EXPECT_EQ(a.quad_region, b.quad_region);
  ASSERT_EQ(a.points.size(), b.points.size());
  for (std::size_t i = 0; i < a.points.size(); ++i) ASSERT_EQ(k * a.points[i], b.points[i]) << i;
  ASSERT_EQ(a.curves.size(), b.curves.size());
  for (std::size_t i = 0; i < a.curves.size(); ++i) EXPECT_EQ(a.curves[i].edges, b.curves[i].edges) << i;
  ASSERT_EQ(a.node_sets.size(), b.node_sets.size());
  for (std::size_t i = 0; i < a.node_sets.size(); ++i) EXPECT_EQ(a.node_sets[i].nodes, b.node_sets[i].nodes) << i;
}

TEST_P(Random, SameModelGivesTheSameMeshWhateverTheOrderOfTheCells) {
  const Model model = model_of(GetParam(), 1);
  Context forwards, backwards;
  backwards.run_all = [](std::size_t n, const std::function<void(std::size_t)>& job) {
    while (n-- > 0) job(n);
  };
  expect_same(generate(model, {}, forwards).mesh, generate(model, {}, backwards).mesh, 1);
}

TEST_P(Random, ScalingByAPowerOfTwoScalesTheMeshBitForBit) {
  const double k = 1024;
  const auto scale = [k](std::optional<double>& size) {
    if (size) *size *= k;
  };
  const Model model = model_of(GetParam(), 1);
  Model large = model;
  move_all(large, [k](Point p) { return k * p; });
  large.size *= k;
  for (Path& hole : large.holes)
    if (hole.circle) hole.circle->radius *= k;
  for (Line& line : large.lines) {
    if (line.path.circle) line.path.circle->radius *= k;
    scale(line.size);
  }
  for (NamedPoint& point : large.points) scale(point.size);
  for (Region& region : large.regions) scale(region.size);
  Context context;
  expect_same(generate(model, {}, context).mesh, generate(large, {}, context).mesh, k);
}

TEST(Invariants, SeeLinesAndArcsThatAreNotCovered) {
  const auto sizes = std::ranges::find(families(), "sizes", &Family::name);
  const Model model = model_of(*sizes, 1);  // line-0 is straight, line-1 an arc
  Context context;
  const Mesh mesh = generate(model, {}, context).mesh;
  ASSERT_EQ(broken(model, mesh), std::vector<std::string>());
  for (const std::string name : {"line-0", "line-1"}) {
    Mesh shorter = mesh, doubled = mesh, astray = mesh;
    const auto edges = [&](Mesh& m) -> auto& { return std::ranges::find(m.curves, name, &EdgeSet::name)->edges; };
    edges(shorter).pop_back();
    edges(doubled).push_back(edges(doubled).front());
    edges(astray).front() = mesh.curves.front().edges.front();  // on the outer loop
    const auto first_words = [&](const Mesh& m) {
      const std::vector<std::string> notes = broken(model, m);
      return notes.empty() ? "" : notes[0].substr(0, notes[0].find(" at "));
    };
    EXPECT_EQ(first_words(shorter), "'" + name + "' is not covered");
    EXPECT_EQ(first_words(doubled), "two edges of '" + name + "' lie on each other");
    EXPECT_EQ(first_words(astray), "'" + name + "' is not covered");
    EXPECT_EQ(broken(model, astray).size(), 2u) << "off its line, too";
  }
}

INSTANTIATE_TEST_SUITE_P(Families, Random, testing::ValuesIn(families()),
                         [](const auto& family) { return family.param.name; });

}  // namespace
}  // namespace quadline
