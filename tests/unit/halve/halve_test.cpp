#include "stages/halve/halve.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <utility>

#include "domain/arrange/arrange.hpp"
#include "domain/size/size_field.hpp"
#include "stages/discretize/discretize.hpp"
#include "stages/field_points/field_points.hpp"
#include "stages/triangulate/triangulate.hpp"
#include "unit/grid_patch.hpp"
#include "unit/qmorph/shapes.hpp"

namespace quadline {
namespace {

// A cell with one straight curve, for meshes by hand.
Domain one_curve(Point a, Point b) {
  Domain domain;
  Domain::Curve curve;
  curve.piece.a = a;
  curve.piece.b = b;
  domain.curves.push_back(curve);
  return domain;
}

WorkMesh halved(WorkMesh mesh, const Domain& domain) {
  Context context;
  halve(mesh, domain, context);
  EXPECT_EQ(defect(mesh), "");
  EXPECT_EQ(shapes::n_triangles(mesh), 0u);
  return mesh;
}

double least_jacobian(const WorkMesh& mesh) {
  double least = 1;
  for (std::size_t i = 0; i < mesh.topo().face_capacity(); ++i)
    least = std::min(least, scaled_jacobian(mesh.quad_points(FaceId(i))));
  return least;
}

TEST(Halve, TriangleBecomesThreeAndQuadFour) {
  const WorkMesh mesh = halved(shapes::mesh_of({{0, 0}, {2, 0}, {2, 2}, {0, 2}, {3, 1}}, {{0, 1, 2, 3}, {1, 4, 2}}, {}),
                               one_curve({0, 0}, {1, 0}));
  EXPECT_EQ(mesh.topo().face_count(), 7u);
  EXPECT_EQ(mesh.topo().node_count(), 5u + 6 + 2);
  EXPECT_GT(least_jacobian(mesh), 0.5);
}

TEST(Halve, NeedleGivesConvexQuads) {
  const WorkMesh mesh =
      halved(shapes::mesh_of({{0, 0}, {1, 0}, {2, 1e-5}}, {{0, 1, 2}}, {}), one_curve({0, 0}, {1, 0}));
  EXPECT_EQ(mesh.topo().face_count(), 3u);
  EXPECT_GT(least_jacobian(mesh), 0);
}

TEST(Halve, ReflexQuadIsCutFirst) {
  const WorkMesh mesh =
      halved(shapes::mesh_of({{0, 0}, {2, 1}, {0, 2}, {0.5, 1}}, {{0, 1, 2, 3}}, {}), one_curve({0, 0}, {1, 0}));
  EXPECT_EQ(mesh.topo().face_count(), 6u);
  EXPECT_GT(least_jacobian(mesh), 0);
}

// Below the tangent of an arc, from the point where they touch: the arc's middle, the mean of all and the far end of
// the arc's edge would lie in line.
TEST(Halve, WedgeBetweenAnArcAndItsTangentGivesConvexQuads) {
  const Point touch{0, 0}, on_arc{0.4, -0.2}, on_tangent{0.4, 0}, centre{0, -0.5};
  Domain domain = one_curve(on_arc, touch);
  CurvePiece& arc = domain.curves[CurveId(0)].piece;
  arc.center = centre;
  arc.radius = 0.5;
  arc.sweep = std::atan2(cross(on_arc - centre, touch - centre), dot(on_arc - centre, touch - centre));
  const WorkMesh mesh = halved(shapes::mesh_of({touch, on_arc, on_tangent}, {{0, 1, 2}}, {{1, 0}}), domain);
  EXPECT_EQ(mesh.topo().face_count(), 3u);
  EXPECT_GT(least_jacobian(mesh), 0.01);
}

TEST(Halve, ConstraintsHaveTwiceTheEdges) {
  const shapes::Patch patch = shapes::patch({.nx = 4, .ny = 3, .lines = {{{{1, 1}, {3, 1}}}}});
  const WorkMesh mesh = halved(patch.mesh, patch.domain);
  EXPECT_EQ(mesh.topo().face_count(), 48u);
  EXPECT_EQ(shapes::n_constraints(mesh), 2 * shapes::n_constraints(patch.mesh));
  EXPECT_EQ(mesh.segments().size(), shapes::n_constraints(mesh));
  for (const Segment& s : mesh.segments()) EXPECT_EQ(mesh.curve(edge_of(mesh.topo().find(s.a, s.b))), s.curve);
  EXPECT_EQ(least_jacobian(mesh), 1);
}

TEST(Halve, MiddlesOfArcsLieOnThem) {
  Model model;
  model.size = 0.5;
  model.outer.push_back({.circle = Circle{{0, 0}, 1}});
  Context context;
  const Domain domain = arrange(model, {}, context);
  const SizeField size = make_size_field(domain, {}, context);
  CellSet all;
  all.insert(CellId(0));
  const WorkMesh nodes = discretize(domain, size, {}, all, context);
  WorkMesh mesh = nodes, halved_nodes = nodes;
  triangulate(mesh, domain, context);
  insert_field_points(mesh, size.scaled(2), Triangles::Front, context);
  mesh = halved(std::move(mesh), domain);
  EXPECT_GT(least_jacobian(mesh), 0.2);
  std::size_t n_on_curve = 0;
  for (std::size_t i = 0; i < mesh.topo().node_capacity(); ++i) {
    const NodeTag& tag = mesh.tag(NodeId(i));
    if (tag.kind != NodeKind::OnCurve) continue;
    ++n_on_curve;
    EXPECT_NEAR(norm(mesh.point(NodeId(i))), 1, 1e-12);
    EXPECT_NEAR(distance(mesh.point(NodeId(i)), point_at(domain.curves[tag.curve].piece, tag.s)), 0, 1e-12);
  }
  EXPECT_GE(n_on_curve, 8u);

  // The segments alone, halved, have the same nodes.
  halve_segments(halved_nodes, domain, curves_round(domain, all));
  ASSERT_EQ(halved_nodes.segments().size(), 2 * nodes.segments().size());
  std::set<std::pair<CurveId, double>> places;
  for (const Segment& s : mesh.segments()) places.insert({s.curve, mesh.tag(s.b).s});
  for (const Segment& s : halved_nodes.segments())
    EXPECT_TRUE(places.count({s.curve, halved_nodes.tag(s.b).s})) << halved_nodes.tag(s.b).s;
}

TEST(HalveSegments, LeavesTheOtherCurves) {
  const shapes::Patch patch = shapes::patch({.nx = 4, .ny = 3});
  WorkMesh nodes = patch.mesh;
  nodes.set_segments(
      {{patch.node(0, 0), patch.node(4, 0), CurveId(0)}, {patch.node(4, 0), patch.node(4, 3), CurveId(1)}});
  halve_segments(nodes, patch.domain, {CurveId(1)});
  ASSERT_EQ(nodes.segments().size(), 3u);
  EXPECT_EQ(nodes.segments()[0].b, patch.node(4, 0));
  EXPECT_EQ(nodes.segments()[1].b, nodes.segments()[2].a);
  EXPECT_EQ(nodes.tag(nodes.segments()[1].b).curve, CurveId(1));
}

TEST(Halve, StopsWhenAsked) {
  WorkMesh mesh = shapes::triangulated_grid(2, 2);
  Context context;
  context.is_cancelled = [] { return true; };
  EXPECT_THROW(halve(mesh, one_curve({0, 0}, {1, 0}), context), Cancelled);
}

}  // namespace
}  // namespace quadline
