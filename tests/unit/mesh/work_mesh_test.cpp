#include "mesh/work_mesh.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "quadline/errors.hpp"

namespace quadline {
namespace {

constexpr double kPi = std::numbers::pi;

NodeId n(std::size_t i) { return NodeId(i); }

WorkMesh made_of(std::vector<Point> points, const std::vector<Polygon>& polygons) {
  WorkMesh mesh;
  std::vector<NodeTag> tags(points.size());
  mesh.build(std::move(points), std::move(tags), polygons);
  for (std::size_t i = 0; i < mesh.topo().face_capacity(); ++i) mesh.set_cell(FaceId(i), CellId(7));
  return mesh;
}

EdgeId edge(const WorkMesh& mesh, std::size_t a, std::size_t b) { return edge_of(mesh.topo().find(n(a), n(b))); }
FaceId face(const WorkMesh& mesh, std::size_t a, std::size_t b) {
  return mesh.topo().face(mesh.topo().find(n(a), n(b)));
}

// Unit square 0 1 2 3 with the diagonal 0-2; its rim is curve 0 .. 3.
WorkMesh diamond() {
  WorkMesh mesh = made_of({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, {{n(0), n(1), n(2)}, {n(0), n(2), n(3)}});
  for (std::size_t i = 0; i < 4; ++i) mesh.set_curve(edge(mesh, i, (i + 1) % 4), CurveId(i));
  return mesh;
}

WorkMesh tagged_diamond() {
  WorkMesh mesh;
  std::vector<NodeTag> tags(4);
  for (std::size_t i = 0; i < 4; ++i) {
    tags[i].kind = NodeKind::Fixed;
    tags[i].vertex = VertexId(i);
  }
  const std::vector<Polygon> polygons{{n(0), n(1), n(2)}, {n(0), n(2), n(3)}};
  mesh.build({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, tags, polygons);
  for (std::size_t i = 0; i < 2; ++i) mesh.set_cell(FaceId(i), CellId(7));
  for (std::size_t i = 0; i < 4; ++i) mesh.set_curve(edge(mesh, i, (i + 1) % 4), CurveId(i));
  return mesh;
}

// nx x ny unit squares over the nodes (nx + 1) j + i; the rim is a constraint.
WorkMesh grid(std::size_t nx, std::size_t ny) {
  std::vector<Point> points;
  std::vector<Polygon> quads;
  std::vector<NodeTag> tags;
  for (std::size_t j = 0; j <= ny; ++j) {
    for (std::size_t i = 0; i <= nx; ++i) {
      points.push_back({double(i), double(j)});
      NodeTag tag;
      if (i == 0 || j == 0 || i == nx || j == ny) tag.kind = NodeKind::OnCurve;
      tags.push_back(tag);
    }
  }
  for (std::size_t j = 0; j < ny; ++j) {
    for (std::size_t i = 0; i < nx; ++i) {
      const std::size_t a = j * (nx + 1) + i;
      quads.push_back({n(a), n(a + 1), n(a + nx + 2), n(a + nx + 1)});
    }
  }
  WorkMesh mesh;
  mesh.build(points, tags, quads);
  for (std::size_t i = 0; i < mesh.topo().face_capacity(); ++i) mesh.set_cell(FaceId(i), CellId(7));
  for (std::size_t i = 0; i < mesh.topo().edge_capacity(); ++i)
    if (mesh.is_boundary(EdgeId(i))) mesh.set_curve(EdgeId(i), CurveId(0));
  return mesh;
}

double area(const WorkMesh& mesh) {
  double sum = 0;
  for (std::size_t i = 0; i < mesh.topo().face_capacity(); ++i) {
    if (!mesh.topo().is_live(FaceId(i))) continue;
    const Polygon p = mesh.topo().polygon(FaceId(i));
    for (int k = 1; k + 1 < p.n; ++k)
      sum += 0.5 * twice_area(mesh.point(p.nodes[0]), mesh.point(p.nodes[k]), mesh.point(p.nodes[k + 1]));
  }
  return sum;
}

std::vector<double> sector_angles(const WorkMesh& mesh, NodeId v) {
  std::vector<double> angles;
  mesh.for_each_sector(v, [&](HalfId, HalfId, Angle angle) { angles.push_back(radians(angle)); });
  std::sort(angles.begin(), angles.end());
  return angles;
}

TEST(WorkMeshBuild, StartsWithoutConstraintsAndCells) {
  WorkMesh mesh;
  const std::vector<Polygon> polygons{{n(0), n(1), n(2)}};
  mesh.build({{0, 0}, {1, 0}, {0, 1}}, std::vector<NodeTag>(3), polygons);
  EXPECT_EQ(defect(mesh), "");
  for (std::size_t i = 0; i < 3; ++i) EXPECT_FALSE(mesh.is_constraint(EdgeId(i)));
  EXPECT_TRUE(mesh.is_outside(mesh.topo().find(n(0), n(1))));  // a face of no cell
  EXPECT_TRUE(mesh.is_free(n(0)));
}

TEST(WorkMeshSwap, TurnsTheDiagonalOfAConvexQuad) {
  WorkMesh mesh = diamond();
  const EdgeId e = edge(mesh, 0, 2);
  ASSERT_EQ(mesh.can_swap(e), Refusal::None);
  mesh.swap_edge(e);
  EXPECT_EQ(mesh.topo().defect(), nullptr);
  EXPECT_EQ(edge(mesh, 1, 3), e);
  EXPECT_FALSE(mesh.is_constraint(e));
  EXPECT_DOUBLE_EQ(area(mesh), 1);
}

TEST(WorkMeshGate, EditsDoNotReachAcrossConstraintsAndTheBoundary) {
  WorkMesh mesh = diamond();
  const auto half = [&](std::size_t a, std::size_t b) { return mesh.topo().find(n(a), n(b)); };
  EXPECT_EQ(mesh.can_cross(half(0, 2)), Refusal::None);
  EXPECT_EQ(mesh.can_cross(half(2, 0)), Refusal::None);
  EXPECT_EQ(mesh.can_cross(half(0, 1)), Refusal::OnConstraint);
  mesh.set_curve(edge(mesh, 0, 1), CurveId());
  EXPECT_EQ(mesh.can_cross(half(0, 1)), Refusal::OnBoundary);
  EXPECT_EQ(mesh.can_cross(half(1, 0)), Refusal::None);  // from outside
  mesh.set_curve(edge(mesh, 0, 2), CurveId(5));
  EXPECT_EQ(mesh.can_cross(half(0, 2)), Refusal::OnConstraint);
}

TEST(WorkMeshGate, TwoTrianglesWithoutAConstraintBetweenThemMayMerge) {
  WorkMesh mesh = diamond();
  EXPECT_EQ(mesh.can_merge(edge(mesh, 0, 2)), Refusal::None);
  EXPECT_EQ(mesh.can_merge(edge(mesh, 0, 1)), Refusal::OnConstraint);
  mesh.set_curve(edge(mesh, 0, 1), CurveId());
  EXPECT_EQ(mesh.can_merge(edge(mesh, 0, 1)), Refusal::OnBoundary);
  mesh.set_curve(edge(mesh, 0, 2), CurveId(5));
  EXPECT_EQ(mesh.can_merge(edge(mesh, 0, 2)), Refusal::OnConstraint);
  const WorkMesh quads = grid(2, 1);
  EXPECT_EQ(quads.can_merge(edge(quads, 1, 4)), Refusal::NotTriangles);
}

TEST(WorkMeshGate, AFrozenFaceIsHeldUntilTheThaw) {
  WorkMesh mesh = grid(3, 3);
  const FaceId held = face(mesh, 5, 6), beside = face(mesh, 6, 7);
  const EdgeId between = edge(mesh, 6, 10);
  EXPECT_EQ(mesh.can_replace(held), Refusal::None);
  mesh.freeze(held);
  EXPECT_EQ(mesh.can_replace(held), Refusal::OnConstraint);
  EXPECT_EQ(mesh.can_replace(beside), Refusal::None);
  EXPECT_TRUE(mesh.is_constraint(between));
  EXPECT_FALSE(mesh.curve(between).valid());  // of no curve
  EXPECT_EQ(mesh.can_cross(mesh.topo().find(n(6), n(10))), Refusal::OnConstraint);
  EXPECT_FALSE(mesh.is_free(n(6)));
  mesh.thaw();
  EXPECT_EQ(mesh.can_replace(held), Refusal::None);
  EXPECT_FALSE(mesh.is_constraint(between));
  EXPECT_TRUE(mesh.is_constraint(edge(mesh, 0, 1)));  // that of a curve stays one
  EXPECT_TRUE(mesh.is_free(n(6)));
}

TEST(WorkMeshGate, AFaceBetweenCurvesAloneIsNotFrozen) {
  WorkMesh mesh = grid(1, 1);
  EXPECT_TRUE(mesh.is_constraint(EdgeId(0)));
  EXPECT_FALSE(mesh.is_frozen(FaceId(0)));
  EXPECT_EQ(mesh.can_replace(FaceId(0)), Refusal::None);
}

TEST(WorkMeshSwap, SaysWhyNot) {
  WorkMesh mesh = diamond();
  EXPECT_EQ(mesh.can_swap(edge(mesh, 0, 1)), Refusal::OnConstraint);
  mesh.set_curve(edge(mesh, 0, 1), CurveId());
  EXPECT_EQ(mesh.can_swap(edge(mesh, 0, 1)), Refusal::OnBoundary);
  mesh.set_curve(edge(mesh, 0, 2), CurveId(5));
  EXPECT_EQ(mesh.can_swap(edge(mesh, 0, 2)), Refusal::OnConstraint);

  const WorkMesh quads = grid(2, 1);
  EXPECT_EQ(quads.can_swap(edge(quads, 1, 4)), Refusal::NotTriangles);
}

TEST(WorkMeshSwap, RefusesAQuadThatIsNotStrictlyConvex) {
  WorkMesh mesh = diamond();
  mesh.move(n(3), {-1, 0});  // the corner at 0 is flat
  EXPECT_EQ(mesh.can_swap(edge(mesh, 0, 2)), Refusal::WouldInvert);
  mesh.move(n(3), {-1, -1e-15});
  EXPECT_EQ(mesh.can_swap(edge(mesh, 0, 2)), Refusal::WouldInvert);
  mesh.move(n(3), {-1, 1e-15});
  EXPECT_EQ(mesh.can_swap(edge(mesh, 0, 2)), Refusal::None);
}

TEST(WorkMeshSplitFace, KeepsTheCellAndTheConstraints) {
  WorkMesh mesh = tagged_diamond();
  const NodeId v = mesh.split_face(face(mesh, 0, 1), {0.6, 0.3});
  EXPECT_EQ(defect(mesh), "");
  EXPECT_TRUE(mesh.is_free(v));
  EXPECT_EQ(mesh.topo().face_count(), 4u);
  for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(mesh.cell(FaceId(i)), CellId(7));
  mesh.topo().for_each_out(v, [&](HalfId h) { EXPECT_FALSE(mesh.is_constraint(h)); });
  EXPECT_EQ(mesh.curve(edge(mesh, 0, 1)), CurveId(0));
  EXPECT_DOUBLE_EQ(area(mesh), 1);
}

TEST(WorkMeshSplitEdge, CutsTheDiagonal) {
  WorkMesh mesh = tagged_diamond();
  const NodeId v = mesh.split_edge(edge(mesh, 0, 2), {0.5, 0.5});
  EXPECT_EQ(defect(mesh), "");
  EXPECT_EQ(mesh.topo().edge_valence(v), 4);
  mesh.topo().for_each_out(v, [&](HalfId h) {
    EXPECT_FALSE(mesh.is_constraint(h));
    EXPECT_EQ(mesh.cell(mesh.topo().face(h)), CellId(7));
  });
  EXPECT_DOUBLE_EQ(area(mesh), 1);
}

TEST(WorkMeshSplitEdge, PassesTheCurveOnAtTheBoundary) {
  WorkMesh mesh = tagged_diamond();
  NodeTag tag;
  tag.kind = NodeKind::OnCurve;
  tag.curve = CurveId(1);
  tag.s = 0.5;
  const NodeId v = mesh.split_edge(edge(mesh, 1, 2), {1, 0.5}, tag);
  EXPECT_EQ(defect(mesh), "");
  EXPECT_EQ(mesh.curve(edge_of(mesh.topo().find(n(1), v))), CurveId(1));
  EXPECT_EQ(mesh.curve(edge_of(mesh.topo().find(v, n(2)))), CurveId(1));
  EXPECT_FALSE(mesh.is_constraint(mesh.topo().find(n(0), v)));
  EXPECT_EQ(mesh.tag(v).s, 0.5);
  EXPECT_EQ(mesh.topo().face_count(), 3u);
  EXPECT_EQ(mesh.cell(mesh.topo().face(mesh.topo().find(n(0), v))), CellId(7));
  EXPECT_EQ(mesh.cell(mesh.topo().face(mesh.topo().find(v, n(0)))), CellId(7));
}

TEST(WorkMeshSplitEdge, KeepsTheCellsOfBothSidesOfALine) {
  WorkMesh mesh = tagged_diamond();
  mesh.set_cell(face(mesh, 2, 3), CellId(9));
  mesh.set_curve(edge(mesh, 0, 2), CurveId(4));
  NodeTag tag;
  tag.kind = NodeKind::OnCurve;
  const NodeId v = mesh.split_edge(edge(mesh, 0, 2), {0.5, 0.5}, tag);
  EXPECT_EQ(defect(mesh), "");
  EXPECT_EQ(mesh.cell(face(mesh, 0, 1)), CellId(7));
  EXPECT_EQ(mesh.cell(face(mesh, 1, 2)), CellId(7));
  EXPECT_EQ(mesh.cell(face(mesh, 2, 3)), CellId(9));
  EXPECT_EQ(mesh.cell(face(mesh, 3, 0)), CellId(9));
  int n_constraints = 0;
  mesh.topo().for_each_out(v, [&](HalfId h) { n_constraints += mesh.is_constraint(h); });
  EXPECT_EQ(n_constraints, 2);
}

TEST(WorkMeshReplaceCavity, GivesNewEdgesNoCurveAndNewFacesTheCell) {
  WorkMesh mesh = grid(3, 3);
  std::vector<FaceId> made;
  const std::vector<FaceId> cavity{face(mesh, 0, 1), face(mesh, 1, 2)};
  mesh.replace_cavity(cavity, std::vector<Polygon>{{n(0), n(1), n(2), n(4)}, {n(4), n(2), n(6), n(5)}}, made);
  EXPECT_EQ(mesh.topo().defect(), nullptr);
  ASSERT_EQ(made.size(), 2u);
  for (const FaceId f : made) EXPECT_EQ(mesh.cell(f), CellId(7));
  EXPECT_FALSE(mesh.is_constraint(edge(mesh, 2, 4)));
  EXPECT_TRUE(mesh.is_constraint(edge(mesh, 0, 1)));
  EXPECT_TRUE(mesh.is_constraint(edge(mesh, 0, 4)));
  EXPECT_DOUBLE_EQ(area(mesh), 9);
}

TEST(WorkMeshReplaceCavity, ReusesASlotOfAConstraintWithoutItsCurve) {
  WorkMesh mesh = grid(3, 3);
  mesh.set_curve(edge(mesh, 5, 6), CurveId(3));
  mesh.set_curve(edge(mesh, 5, 6), CurveId());
  std::vector<FaceId> made;
  const std::vector<FaceId> cavity{face(mesh, 4, 5), face(mesh, 5, 6)};
  mesh.replace_cavity(cavity, std::vector<Polygon>{{n(4), n(5), n(6), n(8)}, {n(8), n(6), n(10), n(9)}}, made);
  EXPECT_EQ(mesh.topo().defect(), nullptr);
  EXPECT_FALSE(mesh.is_constraint(edge(mesh, 6, 8)));
}

TEST(WorkMeshReplaceCavity, KeepsTheConstraintThatItGoesRound) {
  WorkMesh mesh = grid(3, 3);
  mesh.set_curve(edge(mesh, 5, 6), CurveId(3));  // with both sides in the cavity
  std::vector<FaceId> made;
  const std::vector<FaceId> cavity{face(mesh, 5, 6), face(mesh, 6, 5)};
  mesh.replace_cavity(cavity, std::vector<Polygon>{{n(1), n(2), n(6), n(5)}, {n(5), n(6), n(10), n(9)}}, made);
  EXPECT_EQ(mesh.topo().defect(), nullptr);
  EXPECT_EQ(mesh.curve(edge(mesh, 5, 6)), CurveId(3));
}

TEST(WorkMeshReplaceCavity, LosesNoConstraint) {
  WorkMesh mesh = grid(3, 3);
  mesh.set_curve(edge(mesh, 5, 6), CurveId(3));
  std::vector<FaceId> made;
  const std::vector<FaceId> cavity{face(mesh, 5, 6), face(mesh, 6, 5)};
  const std::vector<Polygon> across{{n(1), n(2), n(6), n(10)}, {n(1), n(10), n(9), n(5)}};
  EXPECT_THROW(mesh.replace_cavity(cavity, across, made), InternalError);
}

TEST(WorkMeshDropOutside, TakesFacesOfNoCellAndTheirNodes) {
  WorkMesh mesh = grid(3, 3);
  mesh.set_cell(face(mesh, 0, 1), CellId());
  mesh.set_cell(face(mesh, 5, 6), CellId());
  EXPECT_TRUE(mesh.is_outside(mesh.topo().find(n(5), n(6))));
  EXPECT_TRUE(mesh.is_boundary(edge(mesh, 5, 6)));
  mesh.drop_outside();
  EXPECT_EQ(mesh.topo().defect(), nullptr);
  EXPECT_EQ(mesh.topo().face_count(), 7u);
  EXPECT_FALSE(mesh.topo().is_live(n(0)));
  EXPECT_TRUE(mesh.topo().is_live(n(5)));
  EXPECT_DOUBLE_EQ(area(mesh), 7);
}

TEST(WorkMeshCompact, CarriesEverythingAlong) {
  WorkMesh mesh = grid(3, 3);
  mesh.set_segments({{n(14), n(15), CurveId(0)}});
  mesh.set_cell(face(mesh, 0, 1), CellId());
  mesh.set_cell(face(mesh, 10, 11), CellId(2));
  mesh.drop_outside();
  mesh.compact();
  EXPECT_EQ(mesh.topo().defect(), nullptr);
  EXPECT_EQ(mesh.topo().node_capacity(), 15u);
  EXPECT_EQ(mesh.point(n(14)), (Point{3, 3}));
  EXPECT_EQ(mesh.segments()[0].b, n(14));
  EXPECT_TRUE(mesh.is_constraint(edge(mesh, 13, 14)));
  EXPECT_FALSE(mesh.is_constraint(edge(mesh, 4, 5)));
  EXPECT_EQ(mesh.cell(face(mesh, 9, 10)), CellId(2));
  EXPECT_EQ(mesh.tag(n(4)).kind, NodeKind::Free);
  EXPECT_DOUBLE_EQ(area(mesh), 8);
}

TEST(WorkMeshSectors, AreTheGapsBetweenConstraintsInsideTheDomain) {
  WorkMesh mesh = grid(2, 2);
  EXPECT_TRUE(sector_angles(mesh, n(4)).empty());
  ASSERT_EQ(sector_angles(mesh, n(0)).size(), 1u);
  EXPECT_NEAR(sector_angles(mesh, n(0))[0], kPi / 2, 1e-12);
  ASSERT_EQ(sector_angles(mesh, n(1)).size(), 1u);
  EXPECT_NEAR(sector_angles(mesh, n(1))[0], kPi, 1e-12);
}

TEST(WorkMeshSectors, OfTheEndOfAnOpenLineIsAFullTurn) {
  WorkMesh mesh = grid(2, 2);
  mesh.set_curve(edge(mesh, 4, 1), CurveId(1));
  ASSERT_EQ(sector_angles(mesh, n(4)).size(), 1u);
  EXPECT_DOUBLE_EQ(sector_angles(mesh, n(4))[0], 2 * kPi);
  const auto at_foot = sector_angles(mesh, n(1));
  ASSERT_EQ(at_foot.size(), 2u);
  EXPECT_NEAR(at_foot[0], kPi / 2, 1e-12);
  EXPECT_NEAR(at_foot[1], kPi / 2, 1e-12);
}

TEST(WorkMeshSectors, OfACrossingAreFour) {
  WorkMesh mesh = grid(2, 2);
  for (const std::size_t v : {1, 3, 5, 7}) mesh.set_curve(edge(mesh, 4, v), CurveId(1));
  const auto angles = sector_angles(mesh, n(4));
  ASSERT_EQ(angles.size(), 4u);
  for (const double angle : angles) EXPECT_NEAR(angle, kPi / 2, 1e-12);
}

TEST(WorkMeshSectors, AtAPinchNodeLeaveTheOutsideOut) {
  std::vector<Point> points{{0, 0}, {1, 0}, {1, 1}, {0, 1}, {2, 1}, {2, 2}, {1, 2}};
  WorkMesh mesh = made_of(points, {{n(0), n(1), n(2), n(3)}, {n(2), n(4), n(5), n(6)}});
  EXPECT_EQ(defect(mesh), "");
  for (std::size_t i = 0; i < mesh.topo().edge_capacity(); ++i) mesh.set_curve(EdgeId(i), CurveId(0));
  const auto angles = sector_angles(mesh, n(2));
  ASSERT_EQ(angles.size(), 2u);
  EXPECT_NEAR(angles[0], kPi / 2, 1e-12);
  EXPECT_NEAR(angles[1], kPi / 2, 1e-12);
  EXPECT_EQ(ideal_quads(mesh, n(2)), 2);
}

TEST(IdealQuads, SumsTheSectors) {
  WorkMesh mesh = grid(2, 2);
  EXPECT_EQ(ideal_quads(mesh, n(4)), 4);
  EXPECT_EQ(ideal_quads(mesh, n(0)), 1);
  EXPECT_EQ(ideal_quads(mesh, n(1)), 2);
  mesh.set_curve(edge(mesh, 4, 1), CurveId(1));
  EXPECT_EQ(ideal_quads(mesh, n(4)), 4);
  EXPECT_EQ(ideal_quads(mesh, n(1)), 2);
  mesh.set_curve(edge(mesh, 4, 3), CurveId(1));
  EXPECT_EQ(ideal_quads(mesh, n(4)), 4);  // 1 + 3
}

TEST(Defect, NamesWhatIsBroken) {
  WorkMesh inverted = diamond();
  inverted.move(n(1), {0.2, 0.8});
  EXPECT_NE(defect(inverted).find("without positive area"), std::string::npos);

  WorkMesh untagged = diamond();
  EXPECT_NE(defect(untagged).find("free node"), std::string::npos);
  EXPECT_EQ(defect(tagged_diamond()), "");
}

TEST(WorkMesh, FrozenFaceStaysUntilItIsThawed) {
  WorkMesh mesh = made_of({{0, 0}, {1, 0}, {1, 1}, {0, 1}, {2, 0.5}}, {{n(0), n(1), n(2), n(3)}, {n(1), n(4), n(2)}});
  mesh.set_curve(edge(mesh, 0, 1), CurveId(3));
  mesh.freeze(face(mesh, 1, 2));
  EXPECT_TRUE(mesh.is_frozen(face(mesh, 1, 2)));
  EXPECT_FALSE(mesh.is_frozen(face(mesh, 2, 1)));
  EXPECT_FALSE(mesh.is_free(n(2)));
  EXPECT_TRUE(mesh.is_free(n(4)));
  EXPECT_TRUE(mesh.is_constraint(edge(mesh, 2, 3)));
  mesh.thaw();
  EXPECT_FALSE(mesh.is_frozen(face(mesh, 1, 2)));
  EXPECT_TRUE(mesh.is_free(n(2)));
  EXPECT_FALSE(mesh.is_constraint(edge(mesh, 2, 3)));
  EXPECT_EQ(mesh.curve(edge(mesh, 0, 1)), CurveId(3));
}

}  // namespace
}  // namespace quadline
