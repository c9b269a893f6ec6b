#include "domain/circle_parts.hpp"

#include <gtest/gtest.h>

#include <numeric>

#include "base/constants.hpp"

namespace quadline {
namespace {

/// Arcs with these parts of a full turn.
Domain arcs(const std::vector<double>& parts) {
  Domain domain;
  for (const double part : parts) {
    Domain::Curve curve;
    curve.piece.sweep = part * kFullTurn;
    domain.curves.push_back(curve);
  }
  return domain;
}

std::vector<std::uint32_t> shares(const std::vector<double>& parts, std::uint32_t edges) {
  Domain domain = arcs(parts);
  std::vector<DirectedCurve> circle;
  for (std::size_t i = 0; i < parts.size(); ++i) circle.push_back({CurveId(i), false});
  EXPECT_EQ(given_edges(domain, circle), 0u);
  share_edges(domain, circle, edges);
  EXPECT_EQ(given_edges(domain, circle), edges);
  std::vector<std::uint32_t> found;
  for (const Domain::Curve& curve : domain.curves) found.push_back(curve.edges);
  return found;
}

using Shares = std::vector<std::uint32_t>;

TEST(CircleParts, AreAsTheTurnsOfTheArcs) {
  EXPECT_EQ(shares({0.5, 0.5}, 22), (Shares{11, 11}));
  EXPECT_EQ(shares({0.25, 0.25, 0.5}, 24), (Shares{6, 6, 12}));
  EXPECT_EQ(shares({-0.7, -0.3}, 10), (Shares{7, 3}));
}

TEST(CircleParts, AddUpWhereTheyAreRounded) {
  EXPECT_EQ(shares({1.0 / 3, 1.0 / 3, 1.0 / 3}, 8), (Shares{3, 2, 3}));
  EXPECT_EQ(shares({0.25, 0.25, 0.25, 0.25}, 6), (Shares{1, 2, 1, 2}));
}

TEST(CircleParts, LeaveNoArcWithout) {
  EXPECT_EQ(shares({0.99, 0.004, 0.006}, 4), (Shares{2, 1, 1}));
  EXPECT_EQ(shares({0.001, 0.998, 0.001}, 3), (Shares{1, 1, 1}));
}

TEST(CircleParts, AreUnknownWhereAnArcHasNone) {
  Domain domain = arcs({0.5, 0.5});
  domain.curves[CurveId(std::size_t{0})].edges = 8;
  EXPECT_EQ(given_edges(domain, {{CurveId(std::size_t{0}), false}, {CurveId(std::size_t{1}), false}}), 0u);
}

}  // namespace
}  // namespace quadline
