#include "stages/discretize/discretize.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <optional>
#include <random>
#include <set>
#include <utility>

#include "domain/arrange/arrange.hpp"
#include "geom/predicates.hpp"
#include "stages/discretize/metric_length.hpp"
#include "tests/unit/domain/size/size_shapes.hpp"

namespace quadline {
namespace {

constexpr double kNone = std::numeric_limits<double>::infinity();

WorkMesh nodes_of(const Domain& domain, const Options& options = {}, const CellSet& halved = {}) {
  Context context;
  return discretize(domain, make_size_field(domain, options, context), {}, halved, context);
}

CellSet all_cells(const Domain& domain) {
  CellSet cells;
  for (std::size_t i = 0; i < domain.cells.count(); ++i) cells.insert(CellId(i));
  return cells;
}

std::vector<unsigned> counts(const Domain& domain, const WorkMesh& mesh) {
  std::vector<unsigned> n(domain.curves.count(), 0);
  for (const Segment& s : mesh.segments()) ++n[s.curve.value];
  return n;
}

unsigned edges_round(const Domain::Cell& cell, const std::vector<unsigned>& n) {
  unsigned sum = 0;
  for (const auto& walk : cell.walks)
    for (const DirectedCurve& d : walk) sum += n[d.curve.value];
  return sum;
}

/// Tags, order, positions and evenness, as every discretisation promises.
void expect_sound(const Domain& domain, const WorkMesh& mesh) {
  const std::vector<unsigned> n = counts(domain, mesh);
  for (std::size_t v = 0; v < domain.vertices.count(); ++v) {
    EXPECT_EQ(mesh.tag(NodeId(v)).kind, NodeKind::Fixed);
    EXPECT_EQ(mesh.tag(NodeId(v)).vertex, VertexId(v));
    EXPECT_EQ(mesh.point(NodeId(v)), domain.vertices[VertexId(v)].at);
  }
  std::size_t k = 0;
  for (std::size_t c = 0; c < domain.curves.count(); ++c) {
    const Domain::Curve& curve = domain.curves[CurveId(c)];
    double last = 0;
    ASSERT_GE(n[c], 1u);
    EXPECT_EQ(mesh.segments()[k].a, NodeId(curve.tail.value));
    for (unsigned i = 0; i < n[c]; ++i, ++k) {
      ASSERT_EQ(mesh.segments()[k].curve, CurveId(c));
      const NodeId b = mesh.segments()[k].b;
      if (i + 1 == n[c]) {
        EXPECT_EQ(b, NodeId(curve.head.value));
        continue;
      }
      EXPECT_EQ(mesh.segments()[k + 1].a, b);
      EXPECT_EQ(mesh.tag(b).kind, NodeKind::OnCurve);
      EXPECT_EQ(mesh.tag(b).curve, CurveId(c));
      EXPECT_GT(mesh.tag(b).s, last);
      EXPECT_EQ(mesh.point(b), point_at(curve.piece, mesh.tag(b).s));
      last = mesh.tag(b).s;
    }
    EXPECT_LT(last, length(curve.piece));
  }
  EXPECT_EQ(k, mesh.segments().size());
  for (const Domain::Cell& cell : domain.cells) {
    EXPECT_EQ(edges_round(cell, n) % 2, 0u);
    EXPECT_GE(edges_round(cell, n), 4u);
  }
}

/// Segments meet at common nodes only; exact and quadratic.
void expect_no_crossing(const WorkMesh& mesh) {
  std::set<std::pair<NodeId, NodeId>> seen;
  for (std::size_t i = 0; i < mesh.segments().size(); ++i) {
    const Segment& s = mesh.segments()[i];
    EXPECT_TRUE(seen.insert(std::minmax(s.a, s.b)).second) << "two segments between the same nodes";
    const Point a = mesh.point(s.a), b = mesh.point(s.b);
    for (std::size_t j = 0; j < i; ++j) {
      const Segment& t = mesh.segments()[j];
      if (s.a == t.a || s.a == t.b || s.b == t.a || s.b == t.b) continue;
      const Point c = mesh.point(t.a), d = mesh.point(t.b);
      EXPECT_FALSE(orientation(a, b, c) * orientation(a, b, d) <= 0 &&
                   orientation(c, d, a) * orientation(c, d, b) <= 0 &&
                   orientation(a, b, c) * orientation(a, b, c) + orientation(a, b, d) * orientation(a, b, d) > 0)
          << "segments " << j << " and " << i << " cross at (" << a.x << ", " << a.y << ")";
    }
  }
}

Domain arranged(const Model& model) {
  Context context;
  return arrange(model, {}, context);
}

Model square_model(double side, double size) {
  Model model;
  model.size = size;
  model.outer.push_back({{{{0, 0}, {}}, {{side, 0}, {}}, {{side, side}, {}}, {{0, side}, {}}}, {}, ""});
  return model;
}

TEST(Discretize, RectangleGetsEqualEdgesOfTheSize) {
  const Domain domain = shapes::rectangle(4, 3, 0.5);
  const WorkMesh mesh = nodes_of(domain);
  expect_sound(domain, mesh);
  EXPECT_EQ(counts(domain, mesh), (std::vector<unsigned>{8, 6, 8, 6}));
  EXPECT_EQ(mesh.topo().node_capacity(), 28u);
  for (const Segment& s : mesh.segments()) EXPECT_DOUBLE_EQ(distance(mesh.point(s.a), mesh.point(s.b)), 0.5);
}

TEST(Discretize, TriangleOfOddSidesBecomesEvenWhereItHurtsLeast) {
  const Domain domain = shapes::Builder({{0, 0}, {9, 0}, {0, 3}}, {{0, 1}, {1, 2}, {2, 0}}, 1).build();
  const WorkMesh mesh = nodes_of(domain);
  expect_sound(domain, mesh);
  EXPECT_EQ(counts(domain, mesh), (std::vector<unsigned>{9, 10, 3}));  // 9.49 rather than 9 or 3
}

TEST(Discretize, LineInsideACellCountsTwiceAndKeepsItsCount) {
  const Domain domain =
      shapes::Builder({{0, 0}, {8, 0}, {8, 8}, {0, 8}, {2, 4}, {5, 4}}, {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {4, 5}}, 1)
          .build();
  const WorkMesh mesh = nodes_of(domain);
  expect_sound(domain, mesh);
  EXPECT_EQ(counts(domain, mesh), (std::vector<unsigned>{8, 8, 8, 8, 3}));
}

TEST(Discretize, EqualCurvesGetEqualCountsAndHolesTheirQuarters) {
  const Domain domain = shapes::square_with_hole(10, 1.5, 1);
  const WorkMesh mesh = nodes_of(domain);
  expect_sound(domain, mesh);
  EXPECT_EQ(counts(domain, mesh), (std::vector<unsigned>{10, 10, 10, 10, 6, 6}));
}

/// Chords of the arcs of a domain, in their order round one circle.
std::vector<double> chords(const Domain& domain, const WorkMesh& mesh) {
  std::vector<double> lengths;
  for (const Segment& s : mesh.segments())
    if (domain.curves[s.curve].piece.is_arc()) lengths.push_back(distance(mesh.point(s.a), mesh.point(s.b)));
  return lengths;
}

TEST(Discretize, CirclesHaveAMultipleOfFourEqualChords) {
  for (int k = 1; k < 30; ++k) {
    SCOPED_TRACE(k);
    Model model = square_model(10, 0.6);
    const double r = 0.13 * k;
    model.holes.push_back({{}, Circle{{5, 5}, r}, ""});
    if (k % 2 == 0) model.lines.push_back({"", {{{{0, 5}, {}}, {{5 - r, 5}, {}}}, {}, ""}, {}});
    if (k % 3 == 0) model.lines.push_back({"", {{{{10, 5}, {}}, {{5 + r, 5}, {}}}, {}, ""}, {}});
    const Domain domain = arranged(model);
    const CellSet all = all_cells(domain);
    for (const CellSet& halved : {CellSet(), all}) {
      const std::vector<double> lengths = chords(domain, nodes_of(domain, {}, halved));
      EXPECT_EQ(lengths.size() % 4, 0u);
      const auto [least, most] = std::minmax_element(lengths.begin(), lengths.end());
      EXPECT_LT(*most / *least, 1.01);
    }
  }
}

/// Greatest ratio of two chords that follow each other on the circle of a radius round (5, 5).
double greatest_step(const WorkMesh& mesh, double radius) {
  std::map<double, Point> round;
  for (std::size_t i = 0; i < mesh.topo().node_capacity(); ++i) {
    const Point p = mesh.point(NodeId(i)) - Point{5, 5};
    if (std::abs(norm(p) - radius) < 1e-9) round[std::atan2(p.y, p.x)] = p;
  }
  std::vector<double> lengths;
  for (auto at = round.begin(); at != round.end(); ++at) {
    const auto next = std::next(at) == round.end() ? round.begin() : std::next(at);
    lengths.push_back(distance(at->second, next->second));
  }
  double most = 1;
  for (std::size_t i = 0; i < lengths.size(); ++i) {
    const double ratio = lengths[i] / lengths[(i + 1) % lengths.size()];
    most = std::max({most, ratio, 1 / ratio});
  }
  return most;
}

// Fine at a point beside the circle, or along a line that meets it: sizes grade by 0.26, and counts are rounded.
TEST(Discretize, ChordsThatFollowEachOtherOnACircleDifferLittle) {
  for (int k = 0; k < 24; ++k) {
    SCOPED_TRACE(k);
    Model model = square_model(10, 1.2);
    model.holes.push_back({{}, Circle{{5, 5}, 1.5 + 0.06 * k}, ""});
    const Point out{std::cos(0.26 * k), std::sin(0.26 * k)};
    const double r = model.holes[0].circle->radius;
    if (k % 2 == 0) {
      model.points.push_back({"", Point{5, 5} + (r + 0.1) * out, 0.1});
    } else {
      model.lines.push_back({"", {{{Point{5, 5} + r * out, {}}, {Point{5, 5} + (r + 0.8) * out, {}}}, {}, ""}, 0.15});
    }
    EXPECT_LT(greatest_step(nodes_of(arranged(model)), r), 1.15);
  }
}

TEST(MetricLength, CrowdingChangesEdgesSmoothlyAndSymmetrically) {
  const CurvePiece arc = arc_through({1, 0}, {0, 1}, {-1, 0});
  Context context;
  const MetricLength metric(arc, make_size_field(shapes::rectangle(4, 3, 0.5), {}, context));
  const std::vector<double> places = metric.places(10, {2, 2});
  double last = 0, edge = 0;
  for (std::size_t i = 0; i < 9; ++i) {
    EXPECT_NEAR(places[i] + places[8 - i], length(arc), 1e-12);
    if (i > 0 && i < 5) {
      EXPECT_GT(places[i] - last, edge);
    }
    edge = places[i] - last;
    last = places[i];
  }
  EXPECT_NEAR(places[0], 0.05 * length(arc), 0.01 * length(arc));  // half of an equal edge
  EXPECT_EQ(metric.places(4, {})[0], 0.25 * length(arc));
}

TEST(Discretize, TinyHoleHasEightEdges) {
  const Domain domain = shapes::square_with_hole(10, 0.02, 1);
  const WorkMesh mesh = nodes_of(domain);
  expect_sound(domain, mesh);
  const std::vector<unsigned> n = counts(domain, mesh);
  EXPECT_EQ(n[4], 4u);
  EXPECT_EQ(n[5], 4u);
}

TEST(Discretize, LensOfTwoCurvesGetsFourEdges) {
  // A short chord and its flat arc: one edge each by the sizes, and those two would coincide.
  const Domain domain = shapes::Builder({{0, 0}, {10, 0}, {10, 10}, {0, 10}, {4, 5}, {5, 5}},
                                        {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {4, 5}, {4, 5, Point{4.5, 5.1}}}, 1)
                            .build();
  const WorkMesh mesh = nodes_of(domain);
  expect_sound(domain, mesh);
  expect_no_crossing(mesh);
}

TEST(Discretize, LineSizeAndGrowthHoldAlongTheCurves) {
  const double fine = 0.1;
  Domain domain = shapes::Builder({{0, 0}, {20, 0}, {20, 20}, {0, 20}, {8, 10}, {12, 10}},
                                  {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {4, 5, std::nullopt, fine}}, 1)
                      .build();
  domain.points.push_back({"corner", VertexId(0), 0.05});
  const WorkMesh mesh = nodes_of(domain);
  expect_sound(domain, mesh);
  EXPECT_NEAR(counts(domain, mesh)[4], 40, 2);
  std::map<CurveId, double> last;
  for (const Segment& s : mesh.segments()) {
    const double l = distance(mesh.point(s.a), mesh.point(s.b));
    const auto [before, is_new] = last.insert({s.curve, l});
    if (!is_new) {
      EXPECT_LE(std::max(l / before->second, before->second / l), 1.4);
      before->second = l;
    }
  }
  EXPECT_NEAR(last[CurveId(3)], 0.05, 0.015);
}

TEST(Discretize, OppositeSidesOfFourSidedCellsGetEqualCounts) {
  // A row of submappable faces between two lines that are not quite parallel; targets from 4.3 to 5.2.
  std::vector<Point> points;
  std::vector<shapes::Link> links;
  for (std::size_t i = 0; i <= 6; ++i) {
    points.push_back({4.4 * static_cast<double>(i), 0});
    points.push_back({4.4 * static_cast<double>(i), 4.3 + 0.15 * static_cast<double>(i)});
    links.push_back({2 * i, 2 * i + 1});
    if (i == 0) continue;
    links.push_back({2 * i - 2, 2 * i});
    links.push_back({2 * i - 1, 2 * i + 1});
  }
  const Domain domain = shapes::Builder(points, links, 1).build();
  ASSERT_EQ(domain.cells.count(), 6u);
  const WorkMesh mesh = nodes_of(domain);
  expect_sound(domain, mesh);
  const std::vector<unsigned> n = counts(domain, mesh);
  // Links: the first upright, then for each submappable face its right upright, floor and roof.
  for (std::size_t i = 1; i <= 6; ++i) {
    EXPECT_EQ(n[3 * i - 2], n[i == 1 ? 0 : 3 * i - 5]) << i;
    EXPECT_EQ(n[3 * i - 1], n[3 * i]) << i;
  }
}

TEST(Discretize, TheWalkOfAnLHasEqualCountsInOppositeDirections) {
  // One by one, eight edges below would round against nine above, and five on the left against six on the right.
  const Domain domain = shapes::Builder({{0, 0}, {8.4, 0}, {8.4, 2.6}, {4.8, 2.6}, {4.8, 5.2}, {0, 5.2}},
                                        {{0, 1}, {1, 2}, {2, 3}, {3, 4}, {4, 5}, {5, 0}}, 1)
                            .build();
  const WorkMesh mesh = nodes_of(domain);
  expect_sound(domain, mesh);
  const std::vector<unsigned> n = counts(domain, mesh);
  EXPECT_EQ(n[0], n[2] + n[4]);
  EXPECT_EQ(n[5], n[1] + n[3]);
}

TEST(Discretize, TheWalksOfARingHaveEqualCounts) {
  // Wishes of 25.1 and 22.0 edges; the square round them keeps out of it.
  const Domain domain = shapes::Builder({{-9, -9}, {9, -9}, {9, 9}, {-9, 9}, {-4, 0}, {4, 0}, {-3.5, 0}, {3.5, 0}},
                                        {{0, 1},
                                         {1, 2},
                                         {2, 3},
                                         {3, 0},
                                         {4, 5, Point{0, -4}},
                                         {5, 4, Point{0, 4}},
                                         {6, 7, Point{0, -3.5}},
                                         {7, 6, Point{0, 3.5}}},
                                        1)
                            .build();
  const WorkMesh mesh = nodes_of(domain);
  expect_sound(domain, mesh);
  const std::vector<unsigned> n = counts(domain, mesh);
  EXPECT_EQ(n[4] + n[5], n[6] + n[7]);
}

/// A regular polygon with sides of n edges, size 1.
Model polygon_model(int corners, double n) {
  Model model = square_model(1, 1);
  model.outer[0].items.clear();
  const double pi = std::acos(-1.0), radius = n / (2 * std::sin(pi / corners));
  for (int i = 0; i < corners; ++i)
    model.outer[0].items.push_back(
        {{radius * std::cos(2 * pi * i / corners), radius * std::sin(2 * pi * i / corners)}, {}});
  return model;
}

TEST(Discretize, PolygonsWithMoreThanFourCornersGetMoreEdges) {
  const auto count_on_a_side = [](int corners, double n) {
    const Domain domain = arranged(polygon_model(corners, n));
    const WorkMesh mesh = nodes_of(domain);
    expect_sound(domain, mesh);
    return static_cast<double>(edges_round(domain.cells[CellId(0)], counts(domain, mesh))) / corners;
  };
  // The area of a hexagon is 2.6 n^2, and 6 corners with m edges between them hold 1.5 m^2 quads.
  EXPECT_NEAR(count_on_a_side(6, 6), 6 * std::sqrt(2.6 / 1.5), 0.5);
  EXPECT_NEAR(count_on_a_side(5, 6), 6 * std::sqrt(1.72 / 1.25), 0.5);
  EXPECT_EQ(count_on_a_side(4, 6), 6);
  EXPECT_EQ(count_on_a_side(3, 6), 6);
  EXPECT_LT(count_on_a_side(6, 60), 64);  // rows begin inside instead
}

TEST(Discretize, ChordsNearOtherCurvesAreRefinedUntilTheyDoNotCross) {
  // A line passes over a large arc at a hundredth of the height of one of its chords.
  const double r = 10, h = 4;
  for (double gap : {0.2, 0.02, 0.002}) {
    const Domain domain = shapes::Builder({{-20, -20},
                                           {20, -20},
                                           {20, 20},
                                           {-20, 20},
                                           {-r, 0},
                                           {r, 0},
                                           {-8, r + gap},
                                           {8, r + gap},
                                           {-8, -r + gap},
                                           {8, -r + gap}},
                                          {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {4, 5, Point{0, r}}, {6, 7}}, h)
                              .build();
    const WorkMesh mesh = nodes_of(domain);
    expect_sound(domain, mesh);
    expect_no_crossing(mesh);
    // The concentric arc inside lies between the first one and its chords.
    const double inner = r - gap;
    const Domain rings =
        shapes::Builder({{-20, -20}, {20, -20}, {20, 20}, {-20, 20}, {-r, 0}, {r, 0}, {0, inner}, {0, -inner}},
                        {{0, 1},
                         {1, 2},
                         {2, 3},
                         {3, 0},
                         {4, 5, Point{0, r}},
                         {5, 4, Point{0, -r}},
                         {6, 7, Point{inner, 0}},
                         {7, 6, Point{-inner, 0}}},
                        h)
            .build();
    const WorkMesh ring_mesh = nodes_of(rings);
    expect_sound(rings, ring_mesh);
    expect_no_crossing(ring_mesh);
  }
}

TEST(Discretize, ChordsOfArcsThatTouchFromInsideAreRefinedUntilTheyDoNotCross) {
  // Circles of radii 4 and 3.6 that touch in (-4, 0); sizes that have nothing to do with each other.
  const Domain domain = shapes::Builder({{-9, -9}, {9, -9}, {9, 9}, {-9, 9}, {-4, 0}, {0, 4}, {-0.4, 3.6}},
                                        {{0, 1},
                                         {1, 2},
                                         {2, 3},
                                         {3, 0},
                                         {4, 5, Point{-4 * std::sqrt(0.5), 4 * std::sqrt(0.5)}},
                                         {4, 6, Point{-0.4 - 3.6 * std::sqrt(0.5), 3.6 * std::sqrt(0.5)}}},
                                        2)
                            .build();
  const WorkMesh mesh = nodes_of(domain);
  expect_sound(domain, mesh);
  expect_no_crossing(mesh);
  for (const unsigned n : counts(domain, mesh)) EXPECT_LE(n, 64u);
}

TEST(Discretize, ArcsWhoseEdgesAreHalvedKeepClearOfNodesNearThem) {
  const double r = 10, gap = 0.01;
  const Domain domain =
      shapes::Builder({{-20, -20}, {20, -20}, {20, 20}, {-20, 20}, {-r, 0}, {r, 0}, {0.3, r + gap}, {0, 15}},
                      {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {4, 5, Point{0, r}}, {6, 7}}, 4)
          .build();
  const auto bulge = [&](const CellSet& halved) {  // of the chord below the node
    const WorkMesh mesh = nodes_of(domain, {}, halved);
    expect_sound(domain, mesh);
    for (const Segment& s : mesh.segments())
      if (domain.curves[s.curve].piece.is_arc() && (mesh.point(s.a).x < 0.3) != (mesh.point(s.b).x < 0.3))
        return r - norm(midpoint(mesh.point(s.a), mesh.point(s.b)));
    return kNone;
  };
  EXPECT_GT(bulge({}), gap);
  EXPECT_LE(bulge(all_cells(domain)), gap / 2);
}

/// Lines, arcs and circles on a small grid, where everything meets everything.
Domain random_domain(unsigned seed) {
  std::mt19937 random(seed);
  const auto coordinate = [&] { return 0.25 * static_cast<double>(random() % 81); };
  Model model = square_model(20, 1 + 0.5 * static_cast<double>(seed % 4));
  for (unsigned i = 0; i < 4 + seed % 9; ++i) {
    Line line{"line", {}, {}};
    if (seed % 3 == 0) line.size = 0.3 + 0.2 * static_cast<double>(random() % 5);
    if (i % 4 == 3) {
      line.path.circle = Circle{{5 + 0.5 * coordinate(), 5 + 0.5 * coordinate()}, 0.5 + 0.2 * coordinate()};
    } else {
      line.path.items = {{{coordinate(), coordinate()}, {}}, {{coordinate(), coordinate()}, {}}};
      if (i % 4 == 2) line.path.items[1].via = Point{coordinate(), coordinate()};
    }
    model.lines.push_back(line);
  }
  return arranged(model);
}

TEST(Discretize, HalvedCellsGetHalfTheEdgesAndTheOthersStayEven) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    SCOPED_TRACE(seed);
    const Domain domain = random_domain(seed);
    Context context;
    CellSet halved;
    for (std::size_t i = 0; i < domain.cells.count(); i += 3) halved.insert(CellId(i));
    std::vector<unsigned> n = counts(domain, nodes_of(domain, {}, halved));
    for (const CurveId c : curves_round(domain, halved)) {
      const double length = MetricLength(domain.curves[c].piece, make_size_field(domain, {}, context)).total();
      n[c.value] *= 2;  // as other cells see them
      EXPECT_GE(n[c.value], std::floor(length / 1.5));
    }
    for (std::size_t i = 0; i < domain.cells.count(); ++i) {
      const unsigned sum = edges_round(domain.cells[CellId(i)], n);
      EXPECT_EQ(sum % 2, 0u);
      EXPECT_GE(sum, halved.contains(CellId(i)) ? 8u : 4u);
    }
  }
}

