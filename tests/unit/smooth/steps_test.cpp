// Each step of smoothing by itself, most of them at one node in a ring of fixed ones.
#include <gtest/gtest.h>

#include <cmath>

#include "cells/flatten.hpp"
#include "quadline/quality.hpp"
#include "stages/smooth/shape_energy.hpp"
#include "stages/smooth/steps.hpp"
#include "unit/grid_patch.hpp"

namespace quadline::smoothing {
namespace {

using shapes::least_jacobian;
using shapes::Patch;

/// Four quads round node 0, the others fixed: `ring` goes round counter-clockwise and begins with a neighbour.
Patch ring_of(Point centre, const std::vector<Point>& ring) {
  Patch patch = shapes::patch({.nx = 1, .ny = 1});  // for its sizes of 1
  std::vector<Point> points{centre};
  points.insert(points.end(), ring.begin(), ring.end());
  std::vector<NodeTag> tags(points.size(), {NodeKind::Fixed, CurveId(), 0, VertexId(std::size_t{0})});
  tags[0] = {};
  std::vector<Polygon> quads;
  for (std::size_t i = 0; i < 8; i += 2)
    quads.emplace_back(NodeId(std::size_t{0}), NodeId(i + 1), NodeId(i + 2), NodeId((i + 2) % 8 + 1));
  patch.mesh = WorkMesh();
  patch.mesh.build(points, tags, quads);
  for (std::size_t i = 0; i < quads.size(); ++i) patch.mesh.set_cell(FaceId(i), CellId(std::size_t{0}));
  return patch;
}

/// A ring of a square of edge 2, its nodes moved by up to `reach`.
Patch shaken_ring(std::uint64_t seed, double reach) {
  shapes::Noise noise(seed);
  std::vector<Point> ring{{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}};
  for (Point& p : ring) p += Point{reach * noise.next(), reach * noise.next()};
  const double x = noise.next();
  return ring_of({reach * x, reach * noise.next()}, ring);
}

Point centre(const Patch& patch) { return patch.mesh.point(NodeId(std::size_t{0})); }

template <class Step>
void run(Patch& patch, Step step, const SmoothOptions& options = {}) {
  const Context context;
  const SizeField size = patch.size();
  Stars stars(patch.mesh, patch.domain, size);
  step(stars, options, Progress(context));
  stars.store(patch.mesh);
}

double least_sine(const Patch& patch) {
  const SizeField size = patch.size();
  const Stars stars(patch.mesh, patch.domain, size);
  Star star;
  star.gather(stars, 0);
  const double sine2 = star.least_sine2({});
  return std::copysign(std::sqrt(std::fabs(sine2)), sine2);
}

double shape_value(const Patch& patch) {
  const SizeField size = patch.size();
  const Stars stars(patch.mesh, patch.domain, size);
  Star star;
  double sum = 0;
  for (std::size_t i = 0; i < stars.count(); ++i) {
    star.gather(stars, i);
    sum += ShapeEnergy<1>().value(star, {}, 0);
  }
  return sum;
}

double beta_mean(const Patch& patch) { return measure(flatten(patch.mesh, patch.domain)).beta_mean; }

std::vector<Point> points(const Patch& patch) {
  std::vector<Point> all;
  for (std::size_t i = 0; i < patch.mesh.topo().node_capacity(); ++i) all.push_back(patch.mesh.point(NodeId(i)));
  return all;
}

// A mesh in which every step finds something to do.
TEST(SmoothSteps, FollowEachOther) {
  const auto is_l_shaped = [](int i, int j) { return i < 4 || j < 4; };
  Patch patch = shapes::patch({.nx = 9, .ny = 9, .keep = is_l_shaped, .turned = {{1, 6}, {5, 1}}});
  shapes::shake(patch, 3, 0, 0.3);
  Patch whole = patch;
  Criteria criteria;
  criteria.min_jacobian_ratio = 0.7;
  const SmoothOptions options{.passes = 1, .criteria = criteria};
  const Context context;
  const SizeField size = patch.size();
  Stars stars(patch.mesh, patch.domain, size);
  for (const auto step : {laplacian, untangle, optimize, raise_least_sine, raise_beta, meet_criteria}) {
    const std::vector<Point> before = points(patch);
    step(stars, options, Progress(context));
    stars.store(patch.mesh);
    EXPECT_TRUE(points(patch) != before);
  }
  Context own;
  smooth(whole.mesh, whole.domain, whole.size(), options, own);
  EXPECT_TRUE(points(whole) == points(patch));
}

TEST(SmoothSteps, AMoveWakesAllThatShareAQuad) {
  const Patch patch = shapes::patch({.nx = 4, .ny = 4});
  const SizeField size = patch.size();
  Stars stars(patch.mesh, patch.domain, size);
  for (std::size_t i = 0; i < stars.count(); ++i)
    if (stars.at(i) == Point{2, 2}) stars.wake_around(i);
  EXPECT_EQ(stars.take_awake().size(), 9u);
  EXPECT_TRUE(stars.take_awake().empty());
}

TEST(Laplacian, GoesToTheMeanOfTheNeighbours) {
  Patch patch = ring_of({0.3, -0.2}, {{1, 0}, {1, 1}, {0, 1.2}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}});
  run(patch, laplacian);
  EXPECT_NEAR(centre(patch).x, 0, 1e-12);
  EXPECT_NEAR(centre(patch).y, 0.05, 1e-12);
}

// The ring has a dent, and the mean of the neighbours lies on its tip.
TEST(Laplacian, RefusesAMoveThatHarms) {
  Patch patch = ring_of({0.1, 0.1}, {{3, 0}, {0.5, 0.5}, {0, 3}, {-1, 2}, {-1, 0}, {-1, -1}, {0, -1}, {2, -1}});
  const double before = least_sine(patch);
  ASSERT_GT(before, 0.1);
  run(patch, laplacian);
  EXPECT_GE(least_sine(patch), before);
}

TEST(Laplacian, TakesHalfOfAMoveThatHarmsAsAWhole) {
  Patch patch = ring_of({-0.48, -0.48}, {{3, 0}, {0.5, 0.5}, {0, 3}, {-1, 2}, {-1, 0}, {-1, -1}, {0, -1}, {2, -1}});
  const double before = least_sine(patch);
  run(patch, laplacian, {.passes = 1});
  EXPECT_NEAR(centre(patch).x, 0.01, 1e-12);
  EXPECT_GT(least_sine(patch), before);
}

TEST(SmoothSteps, KeepTheLeastSineOrTheFloor) {
  Criteria criteria;
  criteria.min_jacobian_ratio = 0.95;
  criteria.max_aspect = 1.1;
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    const Patch start = shaken_ring(seed, 0.3);
    const double before = least_sine(start);
    if (before <= 0) continue;
    for (const auto step : {optimize, raise_least_sine, raise_beta, meet_criteria}) {
      Patch patch = start;
      run(patch, step, {.criteria = criteria});
      EXPECT_GE(least_sine(patch), std::fmin(before, 0.84) - 1e-9) << seed;
    }
  }
}

