#include "stages/field_points/field_points.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "domain/arrange/arrange.hpp"
#include "stages/discretize/discretize.hpp"
#include "stages/field_points/insertion.hpp"
#include "stages/triangulate/triangulate.hpp"

namespace quadline {
namespace {

Path straight(std::vector<Point> points) {
  Path p;
  for (const Point q : points) p.items.push_back({q, {}});
  return p;
}

Model plate(double width, double height, double size) {
  Model m;
  m.size = size;
  m.outer = {straight({{0, 0}, {width, 0}, {width, height}, {0, height}})};
  return m;
}

/// A model up to the triangulation of its boundary.
struct Triangulated {
  explicit Triangulated(const Model& model)
      : domain(arrange(model, {}, context)),
        size(make_size_field(domain, {}, context)),
        mesh(discretize(domain, size, {}, {}, context)) {
    triangulate(mesh, domain, context);
  }
  void fill(Triangles how) { insert_field_points(mesh, size, how, context); }

  std::size_t n_constraints() const {
    std::size_t n = 0;
    for (std::size_t i = 0; i < mesh.topo().edge_capacity(); ++i)
      n += mesh.topo().is_live(EdgeId(i)) && mesh.is_constraint(EdgeId(i));
    return n;
  }
  double longest_edge_over_size() const {
    double longest = 0;
    for (std::size_t i = 0; i < mesh.topo().edge_capacity(); ++i) {
      if (!mesh.topo().is_live(EdgeId(i))) continue;
      const Point p = mesh.point(mesh.topo().tail(half_of(EdgeId(i))));
      longest = std::fmax(longest, mesh.edge_length(EdgeId(i)) / size.at(p));
    }
    return longest;
  }

  Context context;
  Domain domain;
  SizeField size;
  WorkMesh mesh;
};

class FieldPoints : public testing::TestWithParam<Triangles> {};

TEST_P(FieldPoints, FillAPlateAtTheAskedDistance) {
  Triangulated t(plate(12, 8, 1));
  t.fill(GetParam());
  EXPECT_EQ(defect(t.mesh), "");
  EXPECT_LT(t.longest_edge_over_size(), 2);
  EXPECT_GT(t.mesh.topo().node_count(), 90u);   // a grid has 117
  EXPECT_LT(t.mesh.topo().node_count(), 150u);  // equilateral triangles have about 130
}

TEST_P(FieldPoints, LeaveNothingOutside) {
  Model m = plate(10, 10, 1);
  m.holes = {straight({{4, 4}, {6, 4}, {6, 6}, {4, 6}})};
  Triangulated t(m);
  t.fill(GetParam());
  double area = 0;
  for (std::size_t i = 0; i < t.mesh.topo().face_capacity(); ++i) {
    ASSERT_TRUE(t.mesh.cell(FaceId(i)).valid());
    const Polygon p = t.mesh.topo().polygon(FaceId(i));
    area += 0.5 * twice_area(t.mesh.point(p.nodes[0]), t.mesh.point(p.nodes[1]), t.mesh.point(p.nodes[2]));
  }
  EXPECT_NEAR(area, 96, 1e-9);
}

TEST_P(FieldPoints, SplitNoConstraint) {
  Model m = plate(10, 6, 1);
  m.lines = {{"line", straight({{2, 3.2}, {8, 3.7}}), {}}};
  Triangulated t(m);
  const std::size_t before = t.n_constraints();
  t.fill(GetParam());
  EXPECT_EQ(t.n_constraints(), before);
  EXPECT_EQ(defect(t.mesh), "");
}

TEST_P(FieldPoints, FollowALocalSize) {
  Model m = plate(10, 10, 1);
  m.points = {{"fine", {5, 5}, 0.1, {}}};
  Triangulated t(m);
  t.fill(GetParam());
  EXPECT_LT(t.longest_edge_over_size(), 3);
  std::size_t near = 0;
  for (std::size_t i = 0; i < t.mesh.topo().node_capacity(); ++i)
    near += distance(t.mesh.point(NodeId(i)), {5, 5}) < 0.5;
  EXPECT_GT(near, 20u);
}

INSTANTIATE_TEST_SUITE_P(Both, FieldPoints, testing::Values(Triangles::Delaunay, Triangles::Front));

TEST(FieldPointsFront, StandOnTheGridWhereThereIsOne) {
  Triangulated t(plate(6, 4, 1));
  t.fill(Triangles::Front);
  EXPECT_EQ(t.mesh.topo().node_count(), 35u);
  for (std::size_t i = 0; i < t.mesh.topo().node_capacity(); ++i) {
    const Point p = t.mesh.point(NodeId(i));
    EXPECT_NEAR(p.x, std::round(p.x), 1e-9);
    EXPECT_NEAR(p.y, std::round(p.y), 1e-9);
  }
}

TEST(Insertion, DoesNotLookThroughALine) {
  Model m = plate(10, 6, 1);
  m.lines = {{"line", straight({{0, 3}, {10, 3}}), {}}};
  Triangulated t(m);
  const Insertion insertion(t.mesh, t.size);
  NodeId below;
  for (std::size_t i = 0; i < t.mesh.topo().node_capacity(); ++i)
    if (t.mesh.point(NodeId(i)) == Point{5, 0}) below = NodeId(i);
  ASSERT_TRUE(below.valid());
  EXPECT_TRUE(insertion.walk(below, {5.2, 2}).valid());
  EXPECT_FALSE(insertion.walk(below, {5.2, 4}).valid());
}

TEST(Insertion, RefusesWhatComesTooNear) {
  Triangulated t(plate(10, 6, 1));
  Insertion insertion(t.mesh, t.size);
  NodeId below;
  for (std::size_t i = 0; i < t.mesh.topo().node_capacity(); ++i)
    if (t.mesh.point(NodeId(i)) == Point{5, 0}) below = NodeId(i);
  ASSERT_TRUE(below.valid());
  const Spacing spacing{0.7, 0.5, false};
  EXPECT_FALSE(insertion.try_insert({5, 0.3}, insertion.walk(below, {5, 0.3}), spacing, {}).valid());
  EXPECT_TRUE(insertion.try_insert({5, 1}, insertion.walk(below, {5, 1}), spacing, {}).valid());
  EXPECT_FALSE(insertion.try_insert({5.3, 1.2}, insertion.walk(below, {5.3, 1.2}), spacing, {}).valid());
}

}  // namespace
}  // namespace quadline