TEST(Discretize, WhereAllCellsAreHalvedTheirEdgesBeforeAreEvenInNumber) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    SCOPED_TRACE(seed);
    const Domain domain = random_domain(seed);
    const WorkMesh mesh = nodes_of(domain, {}, all_cells(domain));
    expect_sound(domain, mesh);
    EXPECT_LT(mesh.segments().size(), nodes_of(domain).segments().size());
  }
}

TEST(Discretize, LonePointsAreFixedNodes) {
  Domain domain = shapes::rectangle(10, 10, 1);
  const VertexId v = domain.vertices.push_back({{4, 5}});
  domain.cells[CellId(0)].lone_points.push_back(v);
  domain.points.push_back({"load", v, kNone});
  const WorkMesh mesh = nodes_of(domain);
  expect_sound(domain, mesh);
  EXPECT_EQ(mesh.topo().node_capacity(), 41u);
}

TEST(Discretize, RandomArrangementsAreEvenEverywhereAndCrossNowhere) {
  for (unsigned seed = 0; seed < 40; ++seed) {
    SCOPED_TRACE(seed);
    const Domain domain = random_domain(seed);
    const WorkMesh mesh = nodes_of(domain);
    expect_sound(domain, mesh);
    expect_no_crossing(mesh);
  }
}

