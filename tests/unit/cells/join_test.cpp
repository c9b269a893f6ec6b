#include "cells/join.hpp"

#include <gtest/gtest.h>

#include <set>

#include "cells/curve_nodes.hpp"
#include "domain/arrange/arrange.hpp"
#include "domain/size/size_field.hpp"
#include "stages/discretize/discretize.hpp"
#include "stages/triangulate/triangulate.hpp"
#include "tests/unit/cells/two_cells.hpp"

namespace quadline {
namespace {

// A lone point in the left one of two cells.
Model plate() {
  Model model = shapes::two_cells();
  model.points.push_back({.name = "load", .at = {3.3, 3.3}});
  return model;
}

WorkMesh all_joined(const IdVector<CellId, WorkMesh>& parts) {
  IdVector<CellId, const WorkMesh*> some;
  for (const WorkMesh& part : parts) some.push_back(part.topo().face_count() > 0 ? &part : nullptr);
  return joined(some);
}

class CellParts : public testing::Test {
 protected:
  CellId cell_at(bool right) const {
    for (std::size_t i = 0; i < domain_.cells.count(); ++i)
      if (domain_.cells[CellId(i)].lone_points.empty() == right) return CellId(i);
    return {};
  }
  WorkMesh triangles_of(CellId c) {
    WorkMesh part = cells_.of(c);
    triangulate(part, domain_, context_);
    part.keep_cell(c);
    part.drop_outside();
    part.compact();
    return part;
  }

  Context context_;
  const Domain domain_ = arrange(plate(), {}, context_);
  const WorkMesh nodes_ = discretize(domain_, make_size_field(domain_, {}, context_), {}, {}, context_);
  const SizeField size_ = make_size_field(domain_, {}, context_);
  const CurveNodes cells_{domain_, size_, {}, {}, {}, context_};
};

TEST_F(CellParts, HaveTheNodesOfTheirCell) {
  const CellId left = cell_at(false), right = cell_at(true);
  const WorkMesh part = cells_.of(left);
  bool has_point = false;
  for (std::size_t i = 0; i < part.topo().node_capacity(); ++i) {
    EXPECT_LE(part.point(NodeId(i)).x, 4);
    has_point |= part.point(NodeId(i)) == Point{3.3, 3.3};
  }
  EXPECT_TRUE(has_point);
  EXPECT_EQ(part.segments().size(), cells_.count(left));
  std::size_t n_shared = 0;
  for (const Segment& s : nodes_.segments()) {
    const Domain::Curve& c = domain_.curves[s.curve];
    n_shared += c.left.valid() && c.right.valid() && c.left != c.right;
  }
  EXPECT_EQ(n_shared, 8u);
  EXPECT_EQ(cells_.count(left) + cells_.count(right), nodes_.segments().size() + n_shared);
}

TEST_F(CellParts, JoinAtTheNodesThatTheyShare) {
  IdVector<CellId, WorkMesh> parts;
  std::size_t n_faces = 0;
  for (std::size_t i = 0; i < domain_.cells.count(); ++i) {
    parts.push_back(triangles_of(CellId(i)));
    n_faces += parts[CellId(i)].topo().face_count();
  }
  const WorkMesh mesh = all_joined(parts);
  EXPECT_EQ(defect(mesh), "");
  EXPECT_EQ(mesh.topo().face_count(), n_faces);
  EXPECT_EQ(mesh.topo().node_count(), nodes_.topo().node_capacity());
  EXPECT_EQ(mesh.segments().size(), nodes_.segments().size());
  std::set<std::pair<NodeId, NodeId>> once;
  for (const Segment& s : mesh.segments()) {
    EXPECT_EQ(mesh.curve(edge_of(mesh.topo().find(s.a, s.b))), s.curve);
    EXPECT_TRUE(once.insert({s.a, s.b}).second);
  }
  for (std::size_t i = 0; i < mesh.topo().face_capacity(); ++i) {
    const Polygon p = mesh.topo().polygon(FaceId(i));
    double x = 0;
    for (const NodeId v : p.corners()) x += mesh.point(v).x / p.n;
    EXPECT_EQ(mesh.cell(FaceId(i)), cell_at(x > 4));
  }
}

TEST_F(CellParts, OfSomeCellsJoinToo) {
  IdVector<CellId, WorkMesh> parts(domain_.cells.count());
  const CellId right = cell_at(true);
  parts[right] = triangles_of(right);
  const WorkMesh mesh = all_joined(parts);
  EXPECT_EQ(defect(mesh), "");
  EXPECT_EQ(mesh.topo().face_count(), parts[right].topo().face_count());
}

TEST(CellPartsOfNothing, JoinToNothing) {
  EXPECT_EQ(all_joined(IdVector<CellId, WorkMesh>(3)).topo().face_count(), 0u);
}

}  // namespace
}  // namespace quadline
