// Symmetries of a domain, and the cuts along their axes.
#include "domain/symmetry/symmetries.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "domain/arrange/arrange.hpp"
#include "domain/symmetry/cut_at_axes.hpp"

namespace quadline {
namespace {

Model plate(double width, double height) {
  Model model;
  model.size = 1;
  model.outer.push_back({.items = {{{0, 0}}, {{width, 0}}, {{width, height}}, {{0, height}}}});
  return model;
}

Domain arranged(const Model& model) {
  Context context;
  return arrange(model, {}, context);
}

std::size_t n_symmetries(const Model& model) { return find_symmetries(arranged(model)).size(); }

double area(const Domain& domain) {
  double twice = 0;
  for (const Domain::Cell& cell : domain.cells)
    for (const auto& walk : cell.walks)
      for (const DirectedCurve& d : walk) {
        const CurvePiece& piece = domain.curves[d.curve].piece;
        twice += twice_area_under(d.reversed ? reversed(piece) : piece, {});
      }
  return 0.5 * twice;
}

TEST(Symmetries, OfSquareRectangleAndCircle) {
  EXPECT_EQ(n_symmetries(plate(8, 8)), 7u);
  EXPECT_EQ(n_symmetries(plate(9, 8)), 3u);
  Model disk;
  disk.size = 1;
  disk.outer.push_back({.circle = Circle{{3, 4}, 5}});
  EXPECT_EQ(n_symmetries(disk), 7u);  // though its vertices are in the east and west
}

TEST(Symmetries, AskForWhatLiesInside) {
  Model model = plate(8, 8);
  model.holes.push_back({.circle = Circle{{4, 6}, 1}});
  EXPECT_EQ(n_symmetries(model), 1u);
  model.points.push_back({.name = "lug", .at = {2, 2}});
  EXPECT_EQ(n_symmetries(model), 0u);
  model.points.push_back({.name = "other lug", .at = {6, 2}});
  EXPECT_EQ(n_symmetries(model), 1u);
  model.points.back().size = 0.5;
  EXPECT_EQ(n_symmetries(model), 0u);
}

TEST(Symmetries, TakeCurvesAndCellsToTheirLike) {
  Model model = plate(8, 6);
  model.lines.push_back({.name = "left", .path = {.items = {{{2, 0}}, {{2, 6}}}}});
  model.lines.push_back({.name = "right", .path = {.items = {{{6, 0}}, {{6, 6}}}}});
  const Domain domain = arranged(model);
  for (const Symmetry& symmetry : find_symmetries(domain)) {
    for (std::size_t i = 0; i < domain.curves.count(); ++i) {
      const Domain::Curve& from = domain.curves[CurveId(i)];
      const DirectedCurve image = symmetry.curves[CurveId(i)];
      const Domain::Curve& to = domain.curves[image.curve];
      EXPECT_EQ(symmetry.vertices[from.tail], image.reversed ? to.head : to.tail);
      EXPECT_LT(distance(symmetry.move(from.piece.a), image.reversed ? to.piece.b : to.piece.a), 1e-12);
    }
    std::set<CellId> images(symmetry.cells.begin(), symmetry.cells.end());
    EXPECT_EQ(images.size(), 3u);
  }
}

TEST(Symmetries, KnowTheEdgesAndRingsThatCirclesAskFor) {
  Model model = plate(20, 16);
  for (const double x : {5.0, 15.0})
    model.holes.push_back(
        {.circle = Circle{.center = {x, 8}, .radius = 2, .edges = 16, .rings = 2, .ring_width = 0.5}});
  EXPECT_EQ(find_symmetries(arranged(model)).size(), 3u);
  Model other = model;
  other.holes[0].circle->edges = 20;
  EXPECT_EQ(find_symmetries(arranged(other)).size(), 1u);
  other = model;
  other.holes[0].circle->rings = 1;
  other.holes[0].circle->ring_width = 1;  // up to the same circle
  EXPECT_EQ(find_symmetries(arranged(other)).size(), 1u);
}

TEST(CutAtAxes, HalvesTheEdgesThatAnArcIsGivenIfTheyAreEven) {
  for (const std::uint32_t edges : {20u, 22u}) {
    Model model = plate(20, 16);
    model.holes.push_back({.circle = Circle{.center = {10, 8}, .radius = 3, .edges = edges}});
    const Domain cut = cut_at_axes(arranged(model), {});
    EXPECT_EQ(cut.cells.count(), edges % 4 == 0 ? 4u : 2u);
    std::uint32_t sum = 0;
    for (const Domain::Curve& curve : cut.curves) sum += curve.edges;
    EXPECT_EQ(sum, edges);
  }
}

TEST(CutAtAxes, APlateWithAHoleFallsIntoQuarters) {
  Model model = plate(20, 16);
  model.holes.push_back({.circle = Circle{{10, 8}, 3}});
  model.points.push_back({.name = "above", .at = {10, 14}});
  model.points.push_back({.name = "below", .at = {10, 2}});
  const Domain whole = arranged(model), cut = cut_at_axes(whole, {});
  EXPECT_EQ(cut.cells.count(), 4u);
  EXPECT_NEAR(area(cut), area(whole), 1e-9);
  const auto n_auxiliary = std::count_if(cut.curves.begin(), cut.curves.end(),
                                         [](const Domain::Curve& curve) { return curve.is_auxiliary; });
  EXPECT_EQ(n_auxiliary, 6);  // those above and below are cut at the points
  for (const Domain::Cell& cell : cut.cells) EXPECT_TRUE(cell.lone_points.empty());
  for (const Domain::Path& path : cut.paths)
    for (const DirectedCurve& d : path.curves) EXPECT_FALSE(cut.curves[d.curve].is_auxiliary);
  for (std::size_t i = 0; i < cut.cells.count(); ++i)
    for (const DirectedCurve& d : cut.cells[CellId(i)].walks.at(0))
      EXPECT_EQ(d.reversed ? cut.curves[d.curve].right : cut.curves[d.curve].left, CellId(i));
  EXPECT_EQ(find_symmetries(cut).size(), 3u);
}

TEST(CutAtAxes, HolesGoToTheirHalf) {
  Model model = plate(20, 7);
  model.outer[0].items[2].to = {18, 7};
  model.outer[0].items[3].to = {2, 7};
  for (const double x : {4.0, 16.0}) model.holes.push_back({.circle = Circle{{x, 3}, 1}});
  model.points.push_back({.name = "left", .at = {8, 5}});
  model.points.push_back({.name = "right", .at = {12, 5}});
  const Domain cut = cut_at_axes(arranged(model), {});
  ASSERT_EQ(cut.cells.count(), 2u);
  for (const Domain::Cell& cell : cut.cells) {
    EXPECT_EQ(cell.walks.size(), 2u);
    EXPECT_EQ(cell.lone_points.size(), 1u);
  }
}

TEST(CutAtAxes, LeavesWholeWhatACutWouldHarm) {
  const auto n_cells = [](const Model& model) { return cut_at_axes(arranged(model), {}).cells.count(); };
  EXPECT_EQ(n_cells(plate(20, 16)), 1u);  // rows go through
  Model kite;
  kite.size = 1;
  kite.outer.push_back({.items = {{{0, 0}}, {{10, -5}}, {{30, 0}}, {{10, 5}}}});
  EXPECT_EQ(n_cells(kite), 1u);  // it would halve the tips
  Model slot = plate(20, 16);
  slot.size = 2;
  for (const double x : {9.0, 11.0}) slot.lines.push_back({.name = {}, .path = {.items = {{{x, 4}}, {{x, 12}}}}});
  for (const double x : {3.0, 17.0}) slot.lines.push_back({.name = {}, .path = {.items = {{{x, 7}}, {{x, 10}}}}});
  EXPECT_EQ(n_cells(slot), 1u);  // a line runs half a size beside the axis
}

}  // namespace
}  // namespace quadline