TEST(Discretize, ScalingByAPowerOfTwoScalesEveryNode) {
  Domain domain = shapes::square_with_hole(10, 0.3, 1);
  domain.curves[CurveId(2)].size = 0.21;
  const WorkMesh mesh = nodes_of(domain);
  for (int k : {-40, -1, 7}) {
    const double factor = std::ldexp(1.0, k);
    const WorkMesh other = nodes_of(shapes::scaled(domain, factor));
    ASSERT_EQ(other.topo().node_capacity(), mesh.topo().node_capacity());
    for (std::size_t i = 0; i < mesh.topo().node_capacity(); ++i)
      ASSERT_EQ(other.point(NodeId(i)), factor * mesh.point(NodeId(i)));
  }
}

// A plate with a hole of radius 2 and two rings 0.5 wide.
Domain ringed_plate(std::uint32_t edges) {
  Model model;
  model.size = 1;
  model.outer.push_back({.items = {{{0, 0}}, {{20, 0}}, {{20, 12}}, {{0, 12}}}});
  model.holes.push_back({.circle = Circle{{10, 6}, 2, edges, 2, 0.5}});
  Context context;
  return arrange(model, {}, context);
}

// Edges on arcs of a radius.
unsigned edges_round(const Domain& domain, const WorkMesh& mesh, double radius) {
  const std::vector<unsigned> n = counts(domain, mesh);
  unsigned sum = 0;
  for (std::size_t i = 0; i < n.size(); ++i)
    if (domain.curves[CurveId(i)].piece.radius == radius) sum += n[i];
  return sum;
}

