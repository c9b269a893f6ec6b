#include "domain/whole_circle.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <numbers>

#include "tests/unit/grid/grid_shapes.hpp"

namespace quadline {
namespace {

const CellId kCell(std::size_t{0});

// A square of 10 with a circle of radius 2 about its middle, the disc in it a cell too; perhaps with a spoke there.
Domain square_with_disc(bool has_spoke) {
  std::vector<shapes::Link> links{{0, 1}, {1, 2}, {2, 3}, {3, 0}, {4, 5, Point{5, 7}}, {5, 4, Point{5, 3}}};
  std::vector<Point> points{{0, 0}, {10, 0}, {10, 10}, {0, 10}, {7, 5}, {3, 5}};
  if (has_spoke) {
    links.push_back({4, 6});
    points.push_back({5.5, 5});
  }
  return shapes::Builder(points, links, 1).build();
}

// The cell with two walks.
const Domain::Cell& outside(const Domain& domain) {
  return *std::find_if(domain.cells.begin(), domain.cells.end(),
                       [](const auto& cell) { return cell.walks.size() == 2; });
}

TEST(WholeCircles, FindsAHole) {
  const Domain domain = shapes::arranged(shapes::plate_model(20, 10, {{4, 5}, {13, 5.5}}, 1.5));
  const WholeCircles circles(domain);
  const auto& walks = domain.cells[kCell].walks;
  ASSERT_EQ(walks.size(), 3u);
  EXPECT_FALSE(circles.find(domain, walks[0]));
  std::vector<double> x;
  for (const std::size_t w : {1, 2}) {
    const std::optional<WholeCircle> circle = circles.find(domain, walks[w]);
    ASSERT_TRUE(circle);
    EXPECT_DOUBLE_EQ(circle->radius, 1.5);
    x.push_back(circle->center.x);
  }
  std::sort(x.begin(), x.end());
  EXPECT_EQ(x, (std::vector<double>{4, 13}));
}

TEST(WholeCircles, FindsTheOuterCircleOfADisc) {
  const Domain domain = shapes::arranged(shapes::flange_model(0));
  const WholeCircles circles(domain);
  const std::optional<WholeCircle> outer = circles.find(domain, domain.cells[kCell].walks[0]);
  ASSERT_TRUE(outer);
  EXPECT_EQ(outer->radius, 12);
}

TEST(WholeCircles, NotWhereALineEndsAtTheSeam) {
  const Domain free = square_with_disc(false), touched = square_with_disc(true);
  EXPECT_TRUE(WholeCircles(free).find(free, outside(free).walks[1]));
  EXPECT_FALSE(WholeCircles(touched).find(touched, outside(touched).walks[1]));
}

TEST(WholeCircles, NotWhereAPointIsAtTheSeam) {
  Domain domain = square_with_disc(false);
  domain.points.push_back({"lug", VertexId(std::size_t{5}), std::numeric_limits<double>::infinity()});
  EXPECT_FALSE(WholeCircles(domain).find(domain, outside(domain).walks[1]));
}

TEST(WholeCircles, ALensIsNone) {
  const Domain lens = shapes::Builder({{0, 0}, {4, 0}}, {{0, 1, Point{2, -1}}, {1, 0, Point{2, 1}}}, 1).build();
  EXPECT_FALSE(WholeCircles(lens).find(lens, lens.cells[kCell].walks[0]));
}

TEST(WholeCircles, TurnMovesTheEndsOfTheArcs) {
  Domain domain = shapes::arranged(shapes::plate_model(10, 10, {{4, 5}}, 2));
  const std::vector<DirectedCurve> walk = domain.cells[kCell].walks[1];
  const std::array<double, 2> sweeps{domain.curves[walk[0].curve].piece.sweep,
                                     domain.curves[walk[1].curve].piece.sweep};
  WholeCircles::turn(domain, walk, {3, 4});
  EXPECT_TRUE(WholeCircles(domain).find(domain, walk));
  const Domain::Curve& first = domain.curves[walk[0].curve];
  EXPECT_NEAR(distance(domain.vertices[first.tail].at, {4 + 1.2, 5 + 1.6}), 0, 1e-12);
  EXPECT_NEAR(distance(domain.vertices[first.head].at, {4 - 1.2, 5 - 1.6}), 0, 1e-12);
  for (const std::size_t n : {0, 1}) {
    const Domain::Curve& curve = domain.curves[walk[n].curve];
    EXPECT_EQ(curve.piece.a, domain.vertices[curve.tail].at);
    EXPECT_EQ(curve.piece.b, domain.vertices[curve.head].at);
    EXPECT_NEAR(curve.piece.sweep, sweeps[n], 1e-12);  // the way it went
    EXPECT_NEAR(length(curve.piece), 2 * std::numbers::pi, 1e-12);
    const Point middle = point_at(curve.piece, 0.5 * length(curve.piece));
    EXPECT_NEAR(std::abs(dot(middle - Point{4, 5}, {-0.8, 0.6})), 2, 1e-9);
  }
}

}  // namespace
}  // namespace quadline
