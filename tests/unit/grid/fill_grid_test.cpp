// Grids and the rings in them: what they have, and that a grid that does not close leaves no trace.
#include "stages/grid/fill_grid.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <tuple>

#include "base/elementary.hpp"
#include "domain/whole_circle.hpp"
#include "geom/angles.hpp"
#include "tests/unit/grid/grid_shapes.hpp"

namespace quadline {
namespace {

const CellId kCell(std::size_t{0});
using Counts = std::vector<std::uint32_t>;

// Of the cell, all quads, with its curves on its edges.
void expect_filled(const WorkMesh& mesh, std::size_t quads) {
  EXPECT_EQ(mesh.topo().face_count(), quads);
  EXPECT_STREQ(mesh.topo().defect(), nullptr);
  EXPECT_EQ(shapes::unsound_count(mesh), 0u);
  for (const FaceId f : mesh.topo().faces()) {
    EXPECT_EQ(mesh.topo().sides(f), 4);
    EXPECT_EQ(mesh.cell(f), kCell);
  }
  for (const Segment& s : mesh.segments()) {
    const HalfId h = mesh.topo().find(s.a, s.b);
    ASSERT_TRUE(h.valid());
    EXPECT_EQ(mesh.curve(edge_of(h)), s.curve);
  }
}

// As it was before: nodes and segments alone.
void expect_untouched(const WorkMesh& mesh, const WorkMesh& before) {
  EXPECT_EQ(mesh.topo().face_count(), 0u);
  EXPECT_EQ(mesh.topo().node_count(), before.topo().node_count());
  ASSERT_EQ(mesh.segments().size(), before.segments().size());
  for (const NodeId v : before.topo().nodes()) EXPECT_EQ(mesh.point(v), before.point(v));
}

void expect_refused(const Domain& domain, const Counts& counts, const GridPlan& plan) {
  const WorkMesh before = shapes::nodes_on(domain, counts);
  WorkMesh mesh = before;
  EXPECT_FALSE(fill_grid(mesh, domain, kCell, plan));
  expect_untouched(mesh, before);
}

double total_area(const WorkMesh& mesh) {
  double sum = 0;
  for (const FaceId f : mesh.topo().faces()) {
    const QuadPoints q = mesh.quad_points(f);
    sum += 0.5 * cross(q[2] - q[0], q[3] - q[1]);
  }
  return sum;
}

TEST(FillGrid, ARectangleIsAGridOfRectangles) {
  const Domain domain = shapes::rectangle(6, 3, 1);
  WorkMesh mesh = shapes::nodes_on(domain, {4, 3, 4, 3});
  ASSERT_TRUE(fill_grid(mesh, domain, kCell, {}));
  expect_filled(mesh, 12);
  EXPECT_TRUE(shapes::irregular_valences(mesh).empty());
  for (const FaceId f : mesh.topo().faces()) EXPECT_NEAR(scaled_jacobian(mesh.quad_points(f)), 1, 1e-12);
  EXPECT_NEAR(total_area(mesh), 18, 1e-12);
}

TEST(FillGrid, NodesInsideFollowThoseOfTheSides) {
  const Domain domain = shapes::polygon({{0, 0}, {4, 0}, {4, 4}, {0, 2}});
  WorkMesh mesh = shapes::nodes_on(domain, {4, 2, 4, 2});
  ASSERT_TRUE(fill_grid(mesh, domain, kCell, {}));
  expect_filled(mesh, 8);
  for (const NodeId v : mesh.topo().nodes())
    if (mesh.is_free(v)) {
      EXPECT_NEAR(mesh.point(v).y, 0.5 * (2 + 0.5 * mesh.point(v).x), 1e-12);
    }
}

TEST(FillGrid, LAndTHaveNoIrregularNodeAtAnyTurn) {
  const std::tuple<std::vector<Point>, Counts, std::size_t> cells[] = {
      {{{0, 0}, {6, 0}, {6, 2}, {2, 2}, {2, 5}, {0, 5}}, {6, 2, 4, 3, 2, 5}, 18},
      {{{2, 0}, {4, 0}, {4, 3}, {6, 3}, {6, 5}, {0, 5}, {0, 3}, {2, 3}}, {2, 3, 2, 2, 6, 2, 2, 3}, 18}};
  for (const auto& [corners, counts, quads] : cells)
    for (const double angle : {0.0, 0.4, 2.0, -1.3}) {
      const Domain domain = shapes::polygon(corners, angle);
      WorkMesh mesh = shapes::nodes_on(domain, counts);
      ASSERT_TRUE(fill_grid(mesh, domain, kCell, {.frame = {{0, 0}, turned({1, 0}, angle)}}));
      expect_filled(mesh, quads);
      EXPECT_TRUE(shapes::irregular_valences(mesh).empty());
      for (const EdgeId e : mesh.topo().edges()) EXPECT_NEAR(mesh.edge_length(e), 1, 1e-12);
    }
}

TEST(FillGrid, TheFirstSideMayRunInAnyDirection) {
  std::vector<Point> corners{{0, 0}, {6, 0}, {6, 2}, {2, 2}, {2, 5}, {0, 5}};
  Counts counts{6, 2, 4, 3, 2, 5};
  const int directions[] = {0, 1, 2, 1, 2, 3};
  for (std::size_t n = 0; n < corners.size(); ++n) {
    const Domain domain = shapes::polygon(corners);
    WorkMesh mesh = shapes::nodes_on(domain, counts);
    ASSERT_TRUE(fill_grid(mesh, domain, kCell, {.direction = directions[n]})) << n;
    expect_filled(mesh, 18);
    EXPECT_NEAR(total_area(mesh), 18, 1e-12);
    std::rotate(corners.begin(), corners.begin() + 1, corners.end());
    std::rotate(counts.begin(), counts.begin() + 1, counts.end());
  }
}

TEST(FillGrid, ASlitHasItsNodesOnce) {
  const Domain domain = shapes::Builder({{0, 0}, {3, 0}, {6, 0}, {6, 4}, {0, 4}, {3, 2}},
                                        {{0, 1}, {1, 2}, {2, 3}, {3, 4}, {4, 0}, {1, 5}}, 1)
                            .build();
  WorkMesh mesh = shapes::nodes_on(domain, {3, 3, 4, 6, 4, 2});
  ASSERT_TRUE(fill_grid(mesh, domain, kCell, {}));
  expect_filled(mesh, 24);
  EXPECT_EQ(mesh.topo().node_count(), 35u);
  EXPECT_TRUE(shapes::irregular_valences(mesh).empty());
}

TEST(FillGrid, CountsThatDoNotCloseAreRefused) {
  const Domain rectangle = shapes::rectangle(6, 3, 1);
  expect_refused(rectangle, {4, 3, 5, 3}, {});
  expect_refused(rectangle, {4, 3, 4, 2}, {});
  const Domain l = shapes::polygon({{0, 0}, {6, 0}, {6, 2}, {2, 2}, {2, 5}, {0, 5}});
  expect_refused(l, {6, 2, 4, 3, 3, 5}, {});
}

// A C with a hook that hangs down from its upper arm: by its counts it may run through the lower one.
TEST(FillGrid, WalksThatWouldOverlapAreRefused) {
  const Domain domain =
      shapes::polygon({{0, 0}, {7, 0}, {7, 2}, {2, 2}, {2, 5}, {4, 5}, {4, 4}, {6, 4}, {6, 7}, {0, 7}});
  WorkMesh mesh = shapes::nodes_on(domain, {7, 2, 5, 3, 2, 1, 2, 3, 6, 7});
  ASSERT_TRUE(fill_grid(mesh, domain, kCell, {}));
  expect_filled(mesh, 14 + 6 + 12 + 2);
  expect_refused(domain, {7, 2, 5, 3, 2, 4, 2, 6, 6, 7}, {});
}

TEST(FillGrid, OtherShapesAreRefused) {
  expect_refused(shapes::polygon({{0, 0}, {4, 0}, {2, 3.5}}), {4, 4, 4}, {});
  Domain domain = shapes::rectangle(6, 3, 1);
  domain.cells[kCell].lone_points.push_back(domain.vertices.push_back({{2.2, 1.1}}));
  expect_refused(domain, {6, 3, 6, 3}, {});
  expect_refused(shapes::plate_with_hole(6, 6, {3, 3}, 1), {6, 6, 6, 6, 4, 4}, {});  // a hole that is not planned
}

// A square plate, its hole in the middle, with room of three squares round a patch of k x k.
struct Washer {
  int k, rings;
  double angle;
  double radius;

