// Arcs that are too coarse for their chords.
#include "stages/discretize/chords.hpp"

#include <gtest/gtest.h>

#include "tests/unit/domain/size/size_shapes.hpp"

namespace quadline {
namespace {

// A half disk of radius 1 about the origin, above the x axis: curve 0 is its straight side, curve 1 its arc.
Domain half_disk(const std::vector<Point>& more = {}, const std::vector<shapes::Link>& links = {}) {
  std::vector<Point> points{{-1, 0}, {1, 0}};
  points.insert(points.end(), more.begin(), more.end());
  std::vector<shapes::Link> all{{0, 1}, {1, 0, Point{0, 1}}};
  all.insert(all.end(), links.begin(), links.end());
  return shapes::Builder(std::move(points), std::move(all), 0.3).build();
}

Polylines lines_of(const Domain& domain, const std::vector<std::uint32_t>& edges) {
  Polylines lines;
  for (std::size_t i = 0; i < domain.curves.count(); ++i) {
    const CurvePiece& piece = domain.curves[CurveId(i)].piece;
    std::vector<Point> line{piece.a};
    for (std::uint32_t k = 1; k < edges[i]; ++k) line.push_back(point_at(piece, length(piece) * k / edges[i]));
    line.push_back(piece.b);
    lines.push_back(std::move(line));
  }
  return lines;
}

std::vector<CurveId> coarse(const Domain& domain, const std::vector<std::uint32_t>& edges,
                            EdgeUse use = EdgeUse::Whole) {
  return too_coarse_arcs(domain, lines_of(domain, edges), IdVector<CurveId, EdgeUse>(domain.curves.count(), use));
}

const std::vector<CurveId> kArc{CurveId(std::size_t{1})};

TEST(TooCoarseArcs, OneChordLiesOnTheStraightSide) {
  EXPECT_EQ(coarse(half_disk(), {1, 1}), kArc);
  EXPECT_TRUE(coarse(half_disk(), {1, 2}).empty());
}

// The line ends 0.05 below the top of the arc: between its two chords and the arc, until there are enough.
TEST(TooCoarseArcs, AChordMustNotCutOffANode) {
  const Domain domain = half_disk({{0.5, 0.5}, {0.6, 0.7}}, {{2, 3}});
  EXPECT_EQ(coarse(domain, {1, 2, 1}), kArc);
  EXPECT_TRUE(coarse(domain, {1, 5, 1}).empty());
}

// The nodes at the top of the finer arc lie between the middle chord of the coarser one and that arc.
TEST(TooCoarseArcs, AChordMustNotCutOffNodesOfAnotherArc) {
  const Domain domain = half_disk({{-0.7, 0.3}, {0.7, 0.3}}, {{2, 3, Point{0, 0.9}}});
  EXPECT_TRUE(coarse(domain, {1, 16, 16}).empty());
  EXPECT_EQ(coarse(domain, {1, 3, 16}), kArc);
}

// Two arcs with the same ends, each of one chord: it is enough that one of them gets a node.
TEST(TooCoarseArcs, OfTwoWithTheSameChordTheOneWithMoreBulgeIs) {
  const Domain lens = shapes::Builder({{-1, 0}, {1, 0}}, {{0, 1, Point{0, -0.5}}, {1, 0, Point{0, 1}}}, 0.3).build();
  EXPECT_EQ(coarse(lens, {1, 1}), kArc);
  EXPECT_TRUE(coarse(lens, {1, 2}).empty());
}

// Outside the arc, nearer than its bulge: only where the chord will get a node on the arc does it matter.
TEST(TooCoarseArcs, HalvedChordsMindWhatIsCloseOutside) {
  const Domain domain = half_disk({{0.2, 1.05}, {0.2, 2}}, {{2, 3}});
  EXPECT_TRUE(coarse(domain, {1, 4, 1}).empty());
  EXPECT_EQ(coarse(domain, {1, 4, 1}, EdgeUse::Halved), kArc);
  EXPECT_TRUE(coarse(domain, {1, 16, 1}, EdgeUse::Halved).empty());
}

// The ends of the straight side lie on the arc, opposite to chords at its other end.
TEST(TooCoarseArcs, TheFarSideIsNotClose) {
  for (const std::uint32_t edges : {2u, 3u, 5u, 16u, 64u})
    EXPECT_TRUE(coarse(half_disk(), {1, edges}, EdgeUse::Halved).empty()) << edges;
}

TEST(TooCoarseArcs, NothingIsWithoutArcs) {
  const Domain square = shapes::Builder({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, {{0, 1}, {1, 2}, {2, 3}, {3, 0}}, 1).build();
  EXPECT_TRUE(coarse(square, {1, 1, 1, 1}).empty());
}

}  // namespace
}  // namespace quadline
