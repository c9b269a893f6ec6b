// Options::size_at through the whole pipeline.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "quadline/inspect.hpp"

namespace quadline {
namespace {

Model plate() {
  Model model;
  model.size = 1;
  model.outer = {{.items = {{{0, 0}}, {{12, 0}}, {{12, 4}}, {{0, 4}}}}};
  return model;
}

MeshResult mesh_of(const Options& options) {
  Context context;
  return generate(plate(), options, context);
}

/// Median of edge length over `size` at the edge's middle.
double median_ratio(const Mesh& mesh, const std::function<double(Point)>& size) {
  std::vector<double> ratios;
  for (const auto& [a, b] : edges_of(mesh)) {
    const Point p = mesh.points[a], q = mesh.points[b];
    ratios.push_back(distance(p, q) / size(midpoint(p, q)));
  }
  std::sort(ratios.begin(), ratios.end());
  return ratios[ratios.size() / 2];
}

TEST(SizeAt, EdgesOfAGradedPlateAreNearIt) {
  const auto size = [](Point p) { return 0.1 + 0.07 * p.x; };
  const MeshResult result = mesh_of({.size_at = size});
  ASSERT_FALSE(result.failure) << result.failure->reason;
  EXPECT_NEAR(median_ratio(result.mesh, size), 1, 0.15);
  // In each third by itself, so that a mesh of one size fails.
  for (const double x : {0.0, 4.0, 8.0}) {
    double sum = 0, n = 0;
    for (const auto& [a, b] : edges_of(result.mesh)) {
      const Point p = result.mesh.points[a], q = result.mesh.points[b], m = midpoint(p, q);
      if (m.x < x || m.x > x + 4) continue;
      sum += distance(p, q) / size(m);
      ++n;
    }
    EXPECT_NEAR(sum / n, 1, 0.2) << x;
  }
  const auto edges = edges_of(result.mesh);
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const Point m = midpoint(result.mesh.points[edges[i][0]], result.mesh.points[edges[i][1]]);
    EXPECT_NEAR(result.edge_sizes[i], size(m), 0.08 * size(m));
  }
}

TEST(SizeAt, TheLeastOfItAndTheModelHolds) {
  const MeshResult plain = mesh_of({}), large = mesh_of({.size_at = [](Point) { return 5.0; }});
  EXPECT_EQ(large.mesh.quads, plain.mesh.quads);
  for (std::size_t i = 0; i < plain.mesh.points.size(); ++i)  // only the plain one is made symmetric
    EXPECT_LT(distance(large.mesh.points[i], plain.mesh.points[i]), 1e-12);
}

TEST(SizeAt, JumpsAreGraded) {
  Options options{.size_at = [](Point p) { return p.x < 6 ? 0.2 : 1.0; }};
  const MeshResult result = mesh_of(options);
  ASSERT_FALSE(result.failure);
  const auto edges = edges_of(result.mesh);
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const Point m = midpoint(result.mesh.points[edges[i][0]], result.mesh.points[edges[i][1]]);
    const double graded = m.x < 6 ? 0.2 : std::min(1.0, 0.2 + std::log(1.3) * (m.x - 6));
    EXPECT_NEAR(result.edge_sizes[i], graded, 0.1 * graded + 0.02) << m.x;
  }
}

TEST(SizeAt, ASmallSpotIsSeen) {
  // A dip a fortieth of the plate wide, between the places that a coarse tree would look at.
  const auto size = [](Point p) { return distance(p, {7.31, 1.57}) < 0.15 ? 0.03 : 1.0; };
  const MeshResult result = mesh_of({.size_at = size});
  ASSERT_FALSE(result.failure);
  EXPECT_LT(*std::min_element(result.edge_sizes.begin(), result.edge_sizes.end()), 0.06);
}

TEST(SizeAt, TheMeshDoesNotDependOnTheOrderOfJobs) {
  const Options options{.size_at = [](Point p) { return 0.2 + 0.05 * std::abs(p.y - 2); }};
  Context backwards;
  backwards.run_all = [](std::size_t n, const std::function<void(std::size_t)>& job) {
    while (n > 0) job(--n);
  };
  const Mesh a = mesh_of(options).mesh, b = generate(plate(), options, backwards).mesh;
  EXPECT_EQ(a.points, b.points);
  EXPECT_EQ(a.quads, b.quads);
}

TEST(SizeAt, WhatIsNoLengthIsRefusedWithThePlace) {
  const double nan = std::nan(""), infinity = std::numeric_limits<double>::infinity();
  for (const double bad : {nan, 0.0, -1.0, infinity, -infinity, 1e-12}) {
    try {
      mesh_of({.size_at = [bad](Point p) { return p.x > 7 ? bad : 0.5; }});
      FAIL() << bad;
    } catch (const InputError& error) {
      EXPECT_EQ(error.code(), ErrorCode::InvalidOption);
      EXPECT_NE(std::string(error.what()).find("Options::size_at gives "), std::string::npos) << error.what();
      ASSERT_TRUE(error.where().point);
      EXPECT_GT(error.where().point->x, 7);
      EXPECT_LE(error.where().point->x, 12);
    }
  }
}

TEST(SizeAt, NoiseIsRefused) {
  // As wild from place to place as a number can be: a hash of the bits of the place.
  const auto noise = [](Point p) {
    const double wild = std::fmod(std::abs(std::sin(p.x * 12.9898e3 + p.y * 78.233e3)) * 43758.5453, 1.0);
    return 0.0005 + 0.5 * wild * wild * wild * wild;
  };
  try {
    mesh_of({.size_at = noise});
    FAIL() << "a mesh was made";
  } catch (const InputError& error) {
    EXPECT_EQ(error.code(), ErrorCode::InvalidOption);
    EXPECT_NE(std::string(error.what()).find("jumps from place to place"), std::string::npos) << error.what();
    EXPECT_TRUE(error.where().point);
  }
}

TEST(SizeAt, MoreThanTheMostQuadsIsRefusedBeforeTheyAreMade) {
  for (const double size : {0.001, 0.0003}) {
    try {
      mesh_of({.size_at = [size](Point) { return size; }, .max_quads = 1e6});
      FAIL() << size;
    } catch (const InputError& error) {
      EXPECT_EQ(error.code(), ErrorCode::TooManyQuads) << error.what();
    }
  }
}

}  // namespace
}  // namespace quadline
