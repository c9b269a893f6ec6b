// The signs are compared with those of CGAL's kernel, another implementation of exact predicates, on inputs that are
// easy (random), full of ties (grids, circles), and next to ties (neighbouring doubles).
#include <gtest/gtest.h>

#ifdef QUADLINE_HAS_CGAL

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include "geom/predicates.hpp"
#include "tests/unit/geom/point_inputs.hpp"

namespace quadline {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

Kernel::Point_2 cgal(Point p) { return {p.x, p.y}; }

int cgal_orientation(Point a, Point b, Point c) {
  return static_cast<int>(CGAL::orientation(cgal(a), cgal(b), cgal(c)));
}
int cgal_in_circle(Point a, Point b, Point c, Point d) {
  return static_cast<int>(CGAL::side_of_oriented_circle(cgal(a), cgal(b), cgal(c), cgal(d)));
}

TEST(PredicatesAgainstCgal, SameSigns) {
  constexpr int kCases = 20000;
  for (const test::PointInput& input : test::point_inputs()) {
    test::Random r(7);
    int wrong = 0, ties = 0;
    for (int i = 0; i < kCases; ++i) {
      const Point a = input.point(r), b = input.point(r), c = input.point(r), d = input.point(r);
      const int side = orientation(a, b, c), inside = in_circle(a, b, c, d);
      wrong += side != cgal_orientation(a, b, c);
      wrong += inside != cgal_in_circle(a, b, c, d);
      ties += side == 0 || inside == 0;
    }
    EXPECT_EQ(wrong, 0) << input.name;
    EXPECT_EQ(ties > 0, input.has_ties) << input.name;
  }
}

}  // namespace
}  // namespace quadline

#else

TEST(PredicatesAgainstCgal, SameSigns) { GTEST_SKIP() << "CGAL is not installed"; }

#endif
