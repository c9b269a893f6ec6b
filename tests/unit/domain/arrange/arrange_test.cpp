#include "domain/arrange/arrange.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <set>

namespace quadline {
namespace {

constexpr double kPi = std::numbers::pi;

Path path(std::vector<Point> points) {
  Path out;
  for (const Point p : points) out.items.push_back({p, {}});
  return out;
}

Path circle(Point center, double radius) {
  Path out;
  out.circle = Circle{center, radius};
  return out;
}

Line line(std::vector<Point> points, std::string name = "") { return {std::move(name), path(std::move(points)), {}}; }

/// A plate of 10 x 6 with its lower left corner at the origin.
Model plate() {
  Model model;
  model.size = 1;
  model.file = "plate.json";
  model.outer = {path({{0, 0}, {10, 0}, {10, 6}, {0, 6}})};
  model.outer[0].where = "/outer";
  return model;
}

Domain arranged(const Model& model, const Options& options = {}) {
  Context context;
  return arrange(model, options, context);
}

double area_under(const CurvePiece& piece) {
  double twice = cross(piece.a, piece.b);
  if (piece.is_arc()) twice += piece.radius * piece.radius * (piece.sweep - std::sin(piece.sweep));
  return 0.5 * twice;
}

double area(const Domain& domain, const std::vector<DirectedCurve>& walk) {
  double sum = 0;
  for (const DirectedCurve& use : walk) {
    const double under = area_under(domain.curves[use.curve].piece);
    sum += use.reversed ? -under : under;
  }
  return sum;
}

double area(const Domain& domain) {
  double sum = 0;
  for (const Domain::Cell& cell : domain.cells) {
    for (const auto& walk : cell.walks) sum += area(domain, walk);
  }
  return sum;
}

VertexId tail(const Domain& domain, const DirectedCurve& use) {
  const Domain::Curve& curve = domain.curves[use.curve];
  return use.reversed ? curve.head : curve.tail;
}

VertexId head(const Domain& domain, const DirectedCurve& use) { return tail(domain, {use.curve, !use.reversed}); }

/// What holds for every arrangement.
void expect_sound(const Domain& domain) {
  std::vector<int> uses(2 * domain.curves.count(), 0);
  for (std::size_t c = 0; c < domain.cells.count(); ++c) {
    const Domain::Cell& cell = domain.cells[CellId(c)];
    ASSERT_FALSE(cell.walks.empty());
    EXPECT_GT(area(domain, cell.walks[0]), 0);
    for (std::size_t w = 0; w < cell.walks.size(); ++w) {
      const auto& walk = cell.walks[w];
      if (w > 0) {
        EXPECT_LE(area(domain, walk), domain.tolerance);
      }
      for (std::size_t i = 0; i < walk.size(); ++i) {
        EXPECT_EQ(head(domain, walk[i]), tail(domain, walk[(i + 1) % walk.size()]));
        const Domain::Curve& curve = domain.curves[walk[i].curve];
        EXPECT_EQ(walk[i].reversed ? curve.right : curve.left, CellId(c));
        ++uses[2 * walk[i].curve.value + (walk[i].reversed ? 1 : 0)];
      }
    }
  }
  for (std::size_t i = 0; i < domain.curves.count(); ++i) {
    const Domain::Curve& curve = domain.curves[CurveId(i)];
    EXPECT_NE(curve.tail, curve.head);
    EXPECT_EQ(curve.piece.a, domain.vertices[curve.tail].at);
    EXPECT_EQ(curve.piece.b, domain.vertices[curve.head].at);
    EXPECT_TRUE(curve.left.valid() || curve.right.valid());
    EXPECT_EQ(uses[2 * i], curve.left.valid() ? 1 : 0);
    EXPECT_EQ(uses[2 * i + 1], curve.right.valid() ? 1 : 0);
  }
  for (std::size_t i = 0; i < domain.vertices.count(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      EXPECT_GT(distance(domain.vertices[VertexId(i)].at, domain.vertices[VertexId(j)].at), domain.tolerance);
    }
  }
}

bool has_vertex(const Domain& domain, Point p) {
  return std::any_of(domain.vertices.begin(), domain.vertices.end(),
                     [p](const Domain::Vertex& v) { return v.at == p; });
}

std::size_t count_findings(const Domain& domain, const std::string& text) {
  return static_cast<std::size_t>(std::count_if(domain.findings.begin(), domain.findings.end(), [&](const Finding& f) {
    return f.text.find(text) != std::string::npos;
  }));
}

std::string error_of(const Model& model, const Options& options = {}) {
  try {
    arranged(model, options);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

TEST(Arrange, KeepsAPlainPlate) {
  const Domain domain = arranged(plate());
  expect_sound(domain);
  EXPECT_EQ(domain.vertices.count(), 4u);
  EXPECT_EQ(domain.curves.count(), 4u);
  ASSERT_EQ(domain.cells.count(), 1u);
  EXPECT_DOUBLE_EQ(area(domain), 60);
  EXPECT_EQ(domain.paths[0].name, "outer-1");
  EXPECT_EQ(domain.paths[0].curves.size(), 4u);
  EXPECT_TRUE(domain.findings.empty());
  EXPECT_NEAR(domain.tolerance, 8e-7 * std::sqrt(136.0), 1e-12);
}

TEST(Arrange, TakesLoopsInEitherDirection) {
  Model model = plate();
  std::reverse(model.outer[0].items.begin(), model.outer[0].items.end());
  const Domain domain = arranged(model);
  expect_sound(domain);
  EXPECT_DOUBLE_EQ(area(domain), 60);
}

TEST(Arrange, CutsCrossingLinesIntoFourCells) {
  Model model = plate();
  model.lines = {line({{5, 0}, {5, 6}}, "up"), line({{0, 3}, {10, 3}}, "across")};
  const Domain domain = arranged(model);
  expect_sound(domain);
  EXPECT_EQ(domain.cells.count(), 4u);
  EXPECT_EQ(domain.vertices.count(), 9u);
  EXPECT_TRUE(has_vertex(domain, {5, 3}));
  EXPECT_EQ(domain.paths[1].name, "up");
  ASSERT_EQ(domain.paths[1].curves.size(), 2u);
  EXPECT_EQ(domain.vertices[tail(domain, domain.paths[1].curves[0])].at, (Point{5, 0}));
}

TEST(Arrange, WalksALineThatEndsInsideOnBothSides) {
  Model model = plate();
  model.lines = {line({{0, 3}, {4, 3}, {6, 4}})};
  const Domain domain = arranged(model);
  expect_sound(domain);
  ASSERT_EQ(domain.cells.count(), 1u);
  EXPECT_EQ(domain.cells[CellId(0)].walks.size(), 1u);
  EXPECT_EQ(domain.cells[CellId(0)].walks[0].size(), 5u + 2 * 2u);
  EXPECT_EQ(domain.paths[1].name, "line-1");
}

TEST(Arrange, GivesAFreeLineAWalkOfItsOwn) {
  Model model = plate();
  model.lines = {line({{2, 3}, {8, 3}})};
  const Domain domain = arranged(model);
  expect_sound(domain);
  ASSERT_EQ(domain.cells[CellId(0)].walks.size(), 2u);
  EXPECT_EQ(domain.cells[CellId(0)].walks[1].size(), 2u);
}

TEST(Arrange, SplitsAWholeCircleInTwoHalves) {
  Model model = plate();
  model.holes = {circle({5, 3}, 1)};
  const Domain domain = arranged(model);
  expect_sound(domain);
  ASSERT_EQ(domain.paths[1].curves.size(), 2u);
  for (const DirectedCurve& use : domain.paths[1].curves) {
    EXPECT_NEAR(std::abs(domain.curves[use.curve].piece.sweep), kPi, 1e-12);
  }
  EXPECT_NEAR(area(domain), 60 - kPi, 1e-12);
}

TEST(Arrange, MovesTheOwnVertexOfACircleOppositeToItsOnlyOther) {
  Model model = plate();
  model.holes = {circle({5, 3}, 1)};
  model.lines = {line({{5, 4}, {5, 6}})};
  const Domain domain = arranged(model);
  expect_sound(domain);
  EXPECT_EQ(domain.paths[1].curves.size(), 2u);
  EXPECT_FALSE(has_vertex(domain, {6, 3}));
  EXPECT_TRUE(has_vertex(domain, {5, 2}));
}

TEST(Arrange, DropsTheOwnVerticesOfACircleThatHasOthers) {
  Model model = plate();
  model.holes = {circle({5, 3}, 1)};
  model.lines = {line({{0, 3.5}, {10, 3.5}})};
  const Domain domain = arranged(model);
  expect_sound(domain);
  EXPECT_EQ(domain.paths[1].curves.size(), 2u);
  EXPECT_FALSE(has_vertex(domain, {6, 3}));
  EXPECT_FALSE(has_vertex(domain, {4, 3}));
  EXPECT_EQ(domain.cells.count(), 2u);
  EXPECT_EQ(domain.paths[2].curves.size(), 2u) << "the part in the hole is trimmed";
  EXPECT_EQ(count_findings(domain, "line 'line-1' leaves the domain: trimmed"), 1u);
  for (const Domain::Curve& curve : domain.curves) {
    if (curve.piece.is_arc()) {
      EXPECT_EQ(curve.piece.radius, 1);
    }
  }
}

TEST(Arrange, KeepsARealVertexOfALoopWhereItLies) {
  Model model = plate();
  model.holes = {circle({5, 3}, 1)};
  model.points = {{"p", {6, 3}, {}, ""}};
  const Domain domain = arranged(model);
  EXPECT_EQ(domain.vertices[domain.points[0].vertex].at, (Point{6, 3}));
  EXPECT_EQ(domain.paths[1].curves.size(), 2u);
}

TEST(Arrange, MeetsALineThatEndsOnAnArcToRounding) {
  Model model = plate();
  model.holes = {circle({5, 3}, 1)};
  const double c = std::sqrt(0.5);
  model.lines = {line({{5 + c + 3e-9, 3 + c - 2e-9}, {9, 5}}), line({{5, 2 - 3e-9}, {5, 0}}),
                 line({{10, 3 + 1e-8}, {7, 3}})};
  const Domain domain = arranged(model);
  expect_sound(domain);
  EXPECT_EQ(domain.paths[1].curves.size(), 2u);
  ASSERT_EQ(domain.cells.count(), 1u);
  EXPECT_EQ(domain.cells[CellId(0)].walks.size(), 1u) << "the hole hangs on the boundary by its line";
  EXPECT_TRUE(has_vertex(domain, {5 + c + 3e-9, 3 + c - 2e-9})) << "corners of the model stay";
}

TEST(Arrange, CutsALineTangentToACircleOnce) {
  for (const double gap : {0.0, 1e-9, -1e-9, 4e-7, -4e-7}) {
    Model model = plate();
    model.holes = {circle({5, 3}, 1)};
    model.lines = {line({{1, 4 + gap}, {9, 4 + gap}})};
    const Domain domain = arranged(model);
    expect_sound(domain);
    EXPECT_EQ(domain.paths[2].curves.size(), 2u) << gap;
    EXPECT_EQ(domain.cells.count(), 1u) << gap;
    EXPECT_NEAR(area(domain), 60 - kPi, 1e-5) << gap;
  }
}

TEST(Arrange, CutsArcsThatTouchFromInsideAndOutsideOnce) {
  Model model = plate();
  model.holes = {circle({5, 3}, 1)};
  model.lines.resize(2);
  model.lines[0].path = circle({5, 2.5}, 1.5);
  model.lines[1].path = circle({7, 3}, 1);
  const Domain domain = arranged(model);
  expect_sound(domain);
  EXPECT_TRUE(domain.findings.empty());
  EXPECT_NEAR(area(domain), 60 - kPi, 1e-9);
}

TEST(Arrange, CutsCrossingCirclesInTwoPlaces) {
  Model model = plate();
  model.lines.resize(2);
  model.lines[0].path = circle({4, 3}, 1.5);
  model.lines[1].path = circle({6, 3}, 1.5);
  const Domain domain = arranged(model);
  expect_sound(domain);
  EXPECT_EQ(domain.cells.count(), 4u);
  EXPECT_EQ(domain.curves.count(), 4u + 4u) << "only the crossings are left on the circles";
}

TEST(Arrange, MergesRepeatedAndOverlappingLines) {
  Model model = plate();
  model.lines = {line({{1, 3}, {5, 3}}, "a"), line({{5, 3}, {1, 3}}, "a-reversed"), line({{3, 3}, {7, 3}}, "b"),
                 line({{1, 3}, {5, 3}}, "a")};
  const Domain domain = arranged(model);
  expect_sound(domain);
  EXPECT_EQ(domain.curves.count(), 4u + 3u);
  EXPECT_EQ(domain.paths[1].curves.size(), 2u);
  EXPECT_TRUE(domain.paths[2].curves[0].reversed);
  EXPECT_EQ(domain.paths[3].curves.size(), 2u);
  EXPECT_EQ(domain.paths[4].name, "a-2");
  EXPECT_EQ(count_findings(domain, "'b' runs along 'a': one curve for both"), 1u);
  EXPECT_EQ(count_findings(domain, "given twice"), 1u);
}

TEST(Arrange, TakesALineAlongTheBoundaryAndAlongAHole) {
  Model model = plate();
  model.holes = {circle({5, 3}, 1)};
  model.lines.resize(2);
  model.lines[0] = line({{2, 0}, {4, 0}}, "foot");
  model.lines[0].size = 0.25;
  model.lines[1].name = "rim";
  model.lines[1].path.items = {{{6, 3}, {}}, {{5, 4}, Point{5 + std::sqrt(0.5), 3 + std::sqrt(0.5)}}};
  const Domain domain = arranged(model);
  expect_sound(domain);
  EXPECT_EQ(domain.cells.count(), 1u);
  ASSERT_EQ(domain.paths[2].curves.size(), 1u);
  const Domain::Curve& foot = domain.curves[domain.paths[2].curves[0].curve];
  EXPECT_TRUE(foot.is_boundary());
  EXPECT_EQ(foot.size, 0.25);
  ASSERT_EQ(domain.paths[3].curves.size(), 1u);
  EXPECT_TRUE(domain.curves[domain.paths[3].curves[0].curve].is_boundary());
  EXPECT_TRUE(std::isinf(domain.curves[domain.paths[3].curves[0].curve].size));
}

TEST(Arrange, DropsRepeatedPointsAndLinesWithoutLength) {
  Model model = plate();
  model.outer[0] = path({{0, 0}, {10, 0}, {10, 0}, {10, 6}, {0, 6}, {0, 0}});
  model.lines = {line({{2, 2}, {2, 2}, {4, 4}}, "twice"), line({{7, 3}, {7, 3}}, "nothing")};
  const Domain domain = arranged(model);
  expect_sound(domain);
  EXPECT_EQ(domain.vertices.count(), 6u);
  EXPECT_EQ(domain.paths.size(), 3u);
  EXPECT_TRUE(domain.paths[2].curves.empty());
  EXPECT_EQ(count_findings(domain, "'outer-1' has 1 repeated point: dropped"), 1u);
  EXPECT_EQ(count_findings(domain, "'nothing' has no length: dropped"), 1u);
}

TEST(Arrange, TrimsLinesOutsideAndForgetsWhereTheyTouch) {
  Model model = plate();
  model.lines = {line({{-2, 3}, {12, 3}}, "through"), line({{11, 0}, {11, 6}}, "beside"),
                 line({{5, 8}, {7, 6}, {9, 8}}, "outside")};
  model.lines[0].path.where = "/lines/0/path";
  const Domain domain = arranged(model);
  expect_sound(domain);
  EXPECT_EQ(domain.cells.count(), 2u);
  EXPECT_EQ(domain.paths[1].curves.size(), 1u);
  EXPECT_TRUE(domain.paths[2].curves.empty());
  EXPECT_EQ(count_findings(domain, "line 'through' leaves the domain: trimmed"), 1u);
  EXPECT_EQ(count_findings(domain, "line 'beside' lies outside the domain: dropped"), 1u);
  const auto through = std::find_if(domain.findings.begin(), domain.findings.end(),
                                    [](const Finding& f) { return f.text.find("through") != std::string::npos; });
  EXPECT_EQ(through->place, "/lines/0/path");
  EXPECT_EQ(through->at, (Point{0, 3}));
}

TEST(Arrange, PutsAnIslandInAHole) {
  Model model = plate();
  model.holes = {path({{2, 1}, {8, 1}, {8, 5}, {2, 5}})};
  model.outer.push_back(path({{4, 2}, {6, 2}, {6, 4}, {4, 4}}));
  model.regions = {{"island", {5, 3}, {}, ""}, {"void", {3, 3}, {}, ""}};
  const Domain domain = arranged(model);
  expect_sound(domain);
  ASSERT_EQ(domain.cells.count(), 2u);
  EXPECT_DOUBLE_EQ(area(domain), 60 - 24 + 4);
  EXPECT_EQ(domain.regions.size(), 2u);
  EXPECT_EQ(count_findings(domain, "region 'void' lies outside the domain"), 1u);
}

TEST(Arrange, TakesSeveralLoopsApartAndTouchingAtAPoint) {
  Model model = plate();
  model.outer.push_back(path({{10, 6}, {12, 6}, {12, 8}}));
  model.outer.push_back(path({{20, 0}, {22, 0}, {22, 2}}));
  model.holes = {path({{5, 0}, {6, 2}, {4, 2}})};
  const Domain domain = arranged(model);
  expect_sound(domain);
  EXPECT_EQ(domain.cells.count(), 3u);
  EXPECT_DOUBLE_EQ(area(domain), 60 + 2 + 2 - 2);
  EXPECT_EQ(count_findings(domain, "'outer-2' touches 'outer-1'"), 1u);
  EXPECT_EQ(count_findings(domain, "'hole-1' touches 'outer-1'"), 1u);
}

TEST(Arrange, CutsAwayHolesThatReachOverTheEdge) {
  Model model = plate();
  model.holes = {path({{4, -1}, {6, -1}, {6, 2}, {4, 2}}), path({{5, 1}, {7, 1}, {7, 3}, {5, 3}})};
  const Domain domain = arranged(model);
  expect_sound(domain);
  EXPECT_DOUBLE_EQ(area(domain), 60 - 4 - 3);
  EXPECT_EQ(count_findings(domain, "reaches over another loop"), 2u);
  for (const Finding& finding : domain.findings)
    EXPECT_EQ(finding.is_loss, finding.text.find("reaches") != std::string::npos);
}

TEST(Arrange, MakesVerticesOfPoints) {
  Model model = plate();
  model.lines = {line({{2, 3}, {8, 3}})};
  model.points = {{"on-line", {4, 3 + 1e-9}, 0.5, ""}, {"on-edge", {10, 1}, {}, ""}, {"inside", {5, 5}, {}, ""},
                  {"again", {5, 5 + 1e-8}, {}, ""},    {"away", {20, 5}, {}, ""},    {"corner", {0, 0}, {}, ""}};
  const Domain domain = arranged(model);
  expect_sound(domain);
  ASSERT_EQ(domain.points.size(), 5u);
  EXPECT_EQ(domain.vertices[domain.points[0].vertex].at, (Point{4, 3 + 1e-9}));
  EXPECT_EQ(domain.points[0].size, 0.5);
  EXPECT_EQ(domain.points[2].vertex, domain.points[3].vertex);
  EXPECT_EQ(domain.paths[1].curves.size(), 2u);
  ASSERT_EQ(domain.cells.count(), 1u);
  EXPECT_EQ(domain.cells[CellId(0)].lone_points, (std::vector<VertexId>{domain.points[2].vertex}));
  EXPECT_EQ(count_findings(domain, "point 'away' lies outside the domain: dropped"), 1u);
  EXPECT_EQ(count_findings(domain, "points 'inside' and 'again' are one"), 1u);
}

TEST(Arrange, NamesAndSizesCells) {
  Model model = plate();
  model.lines = {line({{5, 0}, {5, 6}})};
  model.regions = {{"left", {1, 1}, 0.5, ""}, {"late", {2, 2}, {}, ""}};
  Options options;
  options.size = 2;
  const Domain domain = arranged(model, options);
  ASSERT_EQ(domain.cells.count(), 2u);
  EXPECT_EQ(domain.regions, (std::vector<std::string>{"domain", "left"}));
  std::multiset<double> sizes = {domain.cells[CellId(0)].size, domain.cells[CellId(1)].size};
  EXPECT_EQ(sizes, (std::multiset<double>{0.5, 2}));
  EXPECT_EQ(domain.size, 2);
  EXPECT_EQ(count_findings(domain, "regions 'left' and 'late' lie in one cell"), 1u);
}

TEST(Arrange, NestsClosedLineLoops) {
  Model model = plate();
  model.lines.resize(3);
  model.lines[0].path = circle({5, 3}, 2);
  model.lines[1].path = circle({5, 3}, 1);
  model.lines[2] = line({{4.8, 2.8}, {5.2, 2.8}, {5, 3.2}, {4.8, 2.8}});
  const Domain domain = arranged(model);
  expect_sound(domain);
  EXPECT_EQ(domain.cells.count(), 4u);
  EXPECT_NEAR(area(domain), 60, 1e-12);
}

TEST(Arrange, TakesAnArcThatHardlyBendsAsStraight) {
  Model model = plate();
  model.lines.resize(1);
  model.lines[0].path.items = {{{1, 3}, {}}, {{9, 3}, Point{5, 3 + 1e-12}}};
  const Domain domain = arranged(model);
  EXPECT_FALSE(domain.curves[domain.paths[1].curves[0].curve].piece.is_arc());
}

TEST(Arrange, TellsWhereALineCrossesTheBoundary) {
  Model model = plate();
  model.lines = {line({{5, -4}, {5, -2}, {5, 3}}, "in"), line({{7, 3}, {7, 9}}, "out"),
                 line({{12, 1}, {12, 2}, {12, 3}}, "beside")};
  const Domain domain = arranged(model);
  ASSERT_EQ(domain.findings.size(), 3u);
  EXPECT_EQ(domain.findings[0].at, (Point{5, 0}));
  EXPECT_EQ(domain.findings[1].at, (Point{7, 6}));
  EXPECT_EQ(domain.findings[2].at, (Point{12, 1}));
}

TEST(Arrange, TellsOfAnArcWhoseMiddleIsItsEnd) {
  for (const Point via : {Point{1, 1}, Point{4, 1}, Point{4, 1 + 1e-7}}) {
    Model model = plate();
    model.lines = {line({{1, 1}, {4, 1}}, "flat")};
    model.lines[0].path.items[1].via = via;
    EXPECT_EQ(count_findings(arranged(model), "an arc's middle point lies at its end"), 1u);
  }
}

TEST(ArrangeErrors, SayWhatAndWhere) {
  Model model = plate();
  model.size = 0;
  EXPECT_NE(error_of(model).find("size of the model is not a positive number"), std::string::npos);
  model = plate();
  model.outer.clear();
  EXPECT_NE(error_of(model).find("no outer loop"), std::string::npos);
  model = plate();
  model.outer[0] = path({{0, 0}, {5, 5}, {10, 10}});
  EXPECT_NE(error_of(model).find("loop 'outer-1' has no area"), std::string::npos);
  model = plate();
  model.outer[0].items[2].to.x = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NE(error_of(model).find("not a finite number"), std::string::npos);
  EXPECT_NE(error_of(model).find("/outer/2"), std::string::npos);
  model = plate();
  model.lines = {line({{1, 1}, {1e70, 1}})};
  EXPECT_NE(error_of(model).find("larger than 1e60"), std::string::npos);
  model = plate();
  model.holes = {circle({30, 3}, 1)};
  EXPECT_NE(error_of(model).find("loop 'hole-1' lies outside every outer loop"), std::string::npos);
  model = plate();
  model.holes = {path({{-1, -1}, {11, -1}, {11, 7}, {-1, 7}})};
  EXPECT_NE(error_of(model).find("nothing is left of the domain: the holes cover it all"), std::string::npos);
}

TEST(ArrangeErrors, NameTheMeetingOfBadLoops) {
  Model model = plate();
  model.outer[0] = path({{0, 0}, {10, 6}, {10, 0}, {0, 4}});
  EXPECT_NE(error_of(model).find("loop 'outer-1' crosses itself"), std::string::npos);
  model.outer[0] = path({{0, 0}, {4, 4}, {4, 0}, {0, 4}});  // its halves cancel out
  EXPECT_NE(error_of(model).find("loop 'outer-1' crosses itself"), std::string::npos);
  EXPECT_NE(error_of(model).find(" at (2, 2)"), std::string::npos);
  model.outer[0] = path({{0, 0}, {4, 0}, {4, 4}, {4, 0}});  // there and back
  EXPECT_NE(error_of(model).find("loop 'outer-1' has no area"), std::string::npos);
  model = plate();
  model.outer.push_back(path({{8, 4}, {14, 4}, {14, 8}, {8, 8}}));
  EXPECT_NE(error_of(model).find("loops 'outer-1' and 'outer-2' overlap"), std::string::npos);
  model = plate();
  model.outer.push_back(path({{4, 2}, {6, 2}, {6, 4}, {4, 4}}));
  EXPECT_NE(error_of(model).find("loop 'outer-2' lies inside another outer loop"), std::string::npos);
}

TEST(ArrangeErrors, RefuseArcsWithoutShape) {
  Model model = plate();
  model.lines.resize(1);
  model.lines[0].path.items = {{{1, 3}, {}}, {{1, 3}, Point{5, 3}}};
  EXPECT_NE(error_of(model).find("an arc ends where it starts"), std::string::npos);
  model.lines[0].path.items = {{{1, 3}, {}}, {{2, 3}, Point{5, 3}}};
  EXPECT_NE(error_of(model).find("in line with its ends"), std::string::npos);
}

/// Lines and circles on a small grid: everything touches, crosses and overlaps. @param scale  a power of two.
Model tangle(unsigned seed, double scale, double noise) {
  std::mt19937 random(seed);
  const auto pick = [&](int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); };
  const auto place = [&] {
    const double x = pick(9) - 1 + noise * (pick(3) - 1);
    const double y = pick(9) - 1 + noise * (pick(3) - 1);
    return Point{scale * x, scale * y};
  };
  Model model;
  model.size = scale;
  model.outer = {path({{0, 0}, {scale * 7, 0}, {scale * 7, scale * 7}, {0, scale * 7}})};
  model.holes = {circle({scale * 2, scale * 2}, scale),
                 path({{scale * 4, scale * 4}, {scale * 6, scale * 4}, {scale * 5, scale * 6}})};
  for (int i = 0; i < 8; ++i) {
    model.lines.emplace_back();
    if (pick(4) == 0) {
      model.lines.back().path = circle(place(), scale * 0.5 * (1 + pick(6)));
    } else {
      model.lines.back().path = path({place(), place(), place()});
    }
  }
  for (int i = 0; i < 3; ++i) model.points.push_back({"", place(), {}, ""});
  return model;
}

TEST(ArrangeTangles, AreSoundWhateverMeets) {
  for (unsigned seed = 1; seed <= 150; ++seed) {
    for (const double noise : {0.0, 1e-9, 7e-7, 5e-6, 4e-5}) {
      const Domain domain = arranged(tangle(seed, 1, noise));
      expect_sound(domain);
      EXPECT_NEAR(area(domain), 49 - kPi - 2, 20 * std::max(domain.tolerance, noise)) << seed;
      if (testing::Test::HasFailure()) FAIL() << "seed " << seed << " noise " << noise;
    }
  }
}

TEST(ArrangeTangles, ScaleBitForBitByPowersOfTwo) {
  for (unsigned seed = 1; seed <= 40; ++seed) {
    const double f = 0x1p-33;
    const Domain one = arranged(tangle(seed, 1, 7e-7));
    const Domain two = arranged(tangle(seed, f, 7e-7));
    ASSERT_EQ(one.vertices.count(), two.vertices.count());
    ASSERT_EQ(one.curves.count(), two.curves.count());
    EXPECT_EQ(f * one.tolerance, two.tolerance);
    for (std::size_t i = 0; i < one.vertices.count(); ++i) {
      EXPECT_EQ(f * one.vertices[VertexId(i)].at, two.vertices[VertexId(i)].at);
    }
    for (std::size_t i = 0; i < one.curves.count(); ++i) {
      EXPECT_EQ(one.curves[CurveId(i)].piece.sweep, two.curves[CurveId(i)].piece.sweep);
      EXPECT_EQ(one.curves[CurveId(i)].left, two.curves[CurveId(i)].left);
    }
  }
}

TEST(Arrange, WorksFarFromTheOriginAndTiny) {
  for (const Point place : {Point{1e7, 1}, Point{0, 1e-7}, Point{-3e5, 1e-2}}) {
    const double shift = place.x, size = place.y;
    Model model;
    model.size = size;
    const auto at = [&](double x, double y) { return Point{shift + size * x, size * y - shift}; };
    model.outer = {path({at(0, 0), at(10, 0), at(10, 6), at(0, 6)})};
    model.holes = {circle(at(5, 3), size)};
    model.lines = {line({at(0, 3), at(4, 3)}), line({at(1, 0), at(3, 6)}), line({at(5, 4), at(5, 6)})};
    const Domain domain = arranged(model);
    EXPECT_EQ(domain.cells.count(), 4u);
    EXPECT_TRUE(domain.findings.empty());
    EXPECT_EQ(domain.paths[2].curves.size(), 2u);
  }
}

TEST(Arrange, StopsWhenAsked) {
  Context context;
  context.is_cancelled = [] { return true; };
  EXPECT_THROW(arrange(plate(), {}, context), Cancelled);
}

}  // namespace
}  // namespace quadline
