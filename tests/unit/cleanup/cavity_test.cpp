#include "stages/cleanup/cavity.hpp"

#include <gtest/gtest.h>

#include "quad_shapes.hpp"
#include "stages/cleanup/star.hpp"
#include "stages/cleanup/trial.hpp"

namespace quadline::cleanup {
namespace {

FaceId face(const WorkMesh& mesh, std::size_t a, std::size_t b) {
  return mesh.topo().face(mesh.topo().find(NodeId(a), NodeId(b)));
}

struct Fixture {
  explicit Fixture(const WorkMesh& m) : mesh(m), sectors(mesh), finder(mesh, sectors) {}
  bool collect(const std::vector<FaceId>& faces) { return finder.collect(faces, cavity); }
  WorkMesh mesh;
  Sectors sectors;
  CavityFinder finder;
  Cavity cavity;
};

// Nodes of a 4 x 4 grid: 5 j + i.
TEST(Cavity, OfAStarHasTheNodeInside) {
  Fixture f(shapes::grid(4, 4));
  ASSERT_TRUE(f.collect({face(f.mesh, 6, 7), face(f.mesh, 7, 8), face(f.mesh, 12, 13), face(f.mesh, 11, 12)}));
  EXPECT_EQ(f.cavity.rim.size(), 8u);
  EXPECT_EQ(f.cavity.inner, std::vector<NodeId>{NodeId(12)});
  EXPECT_EQ(f.cavity.cost, 0);
  EXPECT_EQ(least_cost(f.cavity), 0);
  for (const Cavity::RimNode& r : f.cavity.rim) EXPECT_EQ(r.inside + r.outside, 4);
}

TEST(Cavity, AtTheBoundaryCountsItsSectorOnly) {
  Fixture f(shapes::grid(4, 4, 1, {{12, 7}, {7, 2}}));
  ASSERT_TRUE(f.collect({face(f.mesh, 2, 3), face(f.mesh, 7, 8)}));
  for (const Cavity::RimNode& r : f.cavity.rim) {
    if (r.node == NodeId(2)) {
      EXPECT_EQ(r.inside + r.outside, 1);
    }
    if (r.node == NodeId(7)) {
      EXPECT_EQ(r.inside + r.outside, 2);
    }
    if (r.node == NodeId(8)) {
      EXPECT_EQ(r.inside + r.outside, 4);
    }
  }
}

TEST(Cavity, RefusesWhatIsNoDisk) {
  Fixture f(shapes::grid(4, 4));
  EXPECT_FALSE(f.collect({face(f.mesh, 0, 1), face(f.mesh, 6, 7)}));  // they touch in a node
  EXPECT_FALSE(f.collect({face(f.mesh, 0, 1), face(f.mesh, 2, 3)}));  // they do not touch
  std::vector<FaceId> ring;
  for (const auto& [a, b] : {std::pair{0, 1}, {1, 2}, {2, 3}, {5, 6}, {7, 8}, {10, 11}, {11, 12}, {12, 13}})
    ring.push_back(face(f.mesh, a, b));
  EXPECT_FALSE(f.collect(ring));
}

TEST(Cavity, RefusesAConstraintInside) {
  Fixture f(shapes::grid(4, 4, 1, {{7, 12}}));
  EXPECT_FALSE(f.collect({face(f.mesh, 6, 7), face(f.mesh, 7, 8)}));
  EXPECT_TRUE(f.collect({face(f.mesh, 6, 7), face(f.mesh, 1, 2)}));
}

TEST(Cavity, KnowsTheCostOfAReplacement) {
  Fixture f(shapes::grid(4, 4));
  ASSERT_TRUE(f.collect({face(f.mesh, 6, 7), face(f.mesh, 7, 8)}));
  ASSERT_EQ(f.cavity.rim.size(), 6u);
  std::size_t at = 0;  // the place of node 7, the lower end of the edge between the two
  while (f.cavity.rim[at].node != NodeId(7)) ++at;
  const auto rim = [&](std::size_t i) { return static_cast<std::uint16_t>((at + i) % 6); };
  const Replacement same{{}, {{rim(0), rim(1), rim(2), rim(3)}, {rim(3), rim(4), rim(5), rim(0)}}};
  EXPECT_EQ(cost_after(f.cavity, same), 0);
  const Replacement turned{{}, {{rim(1), rim(2), rim(3), rim(4)}, {rim(4), rim(5), rim(0), rim(1)}}};
  EXPECT_EQ(cost_after(f.cavity, turned), 4);
}

TEST(Trial, LeavesTheMeshAloneUntilItIsCarriedOut) {
  Fixture f(shapes::grid(4, 4));
  IdVector<NodeId, double> size(f.mesh.topo().node_capacity(), 1);
  ASSERT_TRUE(f.collect({face(f.mesh, 6, 7), face(f.mesh, 7, 8)}));
  std::size_t at = 0;
  while (f.cavity.rim[at].node != NodeId(7)) ++at;
  const auto rim = [&](std::size_t i) { return static_cast<std::uint16_t>((at + i) % 6); };
  const Replacement turned{{}, {{rim(1), rim(2), rim(3), rim(4)}, {rim(4), rim(5), rim(0), rim(1)}}};
  Trial trial(f.mesh, size);
  ASSERT_TRUE(trial.build(f.cavity, turned));
  EXPECT_NEAR(trial.quality_now().mean_beta, 1, 1e-12);
  trial.smooth(5);
  EXPECT_LT(trial.quality().mean_beta, 0.95);
  EXPECT_GT(trial.quality().least_jacobian, 0.3);
  EXPECT_EQ(f.mesh.point(NodeId(7)), (Point{2, 1}));
  EXPECT_TRUE(f.mesh.topo().find(NodeId(7), NodeId(12)).valid());

  std::vector<NodeId> nodes;
  trial.commit(f.mesh, size, nodes);
  EXPECT_EQ(defect(f.mesh), "");
  EXPECT_EQ(nodes.size(), 6u);
  EXPECT_FALSE(f.mesh.topo().find(NodeId(7), NodeId(12)).valid());
}

TEST(Trial, RefusesASecondEdge) {
  // The hexagon 0 .. 5, cut by 1 - 4, under the quad 5 4 3 0, whose side 0 - 3 must not stand twice.
  Fixture f(shapes::quad_mesh({{0, 0}, {0, -3}, {4, -3}, {4, 0}, {3, -1}, {1, -1}},
                              {{1, 2, 3, 4}, {4, 5, 0, 1}, {5, 4, 3, 0}}));
  IdVector<NodeId, double> size(f.mesh.topo().node_capacity(), 1);
  ASSERT_TRUE(f.collect({face(f.mesh, 1, 2), face(f.mesh, 4, 5)}));
  std::size_t at = 0;
  while (f.cavity.rim[at].node != NodeId(0)) ++at;
  const auto rim = [&](std::size_t i) { return static_cast<std::uint16_t>((at + i) % 6); };
  Trial trial(f.mesh, size);
  EXPECT_FALSE(trial.build(f.cavity, {{}, {{rim(0), rim(1), rim(2), rim(3)}, {rim(3), rim(4), rim(5), rim(0)}}}));
  EXPECT_TRUE(trial.build(f.cavity, {{}, {{rim(2), rim(3), rim(4), rim(5)}, {rim(5), rim(0), rim(1), rim(2)}}}));
}

TEST(BetterPlace, MovesToTheMiddleOfASquare) {
  const Point a{-1, -1}, b{1, -1}, c{1, 1}, d{-1, 1}, e{0, -1}, f{1, 0}, g{0, 1}, h{-1, 0};
  const std::vector<StarQuad> star{{h, a, e}, {e, b, f}, {f, c, g}, {g, d, h}};
  Point p{0.4, 0.3};
  for (int i = 0; i < 8; ++i) p = better_place(p, star, 1);
  EXPECT_NEAR(p.x, 0, 1e-3);
  EXPECT_NEAR(p.y, 0, 1e-3);
}

TEST(BetterPlace, MindsTheSizeWhereItIsNear) {
  const Point a{-1, -1}, b{2, -1}, c{2, 1}, d{-1, 1}, e{0, -1}, f{2, 0}, g{0, 1}, h{-1, 0};
  const std::vector<StarQuad> star{{h, a, e}, {e, b, f}, {f, c, g}, {g, d, h}};
  const auto stretch = [&](Point p, double size) {
    double sum = 0;
    for (const Point& q : {e, f, g, h}) sum += norm2(q - p) / (size * size) + size * size / norm2(q - p);
    return sum;
  };
  Point near{0, 0}, far{0, 0};
  for (int i = 0; i < 20; ++i) {
    near = better_place(near, star, 1);
    far = better_place(far, star, 100);
  }
  EXPECT_LT(stretch(near, 1), stretch(far, 1) - 1e-3);
}

TEST(BetterPlace, ComesBackFromOutside) {
  const Point a{-1, -1}, b{1, -1}, c{1, 1}, d{-1, 1}, e{0, -1}, f{1, 0}, g{0, 1}, h{-1, 0};
  const std::vector<StarQuad> star{{h, a, e}, {e, b, f}, {f, c, g}, {g, d, h}};
  Point p{1.6, 0.2};
  for (int i = 0; i < 20; ++i) p = better_place(p, star, 1);
  EXPECT_NEAR(p.x, 0, 0.01);
  EXPECT_NEAR(p.y, 0, 0.01);
}

}  // namespace
}  // namespace quadline::cleanup