TEST(GivenEdges, AreHeldOnBothCirclesOfRings) {
  for (const unsigned edges : {4u, 6u, 8u, 22u, 24u, 60u}) {
    const Domain domain = ringed_plate(edges);
    const WorkMesh mesh = nodes_of(domain);
    expect_sound(domain, mesh);
    for (const double radius : {2.0, 3.0}) EXPECT_EQ(edges_round(domain, mesh, radius), edges);
  }
}

TEST(GivenEdges, HaveTheirNodesOnCommonRays) {
  const WorkMesh mesh = nodes_of(ringed_plate(22));
  std::map<long, int> rays;
  for (const NodeId v : mesh.topo().nodes()) {
    const Point from = mesh.point(v) - Point{10, 6};
    if (norm(from) > 3.1) continue;
    const double ray = std::atan2(from.y, from.x) / (2 * std::numbers::pi) * 22;
    EXPECT_NEAR(ray, std::round(ray), 1e-9);
    ++rays[std::lround(ray + 22) % 22];
  }
  EXPECT_EQ(rays.size(), 22u);
  for (const auto& [ray, n] : rays) EXPECT_EQ(n, 2) << ray;
}

TEST(GivenEdges, AreHalfBeforeAllAreHalved) {
  const Domain domain = ringed_plate(24);
  const WorkMesh mesh = nodes_of(domain, {}, all_cells(domain));
  for (const double radius : {2.0, 3.0}) EXPECT_EQ(edges_round(domain, mesh, radius), 12u);
}

}  // namespace
}  // namespace quadline
