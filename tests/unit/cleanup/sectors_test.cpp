#include "stages/cleanup/sectors.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "quad_shapes.hpp"

namespace quadline::cleanup {
namespace {

Sector sector_of(const WorkMesh& mesh, std::size_t v, std::size_t towards) {
  return Sectors(mesh).at(mesh.topo().find(NodeId(v), NodeId(towards)));
}

// A fan of quads over the angle round the origin: node 0, spokes 1, 3, 5, ..., far corners 2, 4, ...
WorkMesh wedge(double degrees, int n_quads) {
  std::vector<Point> points{{0, 0}};
  shapes::QuadList quads;
  for (int i = 0; i <= 2 * n_quads; ++i) {
    const double a = degrees * std::numbers::pi / 180 * i / (2 * n_quads), r = i % 2 == 0 ? 1 : 1.5;
    points.push_back({r * std::cos(a), r * std::sin(a)});
  }
  for (int i = 0; i < n_quads; ++i) {
    const auto k = static_cast<std::uint32_t>(2 * i + 1);
    quads.push_back({0, k, k + 1, k + 2});
  }
  return shapes::quad_mesh(points, quads);
}

TEST(Sectors, OfInnerNodesWantFourQuads) {
  const WorkMesh mesh = shapes::grid(3, 3);
  const Sector s = sector_of(mesh, 5, 6);
  EXPECT_EQ(s.quads, 4);
  EXPECT_EQ(s.ideal.ideal, 4);
  EXPECT_FALSE(s.ideal.on_curve);
  EXPECT_EQ(Sectors(mesh).cost(NodeId(5)), 0);
}

TEST(Sectors, OfCurvesFollowTheAngle) {
  const struct {
    double degrees;
    int ideal, second, least;
  } rows[] = {{40, 1, 0, 1},  {90, 1, 0, 1},  {120, 1, 2, 1}, {130, 2, 1, 1}, {150, 2, 0, 1},
              {180, 2, 0, 2}, {215, 2, 3, 2}, {225, 3, 2, 2}, {270, 3, 0, 2}, {320, 4, 0, 2}};
  for (const auto& row : rows) {
    const IdealValence ideal = sector_of(wedge(row.degrees, 2), 0, 1).ideal;
    EXPECT_EQ(ideal.ideal, row.ideal) << row.degrees;
    EXPECT_EQ(ideal.second, row.second) << row.degrees;
    EXPECT_EQ(ideal.least, row.least) << row.degrees;
    EXPECT_TRUE(ideal.on_curve);
  }
}

TEST(Sectors, AtTheEndOfALineWantFourQuads) {
  const WorkMesh mesh = shapes::grid(4, 4, 1, {{11, 12}});
  const Sector end = sector_of(mesh, 12, 13);
  EXPECT_EQ(end.quads, 4);
  EXPECT_EQ(end.ideal.ideal, 4);
  EXPECT_TRUE(end.ideal.on_curve);
}

TEST(Sectors, OnALineAreTwo) {
  const WorkMesh mesh = shapes::grid(4, 4, 1, {{11, 12}, {12, 13}});
  for (const std::size_t towards : {7, 17}) {
    const Sector side = sector_of(mesh, 12, towards);
    EXPECT_EQ(side.quads, 2);
    EXPECT_EQ(side.ideal.ideal, 2);
  }
  EXPECT_EQ(Sectors(mesh).cost(NodeId(12)), 0);
}

TEST(ValenceCost, GrowsWithTheDifference) {
  const IdealValence inner;
  EXPECT_EQ(valence_cost(inner, 4), 0);
  EXPECT_EQ(valence_cost(inner, 5), valence_cost(inner, 3));
  EXPECT_GT(valence_cost(inner, 6), 2 * valence_cost(inner, 5));
  EXPECT_GT(valence_cost(inner, 2), 2 * valence_cost(inner, 3));
  EXPECT_GT(valence_cost(inner, 7), valence_cost(inner, 6));
}

TEST(ValenceCost, OfAFlatSectorTopsEverything) {
  const IdealValence flat = sector_of(wedge(180, 2), 0, 1).ideal;
  EXPECT_EQ(valence_cost(flat, 1), kBroken);
  EXPECT_EQ(valence_cost(flat, 2), 0);
  EXPECT_GT(valence_cost(flat, 3), 0);
  EXPECT_LT(valence_cost(flat, 3), 10);
}

TEST(ValenceCost, TakesBothNumbersWhereTheyAreEquallyGood) {
  const IdealValence octagon = sector_of(wedge(225, 3), 0, 1).ideal;
  EXPECT_EQ(valence_cost(octagon, 3), 0);
  EXPECT_EQ(valence_cost(octagon, 2), 0);
  const IdealValence near = sector_of(wedge(220, 3), 0, 1).ideal;
  EXPECT_EQ(valence_cost(near, 2), 1);
}

}  // namespace
}  // namespace quadline::cleanup
