// The triangulation is compared with CGAL's, triangle by triangle, where it is unique; where it is not, both have the
// Delaunay property, exactly.
#include <gtest/gtest.h>

#ifdef QUADLINE_HAS_CGAL

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <string>

#include "tests/unit/triangulate/segments.hpp"

namespace quadline {
namespace {

using test::Random;
using test::Sketch;

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<std::uint32_t, Kernel>;
using FaceBase = CGAL::Constrained_triangulation_face_base_2<Kernel>;
using Structure = CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>;
using Cdt = CGAL::Constrained_Delaunay_triangulation_2<Kernel, Structure, CGAL::No_constraint_intersection_tag>;

/// Triangles that CGAL makes of the same nodes (box included) and segments.
std::set<test::Triangle> triangles_of_cgal(const WorkMesh& mesh) {
  Cdt cdt;
  std::vector<Cdt::Vertex_handle> vertices;
  for (std::size_t i = 0; i < mesh.topo().node_capacity(); ++i) {
    const Point p = mesh.point(NodeId(i));
    vertices.push_back(cdt.insert({p.x, p.y}));
    vertices.back()->info() = static_cast<std::uint32_t>(i);
  }
  for (const Segment& s : mesh.segments()) cdt.insert_constraint(vertices[s.a.value], vertices[s.b.value]);
  std::set<test::Triangle> all;
  for (auto f = cdt.finite_faces_begin(); f != cdt.finite_faces_end(); ++f)
    all.insert(test::in_order({f->vertex(0)->info(), f->vertex(1)->info(), f->vertex(2)->info()}));
  return all;
}

/// True where the segments a-b and c-d have more in common than an end of both.
bool clash(Point a, Point b, Point c, Point d) {
  const int c_side = orientation(a, b, c), d_side = orientation(a, b, d);
  const int a_side = orientation(c, d, a), b_side = orientation(c, d, b);
  if (a == c || a == d || b == c || b == d) return c_side == 0 && d_side == 0;
  return c_side * d_side <= 0 && a_side * b_side <= 0;
}

/// Nodes as `point` makes them (repeats are dropped), and up to n_segments that do not cross.
Sketch scatter(Random& r, std::size_t n_nodes, std::size_t n_segments, const std::function<Point(Random&)>& point) {
  Sketch s;
  std::vector<Point> nodes;
  while (nodes.size() < n_nodes) {
    const Point p = point(r);
    bool repeats = false;
    for (const Point q : nodes) repeats |= p == q;
    if (!repeats) nodes.push_back(p);
  }
  for (const Point p : nodes) s.node(p);
  const CurveId c = s.domain.curves.push_back({});
  for (std::size_t attempt = 0; attempt < 4 * n_segments; ++attempt) {
    const std::size_t a = r.below(n_nodes), b = r.below(n_nodes);
    bool fits = a != b && s.mesh.segments().size() < n_segments;
    for (const Segment& other : s.mesh.segments())
      fits = fits && !clash(nodes[a], nodes[b], nodes[other.a.value], nodes[other.b.value]);
    if (fits) s.mesh.add_segment({NodeId(a), NodeId(b), c});
  }
  return s;
}

struct Input {
  std::string name;
  bool is_unique;
  std::function<Point(Random&)> point;
};

TEST(TriangulateAgainstCgal, SameTrianglesWhereUnique) {
  const std::vector<Input> inputs{
      {"random", true, [](Random& r) { return Point{r.unit(), r.unit()}; }},
      {"clusters", true,
       [](Random& r) {
         const Point c{static_cast<double>(r.below(3)), static_cast<double>(r.below(3))};
         return c + (std::pow(r.unit(), 8) * Point{r.unit() - 0.5, r.unit() - 0.5});
       }},
      {"near a line", true,
       [](Random& r) {
         const double t = r.unit();
         return Point{t, 0.3 * t + 1e-14 * (r.unit() - 0.5)};
       }},
      {"grid", false,
       [](Random& r) { return Point{static_cast<double>(r.below(30)), static_cast<double>(r.below(20))}; }},
      {"grid of tenths", false,
       [](Random& r) { return Point{0.1 * static_cast<double>(r.below(30)), 0.1 * static_cast<double>(r.below(20))}; }},
      {"circle", false,
       [](Random& r) {
         const double a = 2 * std::numbers::pi * static_cast<double>(r.below(1000)) / 1000;
         return Point{std::cos(a), std::sin(a)};
       }},
      {"three circles", false,
       [](Random& r) {
         const double a = 2 * std::numbers::pi * static_cast<double>(r.below(100)) / 100;
         return static_cast<double>(1 + r.below(3)) * Point{std::cos(a), std::sin(a)};
       }},
  };
  for (const Input& input : inputs) {
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
      Random r(seed);
      Sketch s = scatter(r, 20 + 10 * seed, 3 * seed, input.point);
      const std::size_t wanted = s.mesh.segments().size();
      s.triangulate();
      ASSERT_EQ(defect(s.mesh), "") << input.name << " " << seed;
      ASSERT_GE(s.mesh.segments().size(), wanted);
      EXPECT_EQ(test::segments_missing(s.mesh), 0) << input.name << " " << seed;
      EXPECT_EQ(test::edges_not_delaunay(s.mesh), 0) << input.name << " " << seed;
      const auto theirs = triangles_of_cgal(s.mesh);
      EXPECT_EQ(theirs.size(), s.mesh.topo().face_count()) << input.name << " " << seed;
      if (!input.is_unique) continue;
      EXPECT_EQ(test::triangles(s.mesh), theirs) << input.name << " " << seed;
    }
  }
}

}  // namespace
}  // namespace quadline

#else

TEST(TriangulateAgainstCgal, SameTrianglesWhereUnique) { GTEST_SKIP() << "CGAL is not installed"; }

#endif
