#include "topo/topology.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "quadline/errors.hpp"

namespace quadline {
namespace {

NodeId n(std::size_t i) { return NodeId(i); }

Polygon triangle(std::size_t a, std::size_t b, std::size_t c) { return {n(a), n(b), n(c)}; }
Polygon quad(std::size_t a, std::size_t b, std::size_t c, std::size_t d) { return {n(a), n(b), n(c), n(d)}; }

Topology made_of(std::size_t n_nodes, const std::vector<Polygon>& polygons) {
  Topology topo;
  topo.build(n_nodes, polygons);
  return topo;
}

// Two triangles over the edge 0-2 of the square 0 1 2 3.
Topology diamond() { return made_of(4, {triangle(0, 1, 2), triangle(0, 2, 3)}); }

// 3 x 3 quads over the nodes 4 j + i; without the middle one where `hole`.
Topology nine_quads(bool hole = false) {
  std::vector<Polygon> quads;
  for (std::size_t j = 0; j < 3; ++j)
    for (std::size_t i = 0; i < 3; ++i)
      if (const std::size_t a = 4 * j + i; !hole || a != 5) quads.push_back(quad(a, a + 1, a + 5, a + 4));
  return made_of(16, quads);
}

std::string defect_of(const Topology& topo) { return topo.defect() ? topo.defect() : ""; }

EdgeId edge(const Topology& topo, std::size_t a, std::size_t b) { return edge_of(topo.find(n(a), n(b))); }

std::size_t outside_length(const Topology& topo, HalfId start) {
  std::size_t length = 0;
  HalfId h = start;
  do {
    ++length;
    h = topo.next(h);
  } while (h != start);
  return length;
}

// The corners of a face from its least node on.
std::vector<std::size_t> corners(const Topology& topo, FaceId f) {
  const Polygon p = topo.polygon(f);
  std::vector<std::size_t> ids;
  for (const NodeId v : p.corners()) ids.push_back(v.value);
  std::rotate(ids.begin(), std::min_element(ids.begin(), ids.end()), ids.end());
  return ids;
}

std::vector<std::vector<std::size_t>> faces_of(const Topology& topo) {
  std::vector<std::vector<std::size_t>> faces;
  for (std::size_t i = 0; i < topo.face_capacity(); ++i)
    if (topo.is_live(FaceId(i))) faces.push_back(corners(topo, FaceId(i)));
  std::sort(faces.begin(), faces.end());
  return faces;
}

using Faces = std::vector<std::vector<std::size_t>>;

TEST(TopologyBuild, MakesADiamond) {
  const Topology topo = diamond();
  EXPECT_EQ(defect_of(topo), "");
  EXPECT_EQ(topo.node_count(), 4u);
  EXPECT_EQ(topo.edge_count(), 5u);
  EXPECT_EQ(topo.face_count(), 2u);
  const HalfId diagonal = topo.find(n(0), n(2));
  ASSERT_TRUE(diagonal.valid());
  EXPECT_EQ(topo.head(diagonal), n(2));
  EXPECT_EQ(twin(diagonal), topo.find(n(2), n(0)));
  EXPECT_TRUE(topo.face(diagonal).valid() && topo.face(twin(diagonal)).valid());
  EXPECT_FALSE(topo.find(n(1), n(3)).valid());
  EXPECT_EQ(topo.edge_valence(n(0)), 3);
  EXPECT_EQ(topo.edge_valence(n(1)), 2);
}

TEST(TopologyBuild, LinksTheOutsideRoundTheMeshAndRoundAHole) {
  const Topology topo = nine_quads(true);
  EXPECT_EQ(defect_of(topo), "");
  const HalfId rim = topo.find(n(1), n(0)), hole = topo.find(n(5), n(6));
  ASSERT_FALSE(topo.face(rim).valid());
  ASSERT_FALSE(topo.face(hole).valid());
  EXPECT_EQ(outside_length(topo, rim), 12u);
  EXPECT_EQ(outside_length(topo, hole), 4u);
}

TEST(TopologyBuild, TakesSeparatePiecesAndLoneNodes) {
  const Topology topo = made_of(8, {triangle(0, 1, 2), quad(4, 5, 6, 7)});
  EXPECT_EQ(defect_of(topo), "");
  EXPECT_FALSE(topo.out(n(3)).valid());
  EXPECT_TRUE(topo.is_live(n(3)));
  EXPECT_EQ(topo.edge_valence(n(3)), 0);
}

TEST(TopologyBuild, KeepsOneRingAtAPinchNode) {
  const Topology two = made_of(5, {triangle(0, 1, 2), triangle(0, 3, 4)});
  EXPECT_EQ(defect_of(two), "");
  EXPECT_EQ(two.edge_valence(n(0)), 4);

  const Topology corners_touch = made_of(9, {quad(0, 1, 4, 3), quad(4, 5, 8, 7)});
  EXPECT_EQ(defect_of(corners_touch), "");
  EXPECT_EQ(corners_touch.edge_valence(n(4)), 4);
}

TEST(TopologyBuild, KeepsOneRingWhereThreeFansMeet) {
  const Topology topo = made_of(7, {triangle(0, 1, 2), triangle(0, 3, 4), triangle(0, 5, 6)});
  EXPECT_EQ(defect_of(topo), "");
  EXPECT_EQ(topo.edge_valence(n(0)), 6);
}

TEST(TopologyBuild, RefusesTwoFacesOnOneSide) {
  Topology topo;
  const std::vector<Polygon> folded{triangle(0, 1, 2), triangle(0, 1, 3)};
  EXPECT_THROW(topo.build(4, folded), InternalError);
}

TEST(TopologyWalk, TurnsRoundANodeBothWays) {
  const Topology topo = nine_quads();
  const HalfId start = topo.find(n(5), n(6));
  const std::size_t counter_clockwise[] = {6, 9, 4, 1};
  HalfId h = start;
  for (const std::size_t head : counter_clockwise) {
    EXPECT_EQ(topo.head(h), n(head));
    EXPECT_EQ(topo.rotate_cw(topo.rotate_ccw(h)), h);
    h = topo.rotate_ccw(h);
  }
  EXPECT_EQ(h, start);
}

TEST(TopologySplitFace, MakesThreeOfATriangle) {
  Topology topo = diamond();
  const NodeId v = topo.add_node();
  const FaceId f = topo.face(topo.find(n(0), n(1)));
  const auto [g, k] = topo.split_face(f, v);
  EXPECT_EQ(defect_of(topo), "");
  EXPECT_EQ(topo.edge_valence(v), 3);
  EXPECT_EQ(faces_of(topo), (Faces{{0, 1, 4}, {0, 2, 3}, {0, 4, 2}, {1, 2, 4}}));
  EXPECT_TRUE(topo.is_live(f) && topo.is_live(g) && topo.is_live(k));
}

TEST(TopologySplitEdge, CutsBothTrianglesInside) {
  Topology topo = diamond();
  const NodeId v = topo.add_node();
  const EdgeId e = edge(topo, 0, 2);
  const NodeId a = topo.tail(half_of(e)), b = topo.head(half_of(e));
  const EdgeId rest = topo.split_edge(e, v);
  EXPECT_EQ(defect_of(topo), "");
  EXPECT_EQ(topo.tail(half_of(e)), a);
  EXPECT_EQ(topo.head(half_of(e)), v);
  EXPECT_EQ(topo.tail(half_of(rest)), v);
  EXPECT_EQ(topo.head(half_of(rest)), b);
  EXPECT_EQ(topo.edge_valence(v), 4);
  EXPECT_EQ(faces_of(topo), (Faces{{0, 1, 4}, {0, 4, 3}, {1, 2, 4}, {2, 3, 4}}));
}

TEST(TopologySplitEdge, CutsTheOneTriangleAtTheBoundary) {
  for (const bool reversed : {false, true}) {
    // The order of the faces decides which side of the edge is half 0.
    Topology topo = reversed ? made_of(4, {triangle(0, 2, 3), triangle(2, 0, 1)}) : diamond();
    for (const auto& [a, b] : {std::pair{0, 1}, std::pair{1, 2}, std::pair{2, 3}, std::pair{3, 0}}) {
      const NodeId v = topo.add_node();
      const EdgeId e = edge(topo, a, b);
      const std::size_t n_faces = topo.face_count();
      topo.split_edge(e, v);
      EXPECT_EQ(defect_of(topo), "");
      EXPECT_EQ(topo.face_count(), n_faces + 1);
      EXPECT_EQ(topo.edge_valence(v), 3);
      EXPECT_TRUE(topo.find(n(a), v).valid() && topo.find(v, n(b)).valid());
      EXPECT_FALSE(topo.find(n(a), n(b)).valid());
    }
    EXPECT_EQ(outside_length(topo, topo.face(topo.out(n(0))).valid() ? twin(topo.find(n(0), n(4))) : topo.out(n(0))),
              8u);
  }
}

TEST(TopologySplitEdge, CutsTheRimOfAHole) {
  // A ring of eight triangles round the hole 4 5 6 7.
  std::vector<Polygon> ring;
  for (std::size_t i = 0; i < 4; ++i) {
    const std::size_t k = (i + 1) % 4;
    ring.push_back(triangle(i, k, 4 + i));
    ring.push_back(triangle(k, 4 + k, 4 + i));
  }
  Topology topo = made_of(8, ring);
  EXPECT_EQ(defect_of(topo), "");
  const NodeId v = topo.add_node();
  topo.split_edge(edge(topo, 4, 5), v);
  EXPECT_EQ(defect_of(topo), "");
  EXPECT_EQ(topo.face_count(), 9u);
  EXPECT_EQ(outside_length(topo, topo.find(n(4), v)), 5u);
}

TEST(TopologySwapEdge, TurnsTheDiagonalAndBack) {
  Topology topo = diamond();
  const EdgeId e = edge(topo, 0, 2);
  topo.swap_edge(e);
  EXPECT_EQ(defect_of(topo), "");
  EXPECT_EQ(edge(topo, 1, 3), e);
  EXPECT_EQ(faces_of(topo), (Faces{{0, 1, 3}, {1, 2, 3}}));
  topo.swap_edge(e);
  EXPECT_EQ(defect_of(topo), "");
  EXPECT_EQ(faces_of(topo), (Faces{{0, 1, 2}, {0, 2, 3}}));
}

TEST(TopologyRemoveFace, OpensAHole) {
  Topology topo = nine_quads();
  topo.remove_face(topo.face(topo.find(n(5), n(6))));
  EXPECT_EQ(defect_of(topo), "");
  EXPECT_EQ(topo.face_count(), 8u);
  EXPECT_EQ(topo.edge_count(), 24u);
  EXPECT_EQ(outside_length(topo, topo.find(n(5), n(6))), 4u);
}

TEST(TopologyRemoveFace, TakesAwayEdgesThatLoseTheirLastFace) {
  Topology topo = nine_quads();
  topo.remove_face(topo.face(topo.find(n(0), n(1))));
  EXPECT_EQ(defect_of(topo), "");
  EXPECT_EQ(topo.edge_count(), 22u);
  EXPECT_FALSE(topo.out(n(0)).valid());
  topo.remove_node(n(0));
  EXPECT_EQ(topo.node_count(), 15u);
  EXPECT_EQ(outside_length(topo, topo.find(n(5), n(4))), 12u);
}

TEST(TopologyRemoveFace, LeavesPinchNodesWhole) {
  Topology topo = nine_quads(true);  // with the corner gone, node 5 joins two fans
  topo.remove_face(topo.face(topo.find(n(0), n(1))));
  EXPECT_EQ(defect_of(topo), "");
  EXPECT_EQ(topo.edge_valence(n(5)), 4);
}

TEST(TopologyRemoveFace, EmptiesTheMeshInAnyOrder) {
  const std::vector<std::size_t> orders[] = {
      {0, 1, 2, 3, 4, 5, 6, 7, 8}, {4, 0, 8, 2, 6, 1, 7, 3, 5}, {8, 4, 0, 3, 6, 5, 1, 2, 7}};
  for (const auto& order : orders) {
    Topology topo = nine_quads();
    for (const std::size_t f : order) {
      topo.remove_face(FaceId(f));
      ASSERT_EQ(defect_of(topo), "") << "after face " << f;
    }
    EXPECT_EQ(topo.edge_count(), 0u);
    EXPECT_EQ(topo.node_count(), 16u);
  }
}

struct Cavity {
  Topology topo = nine_quads();
  std::vector<FaceId> made;
  std::vector<HalfId> fresh;
  void replace(std::vector<FaceId> faces, const std::vector<Polygon>& polygons) {
    topo.replace_cavity(faces, polygons, made, fresh);
  }
  FaceId face(std::size_t a, std::size_t b) const { return topo.face(topo.find(n(a), n(b))); }
};

TEST(TopologyReplaceCavity, TurnsTheEdgeBetweenTwoQuads) {
  Cavity c;
  c.replace({c.face(0, 1), c.face(1, 2)}, {quad(0, 1, 2, 4), quad(4, 2, 6, 5)});
  EXPECT_EQ(defect_of(c.topo), "");
  ASSERT_EQ(c.made.size(), 2u);
  ASSERT_EQ(c.fresh.size(), 1u);
  EXPECT_EQ(corners(c.topo, c.made[0]), (std::vector<std::size_t>{0, 1, 2, 4}));
  EXPECT_TRUE(c.topo.find(n(4), n(2)).valid());
  EXPECT_FALSE(c.topo.find(n(1), n(5)).valid());
  EXPECT_EQ(c.topo.edge_count(), 24u);
  EXPECT_EQ(c.topo.edge_valence(n(5)), 3);
}

TEST(TopologyReplaceCavity, RemovesInnerNodesThatNothingNeeds) {
  Cavity c;
  // The star of node 5 becomes three quads without it.
  c.replace({c.face(0, 1), c.face(1, 2), c.face(5, 6), c.face(4, 5)},
            {quad(0, 1, 2, 4), quad(4, 2, 6, 10), quad(4, 10, 9, 8)});
  EXPECT_EQ(defect_of(c.topo), "");
  EXPECT_FALSE(c.topo.is_live(n(5)));
  EXPECT_EQ(c.topo.node_count(), 15u);
  EXPECT_EQ(c.topo.face_count(), 8u);
}

TEST(TopologyReplaceCavity, TakesNewNodesAndKeepsOldOnes) {
  Cavity c;
  const NodeId v = c.topo.add_node();
  const std::size_t w = v.value;
  // Vertex split of node 5 along 4 - 6.
  c.replace({c.face(0, 1), c.face(1, 2), c.face(5, 6), c.face(4, 5)},
            {quad(0, 1, w, 4), quad(1, 2, 6, w), quad(4, w, 6, 5), quad(4, 5, 9, 8), quad(5, 6, 10, 9)});
  EXPECT_EQ(defect_of(c.topo), "");
  EXPECT_EQ(c.topo.face_count(), 10u);
  EXPECT_EQ(c.topo.edge_valence(v), 3);
  EXPECT_EQ(c.topo.edge_valence(n(5)), 3);
  EXPECT_EQ(c.topo.edge_valence(n(4)), 4);
}

TEST(TopologyReplaceCavity, CutsAQuadInTrianglesAtTheBoundary) {
  Cavity c;
  c.replace({c.face(0, 1)}, {triangle(0, 1, 5), triangle(0, 5, 4)});
  EXPECT_EQ(defect_of(c.topo), "");
  EXPECT_EQ(c.topo.sides(c.made[0]), 3);
  EXPECT_TRUE(c.topo.is_triangle(c.made[1]));
  EXPECT_EQ(c.topo.edge_valence(n(0)), 3);
}

TEST(TopologyReplaceCavity, FillsTheWholeMesh) {
  Topology topo = diamond();
  std::vector<FaceId> made;
  std::vector<HalfId> fresh;
  topo.replace_cavity(std::vector<FaceId>{FaceId(0), FaceId(1)}, std::vector<Polygon>{quad(0, 1, 2, 3)}, made, fresh);
  EXPECT_EQ(defect_of(topo), "");
  EXPECT_TRUE(fresh.empty());
  EXPECT_EQ(topo.edge_count(), 4u);
  EXPECT_FALSE(topo.is_triangle(made[0]));
}

TEST(TopologyReplaceCavity, ReachesRoundASlit) {
  // The star of node 5 without the quad 0 1 5 4: an L round the node, which stays on the rim.
  Cavity c;
  c.replace({c.face(1, 2), c.face(5, 6), c.face(4, 5)}, {quad(1, 2, 6, 5), quad(5, 6, 8, 4), quad(6, 10, 9, 8)});
  EXPECT_EQ(defect_of(c.topo), "");
  EXPECT_EQ(c.topo.face_count(), 9u);
}

TEST(TopologyReplaceCavity, RefusesPolygonsThatDoNotFillTheCavity) {
  Cavity c;
  EXPECT_THROW(c.replace({c.face(0, 1), c.face(1, 2)}, {quad(0, 1, 2, 4)}), InternalError);
}

TEST(TopologyCompact, ClosesTheGapsInOrder) {
  Cavity c;
  c.replace({c.face(0, 1), c.face(1, 2), c.face(5, 6), c.face(4, 5)},
            {quad(0, 1, 2, 4), quad(4, 2, 6, 10), quad(4, 10, 9, 8)});
  const auto before = faces_of(c.topo);
  const Topology::Renumbering map = c.topo.compact();
  EXPECT_EQ(defect_of(c.topo), "");
  EXPECT_EQ(c.topo.node_capacity(), c.topo.node_count());
  EXPECT_EQ(c.topo.edge_capacity(), c.topo.edge_count());
  EXPECT_EQ(c.topo.face_capacity(), c.topo.face_count());
  EXPECT_FALSE(map.node[n(5)].valid());
  EXPECT_EQ(map.node[n(4)], n(4));
  EXPECT_EQ(map.node[n(15)], n(14));
  Faces renamed = before;
  for (auto& f : renamed)
    for (std::size_t& v : f) v = map.node[n(v)].value;
  std::sort(renamed.begin(), renamed.end());
  EXPECT_EQ(faces_of(c.topo), renamed);
}

TEST(TopologyCompact, ReusedSlotsAreWhole) {
  Cavity c;
  c.replace({c.face(0, 1), c.face(1, 2), c.face(5, 6), c.face(4, 5)},
            {quad(0, 1, 2, 4), quad(4, 2, 6, 10), quad(4, 10, 9, 8)});
  EXPECT_EQ(c.topo.add_node(), n(5));  // the slot of the node that went
  EXPECT_FALSE(c.topo.out(n(5)).valid());
  c.replace({c.face(0, 1), c.face(2, 6), c.face(4, 10)},
            {quad(0, 1, 5, 4), quad(1, 2, 6, 5), quad(5, 6, 10, 9), quad(4, 5, 9, 8)});
  EXPECT_EQ(defect_of(c.topo), "");
  EXPECT_EQ(faces_of(c.topo), faces_of(nine_quads()));
}

TEST(TopologyDefect, IsEmptyForAnEmptyMesh) {
  EXPECT_EQ(defect_of(Topology()), "");
  Topology topo = made_of(3, {});
  EXPECT_EQ(defect_of(topo), "");
  topo.compact();
  EXPECT_EQ(topo.node_count(), 3u);
}

TEST(TopologyLive, RangesSkipDeletedElementsInTheOrderOfTheirIds) {
  Topology topo = nine_quads();
  topo.remove_face(FaceId(0));  // a corner: two edges go with it
  topo.remove_face(FaceId(4));
  topo.remove_node(n(0));
  const auto ids = [](const auto& range) {
    std::vector<std::uint32_t> found;
    for (const auto id : range) found.push_back(id.value);
    return found;
  };
  EXPECT_EQ(ids(topo.faces()), (std::vector<std::uint32_t>{1, 2, 3, 5, 6, 7, 8}));
  EXPECT_EQ(ids(topo.nodes()).size(), topo.node_count());
  EXPECT_EQ(ids(topo.nodes()).front(), 1u);
  std::vector<std::uint32_t> edges;
  for (std::size_t i = 0; i < topo.edge_capacity(); ++i)
    if (topo.is_live(EdgeId(i))) edges.push_back(EdgeId(i).value);
  EXPECT_LT(edges.size(), topo.edge_capacity());
  EXPECT_EQ(ids(topo.edges()), edges);
  EXPECT_TRUE(ids(Topology().faces()).empty());
}

TEST(TopologyLive, ElementsMayBeRemovedOnTheWay) {
  Topology topo = nine_quads();
  for (const FaceId f : topo.faces()) topo.remove_face(f);
  EXPECT_EQ(topo.face_count(), 0u);
  EXPECT_EQ(topo.edge_count(), 0u);
  for (const NodeId v : topo.nodes()) topo.remove_node(v);
  EXPECT_EQ(topo.node_count(), 0u);
}

}  // namespace
}  // namespace quadline
