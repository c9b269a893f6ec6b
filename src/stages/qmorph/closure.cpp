// Short loops close at once [Owen1999]: four edges become a quad, six the best of their patterns with two or three
// quads, so that single steps do not spoil them.
#include <algorithm>
#include <array>

#include "stages/qmorph/morph.hpp"

namespace quadline {

namespace {

constexpr double kPoor = 0.1;  // scaled Jacobian below which a sharp corner of the loop is rather seamed

// Corners of the loop (0..5; 6: a new node in the middle) of each quad of a pattern.
struct Pattern {
  int n;
  std::array<std::array<int, 4>, 3> quads;
};
constexpr std::array<Pattern, 5> kHexagons{{
    {2, {{{0, 1, 2, 3}, {3, 4, 5, 0}}}},                // cut from 0 to 3
    {2, {{{1, 2, 3, 4}, {4, 5, 0, 1}}}},                // cut from 1 to 4
    {2, {{{2, 3, 4, 5}, {5, 0, 1, 2}}}},                // cut from 2 to 5
    {3, {{{6, 0, 1, 2}, {6, 2, 3, 4}, {6, 4, 5, 0}}}},  // spokes to the even corners
    {3, {{{6, 1, 2, 3}, {6, 3, 4, 5}, {6, 5, 0, 1}}}},  // spokes to the odd corners
}};
constexpr double kPriceOfNode = 0.15;  // scaled Jacobian that a third quad must gain

}  // namespace

bool Morph::close_loop(HalfId base) {
  const Topology& topo = mesh_.topo();
  std::vector<NodeId> loop;
  std::vector<EdgeId> rim;
  HalfId h = base;
  do {
    loop.push_back(topo.tail(h));
    rim.push_back(edge_of(h));
    h = next_front(mesh_, h);
  } while (h != base && loop.size() <= 6);
  if (h != base || (loop.size() != 4 && loop.size() != 6)) return false;
  for (std::size_t i = 0; i < loop.size(); ++i)
    if (std::find(loop.begin(), loop.begin() + i, loop[i]) != loop.begin() + i) return false;
  std::vector<FaceId> inside;
  if (!enclosed_triangles(base, rim, inside)) return false;

  std::array<Point, 7> p{};
  Point mean;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    p[i] = mesh_.point(loop[i]);
    mean += (1.0 / static_cast<double>(loop.size())) * p[i];
  }
  p[6] = mean;
  int best = -1;
  double best_worth = -2, worst = -2;
  std::vector<Polygon> polygons;
  if (loop.size() == 4) {
    worst = scaled_jacobian({p[0], p[1], p[2], p[3]});
    polygons = {{loop[0], loop[1], loop[2], loop[3]}};
  } else {
    for (int i = 0; i < 5; ++i) {
      double least = 1;
      for (int q = 0; q < kHexagons[i].n; ++q) {
        const auto& c = kHexagons[i].quads[q];
        least = std::fmin(least, scaled_jacobian({p[c[0]], p[c[1]], p[c[2]], p[c[3]]}));
      }
      const double worth = least - (kHexagons[i].n == 3 ? kPriceOfNode : 0);
      if (worth <= best_worth || (kHexagons[i].n == 3 && !may_insert())) continue;
      best = i;
      best_worth = worth;
      worst = least;
    }
  }
  if (worst < kPoor) {
    h = base;
    do {
      const Corner corner = corner_after(mesh_, h);
      if (corner.quads == 0 && seam(corner)) return true;
      h = next_front(mesh_, h);
    } while (h != base);
    if (!enclosed_triangles(base, rim, inside)) return false;  // trying to seam may have swapped edges
  }
  if (loop.size() == 6) {
    NodeId middle;
    if (kHexagons[best].n == 3) {
      middle = mesh_.add_node(mean);
      parity_.forget(middle);
      --insertions_;
      parity_.tie(middle, loop[kHexagons[best].quads[0][1]], true);
    }
    const auto node = [&](int i) { return i == 6 ? middle : loop[i]; };
    for (int q = 0; q < kHexagons[best].n; ++q) {
      const auto& c = kHexagons[best].quads[q];
      polygons.push_back({node(c[0]), node(c[1]), node(c[2]), node(c[3])});
    }
  }
  ++(loop.size() == 4       ? counts_.closures_of_4
     : polygons.size() == 2 ? counts_.closures_of_6_by_2
                            : counts_.closures_of_6_by_3);
  put_quads(inside, polygons, level(edge_of(base)) + 1);
  touched_ = loop;
  smooth_around(loop);
  return true;
}

}  // namespace quadline