  int side() const { return k + 6; }
  Point center() const { return {0.5 * side(), 0.5 * side()}; }
  Domain domain() const { return shapes::plate_with_hole(side(), side(), center(), radius, angle); }
  Counts counts() const {
    const auto n = static_cast<std::uint32_t>(side()), half = static_cast<std::uint32_t>(2 * k);
    return {n, n, n, n, half, half};
  }
  GridPlan plan() const {
    return {
        .frame = {{0, 0}, turned({1, 0}, angle)},
        .columns = side(),
        .rows = side(),
        .holes = {
            {.walk = 1, .columns = k, .rows = k, .rings = rings, .at = turned(center(), angle), .place = center()}}};
  }
};

TEST(FillGrid, WashersHaveFourIrregularNodesAtAnyTurnOfThePlate) {
  for (int k = 2; k <= 6; ++k)
    for (const double angle : {0.0, 0.3, 0.25 * std::numbers::pi, 1.2, 2.9, -1.9}) {
      const Washer washer{k, 1, angle, 0.5 * (k - 0.4)};
      const Domain domain = washer.domain();
      WorkMesh mesh = shapes::nodes_on(domain, washer.counts());
      ASSERT_TRUE(fill_grid(mesh, domain, kCell, washer.plan())) << k << " " << angle;
      expect_filled(mesh, static_cast<std::size_t>(washer.side() * washer.side() - k * k + 4 * k));
      EXPECT_EQ(shapes::irregular_valences(mesh), std::vector<int>(4, 5));
      for (const NodeId v : mesh.topo().nodes()) {
        if (!mesh.is_free(v) || mesh.topo().edge_valence(v) == 4) continue;
        const Point off = turned(mesh.point(v), -angle) - washer.center();
        EXPECT_NEAR(std::abs(off.x), 0.5 * k, 1e-9);  // the corners of the patch
        EXPECT_NEAR(std::abs(off.y), 0.5 * k, 1e-9);
      }
    }
}

TEST(FillGrid, MoreRingsAreMoreCirclesOfQuads) {
  for (const int rings : {1, 2, 3}) {
    const Washer washer{4, rings, 0.3, 0.5};
    const Domain domain = washer.domain();
    WorkMesh mesh = shapes::nodes_on(domain, washer.counts());
    ASSERT_TRUE(fill_grid(mesh, domain, kCell, washer.plan()));
    expect_filled(mesh, static_cast<std::size_t>(100 - 16 + 16 * rings));
    EXPECT_EQ(shapes::irregular_valences(mesh), std::vector<int>(4, 5));
  }
}

TEST(FillGrid, RingsOfTheModelAreEquallyWideOnStraightRays) {
  const Domain domain = shapes::ring(2, 5, 1);
  WorkMesh mesh = shapes::nodes_on(domain, {11, 11, 11, 11});
  ASSERT_TRUE(fill_grid(mesh, domain, kCell, {.rings = 3}));
  expect_filled(mesh, 66);
  for (const NodeId v : mesh.topo().nodes()) {
    const double turn = arc_tangent(mesh.point(v).y, mesh.point(v).x) * 11 / std::numbers::pi, r = norm(mesh.point(v));
    EXPECT_NEAR(r, std::round(r), 1e-12);
    EXPECT_NEAR(turn, std::round(turn), 1e-9);
  }
  expect_refused(domain, {11, 11, 12, 12}, {.rings = 3});
  Domain askew = domain;
  WholeCircles::turn(askew, askew.cells[kCell].walks[1], {1, 0.1});
  expect_refused(askew, {11, 11, 11, 11}, {.rings = 3});
}

TEST(FillGrid, TheNodesOfARingLieBesideEachOther) {
  const Washer washer{3, 1, 0.7, 1.2};
  const Domain domain = washer.domain();
  WorkMesh mesh = shapes::nodes_on(domain, washer.counts());
  ASSERT_TRUE(fill_grid(mesh, domain, kCell, washer.plan()));
  const Point center = turned(washer.center(), washer.angle);
  for (const NodeId v : mesh.topo().nodes()) {
    if (std::abs(distance(mesh.point(v), center) - washer.radius) > 1e-9) continue;
    mesh.topo().for_each_out(v, [&](HalfId h) {
      const Point out = mesh.point(mesh.topo().head(h)) - mesh.point(v), ray = mesh.point(v) - center;
      if (!mesh.is_free(mesh.topo().head(h))) return;
      EXPECT_GT(dot(out, ray), 0.9 * norm(out) * norm(ray));
    });
  }
}

TEST(FillGrid, APatchOfOddAndEvenSidesSurroundsASlot) {
  // A slot 4 long and 2 high in a plate of 11 x 8, patch 5 x 3: 16 edges, 5 on each end, 3 on each side.
  const Domain domain =
      shapes::Builder({{0, 0}, {11, 0}, {11, 8}, {0, 8}, {4.5, 3}, {6.5, 3}, {6.5, 5}, {4.5, 5}},
                      {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {4, 5}, {5, 6, Point{7.5, 4}}, {6, 7}, {7, 4, Point{3.5, 4}}}, 1)
          .build({{5.5, 4}});
  WorkMesh mesh = shapes::nodes_on(domain, {11, 8, 11, 8, 3, 5, 3, 5});
  const GridHole slot{.walk = 1, .columns = 5, .rows = 3, .rings = 1, .at = {5.5, 4}, .place = {5.5, 4}};
  ASSERT_TRUE(fill_grid(mesh, domain, kCell, {.columns = 11, .rows = 8, .holes = {slot}}));
  expect_filled(mesh, 88 - 15 + 16);
  EXPECT_EQ(shapes::irregular_valences(mesh), std::vector<int>(4, 5));
}

// From the middle of a long slot many nodes lie in about the direction of a corner of the patch.
TEST(FillGrid, TheRingOfALongSlotIsAsSymmetricAsIt) {
  const Domain domain =
      shapes::Builder(
          {{0, 0}, {25, 0}, {25, 9}, {0, 9}, {4.5, 3.5}, {20.5, 3.5}, {20.5, 5.5}, {4.5, 5.5}},
          {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {4, 5}, {5, 6, Point{21.5, 4.5}}, {6, 7}, {7, 4, Point{3.5, 4.5}}}, 1)
          .build({{12.5, 4.5}});
  WorkMesh mesh = shapes::nodes_on(domain, {25, 9, 25, 9, 17, 5, 17, 5});
  const GridHole slot{.walk = 1, .columns = 19, .rows = 3, .rings = 1, .at = {12.5, 4.5}, .place = {12.5, 4.5}};
  ASSERT_TRUE(fill_grid(mesh, domain, kCell, {.columns = 25, .rows = 9, .holes = {slot}}));
  std::set<std::array<long, 4>> spokes, mirrored;
  const auto rounded = [](double x) { return std::lround(1e6 * x); };
  for (const NodeId v : mesh.topo().nodes()) {
    const Point p = mesh.point(v);
    if (mesh.is_free(v) || p.x < 1 || p.x > 24 || p.y < 1 || p.y > 8) continue;
    mesh.topo().for_each_out(v, [&](HalfId h) {
      if (!mesh.is_free(mesh.topo().head(h))) return;
      const Point q = mesh.point(mesh.topo().head(h));
      spokes.insert({rounded(p.x), rounded(p.y), rounded(q.x), rounded(q.y)});
      mirrored.insert({rounded(25 - p.x), rounded(p.y), rounded(25 - q.x), rounded(q.y)});
    });
  }
  EXPECT_EQ(spokes.size(), 44u);
  EXPECT_EQ(spokes, mirrored);
}

TEST(FillGrid, HolesGoToTheNearestPlaceWhereCountsAreOthers) {
  const Washer washer{4, 1, 0, 1.4};
  const Domain domain = washer.domain();
  Counts counts = washer.counts();
  for (const std::size_t side : {0, 2}) counts[side] += 2;
  WorkMesh mesh = shapes::nodes_on(domain, counts);
  ASSERT_TRUE(fill_grid(mesh, domain, kCell, washer.plan()));
  expect_filled(mesh, 10 * 12 - 16 + 16);
}

TEST(FillGrid, HolesThatDoNotFitAreRefused) {
  const Washer washer{4, 1, 0.3, 1.8};
  const Domain domain = washer.domain();
  Counts counts = washer.counts();
  counts[4] = 7;  // 15 nodes on the hole
  expect_refused(domain, counts, washer.plan());
  GridPlan wide = washer.plan();
  wide.holes[0].columns = 3;  // 14 edges round it
  expect_refused(domain, washer.counts(), wide);
  GridPlan aside = washer.plan();
  aside.holes[0].place = {1, 5};  // over the edge
  expect_refused(domain, washer.counts(), aside);
}

// Two patches side by side share the nodes of their common side, between which no square is left.
TEST(FillGrid, PatchesMayShareASide) {
  const auto hole_at = [](Point at) {
    return GridHole{.walk = at.x < 4 ? 1u : 2u, .columns = 4, .rows = 4, .rings = 1, .at = at, .place = at};
  };
  std::vector<Point> points{{0, 0}, {8, 0}, {8, 4}, {0, 4}};
  std::vector<shapes::Link> links{{0, 1}, {1, 2}, {2, 3}, {3, 0}};
  const std::vector<Point> centers{{2, 2}, {6, 2}};
  for (const Point at : centers) {
    const Point way = std::sqrt(0.5) * Point{1, 1}, side = left_normal(way);
    const std::size_t n = points.size();
    points.push_back(at + way);
    points.push_back(at - way);
    links.push_back({n, n + 1, at + side});
    links.push_back({n + 1, n, at - side});
  }
  const Domain domain = shapes::Builder(points, links, 1).build(centers);
  std::vector<GridHole> holes{hole_at({2, 2}), hole_at({6, 2})};
  if (domain.cells[kCell].walks[1][0].curve.value >= 6) std::swap(holes[0].walk, holes[1].walk);
  WorkMesh mesh = shapes::nodes_on(domain, {8, 4, 8, 4, 8, 8, 8, 8});
  ASSERT_TRUE(fill_grid(mesh, domain, kCell, {.columns = 8, .rows = 4, .holes = holes}));
  expect_filled(mesh, 32);
  EXPECT_TRUE(shapes::irregular_valences(mesh).empty());
}

TEST(FillGrid, PatchesThatOverlapAreRefused) {
  const Domain domain = shapes::arranged(shapes::plate_model(20, 10, {{8, 5}, {11, 5}}, 1));
  ASSERT_EQ(domain.curves.count(), 8u);
  Counts counts;
  for (const Domain::Curve& curve : domain.curves)
    counts.push_back(curve.piece.is_arc() ? 8 : static_cast<std::uint32_t>(std::lround(length(curve.piece))));
  const CurvePiece& first = domain.curves[domain.cells[kCell].walks[0][0].curve].piece;
  ASSERT_GT(first.b.x, first.a.x);  // the walk begins along the axis
  GridPlan plan{.columns = 20, .rows = 10};
  for (const std::size_t w : {1, 2}) {
    const Point center = domain.curves[domain.cells[kCell].walks[w][0].curve].piece.center;
    plan.holes.push_back({.walk = w, .columns = 4, .rows = 4, .rings = 1, .at = center, .place = center});
  }
  expect_refused(domain, counts, plan);
  for (GridHole& hole : plan.holes) hole.place.x += hole.place.x < 9 ? -1 : 1;
  WorkMesh apart = shapes::nodes_on(domain, counts);
  EXPECT_TRUE(fill_grid(apart, domain, kCell, plan));
  EXPECT_EQ(shapes::irregular_valences(apart), std::vector<int>(8, 5));
}

GridPlan ring_plan() { return {.frame = {{0, 0}, {1, 0}, true}, .inner = 1}; }

TEST(FillRing, RaysAndCircles) {
  const Domain domain = shapes::ring(1, 2, 0.3);
  WorkMesh mesh = shapes::nodes_on(domain, {12, 12, 12, 12});
  ASSERT_TRUE(fill_grid(mesh, domain, kCell, ring_plan()));
  expect_filled(mesh, 24 * 3);  // 24 log(2) / (2 pi) columns, rounded
  EXPECT_TRUE(shapes::irregular_valences(mesh).empty());
  for (const NodeId v : mesh.topo().nodes()) {
    const Point p = mesh.point(v);
    const double ray = std::atan2(p.y, p.x) / (std::numbers::pi / 12), circle = 3 * std::log2(norm(p));
    EXPECT_NEAR(ray, std::round(ray), 1e-9);
    EXPECT_NEAR(circle, std::round(circle), 1e-9);
  }
}

TEST(FillRing, TheCirclesMayBeginElsewhere) {
  Domain domain = shapes::ring(1, 2, 0.3);
  for (const std::size_t c : {2, 3}) {  // the inner one by 5 rays
    CurvePiece& piece = domain.curves[CurveId(c)].piece;
    const double angle = 5 * std::numbers::pi / 12;
    piece.a = turned(piece.a, angle);
    piece.b = turned(piece.b, angle);
    domain.vertices[domain.curves[CurveId(c)].tail].at = piece.a;
    domain.vertices[domain.curves[CurveId(c)].head].at = piece.b;
  }
  WorkMesh mesh = shapes::nodes_on(domain, {12, 12, 12, 12});
  ASSERT_TRUE(fill_grid(mesh, domain, kCell, ring_plan()));
  expect_filled(mesh, 24 * 3);
  for (const NodeId v : mesh.topo().nodes()) {
    const double ray = std::atan2(mesh.point(v).y, mesh.point(v).x) / (std::numbers::pi / 12);
    EXPECT_NEAR(ray, std::round(ray), 1e-9);
  }
}

TEST(FillRing, CountsThatDifferAreRefused) {
  const Domain domain = shapes::ring(1, 2, 0.3);
  expect_refused(domain, {12, 12, 12, 11}, ring_plan());
  expect_refused(domain, {1, 1, 1, 1}, ring_plan());
}

// The ring between circles of radius 1 and `outer` with a hole at `at`, and a plan for a patch of two by two.
struct RingWithHole {
  RingWithHole(double outer, Point at, double r) {
    const Point way = r * std::sqrt(0.5) * Point{1, 1}, side = left_normal(way);
    domain = shapes::Builder({{outer, 0}, {-outer, 0}, {1, 0}, {-1, 0}, at + way, at - way},
                             {{0, 1, Point{0, outer}},
                              {1, 0, Point{0, -outer}},
                              {2, 3, Point{0, 1}},
                              {3, 2, Point{0, -1}},
                              {4, 5, at + side},
                              {5, 4, at - side}},
                             0.2)
                 .build({{0, 0}, at});
    const auto& walks = domain.cells[kCell].walks;
    const std::size_t hole = walks.at(1)[0].curve.value >= 4 ? 1 : 2;
    plan.inner = 3 - hole;
    plan.holes = {{.walk = hole, .columns = 2, .rows = 2, .rings = 1, .at = at}};
  }
  Domain domain;
  GridPlan plan = ring_plan();
};

// On the y axis of a ring of 48 rays and 8 circles, halfway out; and over the ray where rows begin.
TEST(FillRing, HolesInARingHaveRingsToo) {
  for (const Point at : {Point{0, std::sqrt(3.0)}, Point{std::sqrt(3.0), 0}}) {
    const RingWithHole ring(3, at, 0.15);
    WorkMesh mesh = shapes::nodes_on(ring.domain, {24, 24, 24, 24, 4, 4});
    ASSERT_TRUE(fill_grid(mesh, ring.domain, kCell, ring.plan));
    expect_filled(mesh, 8 * 48 - 4 + 8);
    EXPECT_EQ(shapes::irregular_valences(mesh), std::vector<int>(4, 5));
  }
}

// Without a row beside it a patch would touch the circle: one circle more makes room.
TEST(FillRing, ThereIsARowBetweenAPatchAndTheCircles) {
  const RingWithHole ring(2, {0, 1.5}, 0.1);
  WorkMesh mesh = shapes::nodes_on(ring.domain, {12, 12, 12, 12, 4, 4});
  ASSERT_TRUE(fill_grid(mesh, ring.domain, kCell, ring.plan));  // ln 2 / (2 pi / 24) = 2.6 circles, and one more
  expect_filled(mesh, 4 * 24 - 4 + 8);
}

}  // namespace
}  // namespace quadline
