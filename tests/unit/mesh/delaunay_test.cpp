#include "mesh/delaunay.hpp"

#include <gtest/gtest.h>

#include "tests/unit/triangulate/segments.hpp"

namespace quadline {
namespace {

using test::rectangle;
using test::Sketch;

/// A square with a slanted line, and nodes in the field.
Sketch square_with_line() {
  Sketch s;
  s.loop(rectangle(-3, -3, 3, 3), 0, -1);
  s.line({{-2, -1}, {2, 1.5}}, 0);
  test::Random r(5);
  for (int i = 0; i < 200; ++i) s.node({5.8 * r.unit() - 2.9, 5.8 * r.unit() - 2.9});
  s.triangulate();
  return s;
}

TEST(Locate, FindsTheTriangleFromEverywhere) {
  const Sketch s = square_with_line();
  const Topology& topo = s.mesh.topo();
  test::Random r(3);
  FaceId f = topo.face(topo.out(NodeId(0)));
  for (int i = 0; i < 2000; ++i) {
    const Point p{6 * r.unit() - 3, 6 * r.unit() - 3};
    f = locate(s.mesh, p, f);
    topo.for_each_half(
        f, [&](HalfId h) { EXPECT_GE(orientation(s.mesh.point(topo.tail(h)), s.mesh.point(topo.head(h)), p), 0); });
  }
}

TEST(InsertNode, RefusesPlacesThatAreTaken) {
  Sketch s;
  s.loop(rectangle(0, 0, 1, 1), 0, -1);
  s.triangulate();
  const FaceId f = s.mesh.topo().face(s.mesh.topo().find(NodeId(0), NodeId(1)));
  const NodeId on_node = s.mesh.add_node({1, 0}), on_rim = s.mesh.add_node({0.5, 0}),
               inside = s.mesh.add_node({0.5, 0.5});
  EXPECT_FALSE(insert_node(s.mesh, on_node, f));
  EXPECT_FALSE(insert_node(s.mesh, on_rim, f));
  EXPECT_TRUE(insert_node(s.mesh, inside, f));  // on the diagonal
  EXPECT_EQ(s.mesh.topo().edge_valence(inside), 4);
  EXPECT_TRUE(s.mesh.cell(s.mesh.topo().face(s.mesh.topo().out(inside))).valid());
}

TEST(InsertNode, KeepsTheConstrainedDelaunayProperty) {
  Sketch s = square_with_line();
  const std::size_t n_segments = s.mesh.segments().size();
  FaceId near = s.mesh.topo().face(s.mesh.topo().out(NodeId(0)));
  test::Random r(9);
  for (int i = 0; i < 300; ++i) {
    const NodeId v = s.mesh.add_node({5.9 * r.unit() - 2.95, 5.9 * r.unit() - 2.95});
    near = locate(s.mesh, s.mesh.point(v), near);
    ASSERT_TRUE(insert_node(s.mesh, v, near));
    near = s.mesh.topo().face(s.mesh.topo().out(v));
  }
  EXPECT_EQ(defect(s.mesh), "");
  EXPECT_EQ(s.mesh.segments().size(), n_segments);
  EXPECT_EQ(test::segments_missing(s.mesh), 0);
  EXPECT_EQ(test::edges_not_delaunay(s.mesh), 0);
}

TEST(RestoreDelaunay, MendsWhatWasSwapped) {
  Sketch s = square_with_line();
  s.mesh.drop_outside();  // the corners of the square and the box are ties
  const auto before = test::triangles(s.mesh);
  test::Random r(2);
  for (int i = 0; i < 500; ++i) {
    const EdgeId e(r.below(s.mesh.topo().edge_capacity()));
    if (s.mesh.topo().is_live(e) && s.mesh.can_swap(e) == Refusal::None) s.mesh.swap_edge(e);
  }
  EXPECT_NE(test::triangles(s.mesh), before);
  std::vector<EdgeId> suspects;
  for (std::size_t i = 0; i < s.mesh.topo().edge_capacity(); ++i) suspects.push_back(EdgeId(i));
  restore_delaunay(s.mesh, suspects);
  EXPECT_TRUE(suspects.empty());
  EXPECT_EQ(test::triangles(s.mesh), before);
}

}  // namespace
}  // namespace quadline