TEST(Optimize, ImprovesTheShape) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    Patch patch = shapes::patch({.nx = 8, .ny = 8, .turned = {{2, 2}, {5, 4}}});
    shapes::shake(patch, 0.25, seed);
    if (least_jacobian(patch.mesh) <= 0) continue;
    const double before = shape_value(patch);
    run(patch, optimize);
    EXPECT_LT(shape_value(patch), 0.97 * before) << seed;
  }
}

TEST(RaiseLeastSine, RaisesItWithoutMuchStretch) {
  int n_raised = 0;
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    Patch patch = shaken_ring(seed, 0.45);
    const double before = least_sine(patch), shape = shape_value(patch);
    if (before <= 0.1) continue;
    run(patch, raise_least_sine, {.passes = 1});
    n_raised += least_sine(patch) > before + 0.02;
    EXPECT_LE(shape_value(patch), 1.02 * shape + 1e-9) << seed;
  }
  EXPECT_GT(n_raised, 20);
}

TEST(RaiseBeta, RaisesIt) {
  Patch patch = shapes::patch({.nx = 10, .ny = 9, .turned = {{2, 2}, {6, 5}}});
  for (const auto step : {laplacian, optimize, raise_least_sine}) run(patch, step);
  const double before = beta_mean(patch);
  run(patch, raise_beta);
  EXPECT_GT(beta_mean(patch), before + 0.02);
}

}  // namespace
}  // namespace quadline::smoothing
