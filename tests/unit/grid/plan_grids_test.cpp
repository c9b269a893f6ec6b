// Which cells are to become grids, and that like holes get like rings.
#include "stages/grid/plan_grids.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <set>

#include "base/constants.hpp"
#include "domain/whole_circle.hpp"
#include "tests/unit/grid/grid_shapes.hpp"

namespace quadline {
namespace {

const CellId kCell(std::size_t{0});

double free_of_charge(const Domain&, CellId, const GridProposal&) { return 0; }

// The domain as it is planned, too.
struct Planned {
  Domain domain;
  GridPlans plans;

  const GridPlan& plan() const { return plans.cells[kCell]->plan; }
  std::uint32_t count(DirectedCurve d) const { return plans.counts[d.curve]; }
  // Edges on the curves of the outer walk in the direction of an axis.
  std::uint32_t side_count(Point axis) const {
    std::uint32_t n = 0;
    for (const DirectedCurve& d : domain.cells[kCell].walks[0]) {
      const CurvePiece& p = domain.curves[d.curve].piece;
      if (dot((d.reversed ? -1.0 : 1.0) * (p.b - p.a), axis) > 0.5 * length(p)) n += count(d);
    }
    return n;
  }
};

Planned planned(Domain domain,
                const std::function<double(const Domain&, CellId, const GridProposal&)>& cost = free_of_charge,
                const Options& options = {}) {
  GridPlans plans = plan_grids(domain, options, cost);
  return {std::move(domain), std::move(plans)};
}

// Centres at the middles of n x n squares of `pitch`.
std::vector<Point> centers(int n, double pitch) {
  std::vector<Point> all;
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) all.push_back({(i + 0.5) * pitch, (j + 0.5) * pitch});
  return all;
}

bool has_fill(const Planned& planned) {
  std::vector<std::uint32_t> counts(planned.plans.counts.raw());
  WorkMesh mesh = shapes::nodes_on(planned.domain, counts);
  return fill_grid(mesh, planned.domain, kCell, planned.plan()) && shapes::unsound_count(mesh) == 0;
}

TEST(PlanGrids, OneHoleInAPlate) {
  const Planned made = planned(shapes::arranged(shapes::plate_model(16, 12, {{8, 6}}, 1.8)));
  ASSERT_TRUE(made.plans.cells[kCell]);
  ASSERT_EQ(made.plan().holes.size(), 1u);
  const GridHole& hole = made.plan().holes[0];
  EXPECT_EQ(hole.columns, hole.rows);
  EXPECT_GE(hole.columns, 4);
  EXPECT_LE(hole.columns, 6);
  EXPECT_EQ(hole.rings, 1);
  EXPECT_EQ(hole.place, (Point{0.5 * made.plan().columns, 0.5 * made.plan().rows}));
  for (const DirectedCurve& d : made.domain.cells[kCell].walks[1]) {
    EXPECT_EQ(made.count(d), static_cast<std::uint32_t>(2 * hole.columns));
    EXPECT_TRUE(made.domain.curves[d.curve].has_rings);
  }
  for (const DirectedCurve& d : made.domain.cells[kCell].walks[0]) EXPECT_FALSE(made.domain.curves[d.curve].has_rings);
  EXPECT_EQ(made.side_count({1, 0}), static_cast<std::uint32_t>(made.plan().columns));
  EXPECT_EQ(made.side_count({-1, 0}), static_cast<std::uint32_t>(made.plan().columns));
  EXPECT_EQ(made.side_count({0, 1}), static_cast<std::uint32_t>(made.plan().rows));
  EXPECT_NEAR(made.plan().columns * made.plan().rows, 16 * 12, 40);
  EXPECT_TRUE(has_fill(made));
}

Model ringed_plate(std::optional<std::uint32_t> edges) {
  Model model = shapes::plate_model(20, 16, {{10, 8}}, 1.5);
  model.holes[0].circle->edges = edges;
  model.holes[0].circle->rings = 2;
  model.holes[0].circle->ring_width = 0.5;
  return model;
}

CellId cell_of_rings(const Domain& domain) {
  for (std::size_t i = 0; i < domain.cells.count(); ++i)
    if (domain.cells[CellId(i)].rings > 0) return CellId(i);
  return {};
}

TEST(PlanGrids, ThePatchRoundRingsHasTheEdgesThatAreGiven) {
  for (const std::uint32_t edges : {20u, 24u}) {
    const Planned made = planned(shapes::arranged(ringed_plate(edges)));
    const CellId rings = cell_of_rings(made.domain), outside(rings.value == 0 ? 1u : 0u);
    ASSERT_TRUE(made.plans.cells[rings] && made.plans.cells[outside]);
    EXPECT_EQ(made.plans.cells[rings]->plan.rings, 2);
    EXPECT_EQ(made.plans.cells[outside]->plan.holes[0].columns, static_cast<int>(edges / 4));
  }
  const Planned odd = planned(shapes::arranged(ringed_plate(22)));  // no square patch has so many round it
  const CellId rings = cell_of_rings(odd.domain), outside(rings.value == 0 ? 1u : 0u);
  EXPECT_TRUE(odd.plans.cells[rings]);
  EXPECT_FALSE(odd.plans.cells[outside]);
}

TEST(PlanGrids, RingsWithoutANumberGetThatOfTheGridRoundThem) {
  const Planned made = planned(shapes::arranged(ringed_plate({})));
  const CellId rings = cell_of_rings(made.domain), outside(rings.value == 0 ? 1u : 0u);
  ASSERT_TRUE(made.plans.cells[rings] && made.plans.cells[outside]);
  const auto k = static_cast<std::uint32_t>(made.plans.cells[outside]->plan.holes[0].columns);
  for (const auto& circle : made.domain.cells[rings].walks) {
    const CurvePiece& piece = made.domain.curves[circle[0].curve].piece;
    EXPECT_NEAR(std::abs(piece.a.x - 10), std::abs(piece.a.y - 8), 1e-12);  // turned together
    for (const DirectedCurve& d : circle) EXPECT_EQ(made.domain.curves[d.curve].edges, 2 * k);
  }
}

TEST(PlanGrids, RingsArePlannedByEveryMethod) {
  for (const Method method : {Method::QMorph, Method::Merge, Method::Split}) {
    Options options;
    options.method = method;
    const Planned made = planned(shapes::arranged(ringed_plate({})), free_of_charge, options);
    const CellId rings = cell_of_rings(made.domain), outside(rings.value == 0 ? 1u : 0u);
    EXPECT_TRUE(made.plans.cells[rings]);
    EXPECT_FALSE(made.plans.cells[outside]);
    for (const auto& circle : made.domain.cells[rings].walks)
      for (const DirectedCurve& d : circle) EXPECT_GT(made.domain.curves[d.curve].edges, 0u);
  }
}

TEST(PlanGrids, ARingOfGridsHasTheRaysThatItsCirclesAreGiven) {
  Model model = shapes::flange_model(0);
  model.holes[0].circle->edges = 44;
  const Planned made = planned(shapes::arranged(model));
  ASSERT_TRUE(made.plans.cells[kCell]);
  for (const CountWish& wish : made.plans.cells[kCell]->wishes) EXPECT_EQ(wish.count, 22u);
  model.outer[0].circle->edges = 48;
  EXPECT_FALSE(planned(shapes::arranged(model)).plans.cells[kCell]);
}

TEST(PlanGrids, TheArcsOfAHoleEndOnTheDiagonalOfItsPatch) {
  const Planned made = planned(shapes::arranged(shapes::plate_model(16, 12, {{8, 6}}, 2)));
  for (const DirectedCurve& d : made.domain.cells[kCell].walks[1]) {
    const CurvePiece& piece = made.domain.curves[d.curve].piece;
    EXPECT_NEAR(std::abs(piece.a.x - 8), std::sqrt(2), 1e-12);
    EXPECT_NEAR(piece.a.x - 8, piece.a.y - 6, 1e-12);
  }
}

TEST(PlanGrids, LikeHolesHaveLikePatchesAndGaps) {
  const Planned made = planned(shapes::arranged(shapes::plate_model(44, 44, centers(8, 5.5), 1.5)));
  ASSERT_TRUE(made.plans.cells[kCell]);
  ASSERT_EQ(made.plan().holes.size(), 64u);
  std::set<int> k;
  std::set<double> x, y;
  for (const GridHole& hole : made.plan().holes) {
    k.insert({hole.columns, hole.rows});
    x.insert(hole.place.x);
    y.insert(hole.place.y);
    EXPECT_EQ(hole.rings, 1);
  }
  EXPECT_EQ(k.size(), 1u);
  ASSERT_EQ(x.size(), 8u);
  EXPECT_EQ(x, y);
  const std::vector<double> along(x.begin(), x.end());
  for (std::size_t n = 1; n < along.size(); ++n) EXPECT_EQ(along[n] - along[n - 1], along[1] - along[0]);
  EXPECT_EQ(made.plan().columns, made.plan().rows);
  EXPECT_EQ(along.front(), made.plan().columns - along.back());  // the same from both edges
  EXPECT_TRUE(has_fill(made));
}

TEST(PlanGrids, AFlangeHasTheSameRaysFromBoltToBolt) {
  const Planned made = planned(shapes::arranged(shapes::flange_model(8)));
  ASSERT_TRUE(made.plans.cells[kCell]);
  ASSERT_EQ(made.plan().holes.size(), 8u);
  std::set<int> k;
  for (const GridHole& hole : made.plan().holes) k.insert({hole.columns, hole.rows});
  EXPECT_EQ(k.size(), 1u);
  std::set<std::uint32_t> rays;
  for (const std::size_t w : {std::size_t{0}, made.plan().inner})
    for (const DirectedCurve& d : made.domain.cells[kCell].walks[w]) rays.insert(made.count(d));
  ASSERT_EQ(rays.size(), 1u);
  EXPECT_EQ(2 * *rays.begin() % 8, 0u);
  EXPECT_TRUE(has_fill(made));
  for (const GridHole& hole : made.plan().holes)
    for (const DirectedCurve& d : made.domain.cells[kCell].walks[hole.walk])
      EXPECT_EQ(made.count(d), static_cast<std::uint32_t>(2 * *k.begin()));
}

// The two arcs of a circle have an even number of edges each, and every bolt the same, whatever the number of bolts.
TEST(PlanGrids, AFlangeOfAnyNumberOfBoltsHasRaysForTwoEvenArcs) {
  for (const int bolts : {2, 3, 4, 5, 6, 7, 10}) {
    const Planned made = planned(shapes::arranged(shapes::flange_model(bolts)));
    ASSERT_TRUE(made.plans.cells[kCell]) << bolts;
    const std::uint32_t half = made.count(made.domain.cells[kCell].walks[0][0]);
    EXPECT_EQ(half % 2, 0u) << bolts;
    EXPECT_EQ(2 * half % static_cast<std::uint32_t>(bolts), 0u) << bolts;
  }
}

// Denser ones are asked for where the first will not do, and only there.
TEST(PlanGrids, TheFirstFlangeThatWillDoIsTaken) {
  const Domain flange = shapes::arranged(shapes::flange_model(8));
  std::vector<std::uint32_t> rays;
  const auto refuse_first = [&](const Domain&, CellId, const GridProposal& proposal) {
    rays.push_back(proposal.wishes[0].count);
    return rays.size() == 1 ? kInfinity : 0;
  };
  ASSERT_TRUE(planned(flange, refuse_first).plans.cells[kCell]);
  ASSERT_EQ(rays.size(), 2u);
  EXPECT_GT(rays[1], rays[0]);
}

TEST(PlanGrids, ARingWithoutHolesIsOne) {
  const Planned made = planned(shapes::arranged(shapes::flange_model(0)));
  ASSERT_TRUE(made.plans.cells[kCell]);
  EXPECT_TRUE(made.plan().frame.is_polar);
  EXPECT_TRUE(has_fill(made));
}

TEST(PlanGrids, AThickRingIsNone) {
  Model model = shapes::flange_model(0);
  model.holes[0].circle->radius = 3.3;
  EXPECT_FALSE(planned(shapes::arranged(model)).plans.cells[kCell]);
  model.holes[0].circle->radius = 3.6;
  EXPECT_TRUE(planned(shapes::arranged(model)).plans.cells[kCell]);
}

TEST(PlanGrids, SmallHolesHaveMoreRings) {
  const auto rings = [](double radius) {
    return planned(shapes::arranged(shapes::plate_model(16, 12, {{8, 6}}, radius))).plan().holes[0].rings;
  };
  EXPECT_EQ(rings(1.5), 1);
  EXPECT_EQ(rings(0.3), 2);
  EXPECT_EQ(rings(0.1), 3);
}

// A row of holes of which one would have three squares across and the next four.
TEST(PlanGrids, HolesInARowSuitOneLineOfTheGrid) {
  const auto squares = [](double radius) {
    return planned(shapes::arranged(shapes::plate_model(10, 10, {{5, 5}}, radius))).plan().holes[0].columns;
  };
  const double small = 1.3, large = 1.8;
  ASSERT_NE(squares(small) % 2, squares(large) % 2);
  Model model = shapes::plate_model(20, 10, {{5, 5}}, small);
  model.holes.push_back({.circle = Circle{{14.5, 5}, large}});
  const Planned made = planned(shapes::arranged(model));
  ASSERT_TRUE(made.plans.cells[kCell]);
  EXPECT_EQ(made.plan().holes[0].rows % 2, made.plan().holes[1].rows % 2);
  EXPECT_EQ(made.plan().holes[0].place.y, made.plan().holes[1].place.y);
}

Model disk_model(double radius) {
  Model model;
  model.size = 1;
  model.outer.push_back({.circle = Circle{{0, 0}, radius}});
  return model;
}

TEST(PlanGrids, ADiskHasTheQuadsOfItsArea) {
  for (const double radius : {4.0, 8.0, 15.0}) {
    const Planned made = planned(shapes::arranged(disk_model(radius)));
    ASSERT_TRUE(made.plans.cells[kCell]);
    EXPECT_TRUE(made.plan().is_disk);
    WorkMesh mesh = shapes::nodes_on(made.domain, made.plans.counts.raw());
    ASSERT_TRUE(fill_grid(mesh, made.domain, kCell, made.plan()));
    const double area = std::numbers::pi * radius * radius;
    EXPECT_NEAR(static_cast<double>(mesh.topo().face_count()), area, 0.15 * area);
    EXPECT_NEAR(made.domain.curves[CurveId(std::size_t{0})].piece.a.x, radius * std::sqrt(0.5), 1e-9);  // turned
  }
}

TEST(PlanGrids, ADiskHasTheEdgesThatItsCircleAsksFor) {
  Model model = disk_model(6);
  const auto edges = [&] {
    const Planned made = planned(shapes::arranged(model));
    return made.plans.cells[kCell] ? 2 * made.count(made.domain.cells[kCell].walks[0][0]) : 0;
  };
  model.outer[0].circle->edges = 48;
  EXPECT_EQ(edges(), 48u);
  model.outer[0].circle->edges = 46;
  EXPECT_EQ(edges(), 0u);
  model.outer[0].circle->edges = 4000;
  EXPECT_EQ(edges(), 0u);
  model = disk_model(0.4);  // as round as the least
  EXPECT_GE(edges(), 8u);
}

// Inside a round line the disk has the edges of the patch outside.
TEST(PlanGrids, ADiskInAPlateFollowsThePlate) {
  Model model = shapes::plate_model(16, 12, {}, 0);
  model.lines.push_back({.name = "pad", .path = {.circle = Circle{{8, 6}, 2.5}}});
  const Planned made = planned(shapes::arranged(model));
  ASSERT_EQ(made.domain.cells.count(), 2u);
  for (std::size_t i = 0; i < 2; ++i) ASSERT_TRUE(made.plans.cells[CellId(i)]);
  const std::size_t disk = made.plans.cells[CellId(std::size_t{0})]->plan.is_disk ? 0 : 1;
  const GridHole& hole = made.plans.cells[CellId(1 - disk)]->plan.holes.at(0);
  for (const DirectedCurve& d : made.domain.cells[CellId(disk)].walks[0])
    EXPECT_EQ(made.count(d), static_cast<std::uint32_t>(2 * hole.columns));
}

TEST(PlanGrids, ADiskWithAPointInsideIsNone) {
  Model model = disk_model(6);
  model.points.push_back({.name = "lug", .at = {1, 1}});
  EXPECT_FALSE(planned(shapes::arranged(model)).plans.cells[kCell]);
}

// Washers are circles round the holes whose edges are finer than those of the plate.
TEST(PlanGrids, AFinerCircleHasThePatchThatItsEdgesNeed) {
  Model model = shapes::plate_model(16, 12, {}, 0);
  model.lines.push_back(
      {.name = "washer", .path = {.circle = Circle{{8, 6}, 1.5}}, .size = 2 * std::numbers::pi * 1.5 / 24});
  model.holes.push_back({.circle = Circle{{8, 6}, 0.8}});
  const Planned made = planned(shapes::arranged(model));
  const Domain& domain = made.domain;
  std::size_t rings = 0;
  for (std::size_t i = 0; i < domain.cells.count(); ++i) {
    ASSERT_TRUE(made.plans.cells[CellId(i)]) << i;
    const GridPlan& plan = made.plans.cells[CellId(i)]->plan;
    for (const DirectedCurve& d : domain.cells[CellId(i)].walks[1]) EXPECT_EQ(made.count(d), 12u);
    if (plan.frame.is_polar) {
      ++rings;
      continue;
    }
    EXPECT_EQ(plan.holes[0].columns, 6);
    EXPECT_EQ(plan.holes[0].rows, 6);
    EXPECT_EQ(plan.holes[0].rings, 2);  // as wide as they are long, in the mean
  }
  EXPECT_EQ(rings, 1u);
}

// A hole of radius 1.8 would have 16.
TEST(PlanGrids, EdgesThatTheModelGivesAreThePatch) {
  const auto plate = [](std::uint32_t edges) {
    Model model = shapes::plate_model(16, 12, {{8, 6}}, 1.8);
    model.holes[0].circle->edges = edges;
    return planned(shapes::arranged(model));
  };
  for (const std::uint32_t edges : {12u, 16u, 20u, 24u}) {
    const Planned made = plate(edges);
    ASSERT_TRUE(made.plans.cells[kCell]) << edges;
    EXPECT_EQ(made.plan().holes[0].columns, static_cast<int>(edges / 4));
    for (const DirectedCurve& d : made.domain.cells[kCell].walks[1]) EXPECT_EQ(made.count(d), edges / 2);
  }
  for (const std::uint32_t edges : {4u, 18u, 22u, 400u}) EXPECT_FALSE(plate(edges).plans.cells[kCell]) << edges;
}

// Middles of holes in one row lie all on a line of it or all between two: the others follow those that are given.
TEST(PlanGrids, HolesInARowSuitThoseThatAreGiven) {
  const auto plate = [](std::uint32_t left, std::optional<std::uint32_t> right) {
    Model model = shapes::plate_model(24, 12, {{7, 6}, {17, 6}}, 1.8);
    model.holes[0].circle->edges = left;
    model.holes[1].circle->edges = right;
    return planned(shapes::arranged(model));
  };
  const Planned free = plate(12, std::nullopt);
  ASSERT_TRUE(free.plans.cells[kCell]);
  EXPECT_EQ(free.plan().holes[0].columns, 3);
  EXPECT_EQ(free.plan().holes[1].columns, 5);
  EXPECT_TRUE(plate(12, 20).plans.cells[kCell]);
  EXPECT_FALSE(plate(12, 16).plans.cells[kCell]);
}

TEST(PlanGrids, EdgesOfABoreAreTheRays) {
  const auto flange = [](int bolts, std::uint32_t edges) {
    Model model = shapes::flange_model(bolts);
    model.holes[0].circle->edges = edges;
    return planned(shapes::arranged(model));
  };
  const Planned ring = flange(0, 40);
  ASSERT_TRUE(ring.plans.cells[kCell]);
  EXPECT_EQ(ring.count(ring.domain.cells[kCell].walks[0][0]), 20u);
  EXPECT_FALSE(flange(8, 42).plans.cells[kCell]);  // no multiple of the bolts
}

// More room cannot come from a larger patch there.
TEST(PlanGrids, WithEdgesThatAreGivenTheLastProposalHasARingMore) {
  Model model = shapes::plate_model(16, 12, {{8, 6}}, 1.8);
  model.holes[0].circle->edges = 16;
  std::vector<int> rings;
  planned(shapes::arranged(model), [&](const Domain&, CellId, const GridProposal& proposal) {
    rings.push_back(proposal.plan.holes[0].rings);
    return kInfinity;
  });
  EXPECT_EQ(rings, (std::vector<int>{1, 1, 2}));
}

TEST(PlanGrids, ACircleThatIsTooFineHasNoPatch) {
  Model model = shapes::plate_model(16, 12, {}, 0);
  model.lines.push_back({.name = "washer", .path = {.circle = Circle{{8, 6}, 1.5}}, .size = 1e-4});
  model.holes.push_back({.circle = Circle{{8, 6}, 0.1}});
  int n_shown = 0;
  planned(shapes::arranged(model), [&](const Domain&, CellId, const GridProposal&) { return ++n_shown, kInfinity; });
  EXPECT_EQ(n_shown, 0);
}

// A slot may be wider than its straight sides are long.
TEST(PlanGrids, AShortSlotHasAPatch) {
  for (const bool is_level : {true, false}) {
    Model model = shapes::plate_model(16, 16, {}, 0);
    const auto at = [&](double along, double across) {
      return is_level ? Point{8 + along, 8 + across} : Point{8 - across, 8 + along};
    };
    Path slot{
        .items = {{at(-1, -1.5)}, {at(1, -1.5)}, {at(1, 1.5), at(2.5, 0)}, {at(-1, 1.5)}, {at(-1, -1.5), at(-2.5, 0)}}};
    model.holes.push_back(slot);
    const Planned made = planned(shapes::arranged(model));
    ASSERT_TRUE(made.plans.cells[kCell]) << is_level;
    const GridHole& hole = made.plan().holes.at(0);
    EXPECT_EQ(hole.columns > hole.rows, is_level);
    WorkMesh mesh = shapes::nodes_on(made.domain, made.plans.counts.raw());
    EXPECT_TRUE(fill_grid(mesh, made.domain, kCell, made.plan()));
  }
}

// Only where more than one ring can give way may a patch reach from wall to wall.
TEST(PlanGrids, NoSingleRingReachesFromWallToWall) {
  EXPECT_FALSE(planned(shapes::arranged(shapes::plate_model(12, 3, {{6, 1.5}}, 1))).plans.cells[kCell]);
  const Planned small = planned(shapes::arranged(shapes::plate_model(12, 2, {{6, 1}}, 0.2)));
  ASSERT_TRUE(small.plans.cells[kCell]);
  EXPECT_EQ(small.plan().holes.at(0).rows, small.plan().rows);
  EXPECT_GT(small.plan().holes.at(0).rings, 1);
}

// The rings beyond the first come with the hole: the plate keeps its size.
TEST(PlanGrids, SmallHolesDoNotThinOutThePlate) {
  const Planned made = planned(shapes::arranged(shapes::plate_model(6, 10, {{3, 1}, {3, 9}}, 0.15)));
  ASSERT_TRUE(made.plans.cells[kCell]);
  EXPECT_EQ(made.plan().holes[0].rings, 3);
  EXPECT_EQ(made.plan().columns, 6);
  EXPECT_GE(made.plan().rows, 9);  // 10 by the size, less what the first rings take
}

TEST(PlanGrids, TakesTheProposalThatCostsLeast) {
  const Domain domain = shapes::arranged(shapes::plate_model(16, 12, {{8, 6}}, 2));
  std::set<int> asked;
  const auto dear_by_columns = [&](const Domain&, CellId, const GridProposal& proposal) {
    asked.insert(proposal.plan.columns * proposal.plan.rows);
    return static_cast<double>(proposal.plan.columns * proposal.plan.rows);
  };
  const Planned least = planned(domain, dear_by_columns);
  EXPECT_GT(asked.size(), 1u);
  EXPECT_EQ(least.plan().columns * least.plan().rows, *asked.begin());
  const Planned most = planned(domain, [&](const Domain& d, CellId c, const GridProposal& proposal) {
    return -dear_by_columns(d, c, proposal);
  });
  EXPECT_EQ(most.plan().columns * most.plan().rows, *asked.rbegin());
}

TEST(PlanGrids, ProposalsAreShownInTheDomainThatTheyWant) {
  const Domain domain = shapes::arranged(shapes::plate_model(16, 12, {{8, 6}}, 2));
  int n = 0;
  planned(domain, [&](const Domain& turned, CellId c, const GridProposal&) {
    ++n;
    for (const DirectedCurve& d : turned.cells[c].walks[1]) {
      EXPECT_TRUE(turned.curves[d.curve].has_rings);
      EXPECT_NEAR(std::abs(turned.curves[d.curve].piece.a.x - 8), std::sqrt(2), 1e-12);
    }
    return 0;
  });
  EXPECT_GT(n, 1);
  EXPECT_LE(n, kProposals);
}

TEST(PlanGrids, WhereNoneWillDoTheDomainIsAsItWas) {
  const Domain domain = shapes::arranged(shapes::plate_model(16, 12, {{8, 6}}, 2));
  const Planned made = planned(domain, [](const Domain&, CellId, const GridProposal&) { return kInfinity; });
  EXPECT_FALSE(made.plans.cells[kCell]);
  for (std::size_t i = 0; i < domain.curves.count(); ++i) {
    const CurveId c(i);
    EXPECT_EQ(made.plans.counts[c], 0u);
    EXPECT_FALSE(made.domain.curves[c].has_rings);
    EXPECT_NEAR(distance(made.domain.curves[c].piece.a, domain.curves[c].piece.a), 0, 1e-12);
    EXPECT_NEAR(made.domain.curves[c].piece.sweep, domain.curves[c].piece.sweep, 1e-12);
  }
}

TEST(PlanGrids, NotWhereSizesWouldHaveToGrade) {
  const Model plate = shapes::plate_model(16, 12, {{5, 6}}, 1.5);
  ASSERT_TRUE(planned(shapes::arranged(plate)).plans.cells[kCell]);
  Model fine_line = plate;
  fine_line.lines.push_back({.name = "weld", .path = {.items = {{{9, 0}}, {{9, 12}}}}, .size = 0.4});
  Model fine_region = plate;
  fine_region.lines.push_back({.name = "cut", .path = {.items = {{{9, 0}}, {{9, 12}}}}});
  Model same_region = fine_region;
  fine_region.regions.push_back({.name = "fine", .at = {12, 6}, .size = 0.4});
  Model with_point = plate;
  with_point.points.push_back({.name = "lug", .at = {11, 6}});
  const auto any = [](const Planned& made) {
    return std::any_of(made.plans.cells.begin(), made.plans.cells.end(),
                       [](const auto& plan) { return plan.has_value(); });
  };
  EXPECT_TRUE(any(planned(shapes::arranged(same_region))));
  EXPECT_FALSE(any(planned(shapes::arranged(fine_line))));
  EXPECT_FALSE(any(planned(shapes::arranged(fine_region))));
  EXPECT_FALSE(any(planned(shapes::arranged(with_point))));
}

TEST(PlanGrids, NotWhereAFunctionGivesSizes) {
  const Domain domain = shapes::arranged(shapes::plate_model(16, 12, {{5, 6}}, 1.5));
  ASSERT_TRUE(planned(domain).plans.cells[kCell]);
  EXPECT_FALSE(planned(domain, free_of_charge, {.size_at = [](Point) { return 0.7; }}).plans.cells[kCell]);
}

TEST(PlanGrids, NotWhereTheLatticeWouldBeTooLarge) {
  const Domain thin = shapes::arranged(shapes::plate_model(3e7, 0.02, {{7, 0.01}}, 0.004));
  int n_shown = 0;
  const auto count = [&](const Domain&, CellId, const GridProposal&) { return ++n_shown, kInfinity; };
  planned(thin, count, {.max_quads = 1e6});
  EXPECT_EQ(n_shown, 0);
}

TEST(PlanGrids, NotForOtherShapes) {
  Model triangle;
  triangle.size = 1;
  triangle.outer.push_back({.items = {{{0, 0}}, {{16, 0}}, {{8, 14}}}});
  triangle.holes.push_back({.circle = Circle{{8, 5}, 1.5}});
  EXPECT_FALSE(planned(shapes::arranged(triangle)).plans.cells[kCell]);
  Model three_cornered = shapes::plate_model(16, 12, {}, 1);
  three_cornered.holes.push_back({.items = {{{6, 4}}, {{10, 4}}, {{8, 8}}}});
  EXPECT_FALSE(planned(shapes::arranged(three_cornered)).plans.cells[kCell]);
}

TEST(PlanGrids, NotWhereAHoleCutsTheEdge) {
  const Planned made = planned(shapes::arranged(shapes::plate_model(16, 12, {{16, 6}}, 2)));
  EXPECT_FALSE(made.plans.cells[kCell]);
}

TEST(PlanGrids, AnnulusRoundAHoleOfAGridFollowsIt) {
  // A washer of its own in a plate: the ring is a cell, and has the nodes that the plate wants.
  Model model = shapes::plate_model(24, 24, {{12, 12}}, 3);
  model.lines.push_back({.name = "pad", .path = {.circle = Circle{{12, 12}, 5}}});
  const Planned made = planned(shapes::arranged(model));
  ASSERT_EQ(made.domain.cells.count(), 2u);
  std::size_t n_polar = 0;
  for (std::size_t i = 0; i < 2; ++i) {
    ASSERT_TRUE(made.plans.cells[CellId(i)]);
    const GridPlan& plan = made.plans.cells[CellId(i)]->plan;
    if (!plan.frame.is_polar) continue;
    ++n_polar;
    const auto& walks = made.domain.cells[CellId(i)].walks;
    EXPECT_EQ(made.count(walks[0][0]), made.count(walks[plan.inner][0]));
    const CurvePiece &outer = made.domain.curves[walks[0][0].curve].piece,
                     &inner = made.domain.curves[walks[plan.inner][0].curve].piece;
    EXPECT_NEAR(std::abs(cross(outer.a - outer.center, inner.a - inner.center)), 0, 1e-9);  // on one ray
  }
  EXPECT_EQ(n_polar, 1u);
}

TEST(PlanGrids, APlanThatIsDroppedLeavesNoWish) {
  Model model = shapes::plate_model(24, 10, {{6, 5}, {18, 5.5}}, 1.5);
  model.lines.push_back({.name = "middle", .path = {.items = {{{12, 0}}, {{12, 10}}}}});
  Planned made = planned(shapes::arranged(model));
  ASSERT_EQ(made.domain.cells.count(), 2u);
  const CellId other(std::size_t{1});
  ASSERT_TRUE(made.plans.cells[other]);
  CellSet dropped;
  dropped.insert(kCell);
  made.plans.drop(dropped, made.domain);
  EXPECT_FALSE(made.plans.cells[kCell]);
  ASSERT_TRUE(made.plans.cells[other]);
  for (const auto& walk : made.domain.cells[kCell].walks)
    for (const DirectedCurve& d : walk) {
      const Domain::Curve& curve = made.domain.curves[d.curve];
      const bool is_shared = curve.left.valid() && curve.right.valid();
      EXPECT_EQ(made.count(d) > 0, is_shared);  // the other cell wishes for its own
      EXPECT_FALSE(curve.has_rings);
    }
  for (const DirectedCurve& d : made.domain.cells[other].walks[1])
    EXPECT_TRUE(made.domain.curves[d.curve].has_rings && made.count(d) > 0);
}

}  // namespace
}  // namespace quadline
