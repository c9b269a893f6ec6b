#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "domain/domain.hpp"
#include "quadline/context.hpp"
#include "quadline/options.hpp"

namespace quadline {

/// Target edge length h over the plane, graded: |h(p) - h(q)| <= g |p - q| with g = ln(growth), so that the lengths of
/// neighbouring edges along a line differ by at most the factor `growth` [BorouchakiGeorge1997, Persson2006].
///
/// A balanced quadtree over the domain with sizes at the corners of its leaves, bilinear inside a leaf and continuous;
/// in a leaf that holds a source the interpolation may be up to 1.41 times as steep, and pass the size asked by 5 %.
/// Where one size holds all over the domain the tree is one leaf, and the answer is exactly that size. Scaling the
/// model by a power of two scales the answers by it, bit for bit.
class SizeField {
 public:
  /// Target edge length at p, model units, > 0; outside the domain's box that of the nearest place in it. O(log n).
  double at(Point p) const {
    const double u = std::clamp((p.x - origin_.x) * per_side_, 0.0, 1.0);
    const double v = std::clamp((p.y - origin_.y) * per_side_, 0.0, 1.0);
    const std::uint32_t x = std::min(static_cast<std::uint32_t>(u * kLattice), kLattice - 1);
    const std::uint32_t y = std::min(static_cast<std::uint32_t>(v * kLattice), kLattice - 1);
    std::uint32_t node = 0;
    int bit = kMaxDepth;
    while (!(nodes_[node] & kLeaf)) {
      --bit;
      node = nodes_[node] + ((x >> bit) & 1) + 2 * ((y >> bit) & 1);
    }
    const double leaves = static_cast<double>(1u << (kMaxDepth - bit));
    const double fx = u * leaves - (x >> bit), fy = v * leaves - (y >> bit);
    const std::array<double, 4>& h = corners_[nodes_[node] & ~kLeaf];
    return h[0] + fx * (h[1] - h[0]) + fy * (h[2] - h[0]) + fx * fy * (h[3] - h[2] - h[1] + h[0]);
  }

  /// The same length everywhere, for no curves: `least_edges` has no answer. @param size  > 0, model units.
  static SizeField constant(double size);

  /// The least number of edges that shows the bend of a curve of the domain: 1 where it is straight.
  std::uint32_t least_edges(CurveId c) const { return least_edges_[c]; }

  /// The field of so many times the sizes; curves keep their least numbers of edges.
  SizeField scaled(double factor) const;

  std::size_t leaf_count() const { return corners_.size(); }

  /// About how many quads the sizes make of the domain. Known where Options::size_at is given, else 0.
  double quads_expected() const { return quads_expected_; }

 private:
  friend class SizeTree;
  friend SizeField make_size_field(const Domain& domain, const Options& options, Context& context);

  static constexpr int kMaxDepth = 26;
  static constexpr std::uint32_t kLattice = 1u << kMaxDepth;  ///< leaves of that depth along a side of the root
  static constexpr std::uint32_t kLeaf = 1u << 31;

  Point origin_;         ///< lower left corner of the root
  double per_side_ = 0;  ///< 1 / side of the root
  double quads_expected_ = 0;
  IdVector<CurveId, std::uint32_t> least_edges_;
  std::vector<std::uint32_t> nodes_;            ///< first of four children, or kLeaf | index into `corners_`
  std::vector<std::array<double, 4>> corners_;  ///< sizes at lower left, lower right, upper left, upper right
};

/// Size field from the sizes of the model, lines, points and regions, from the bends, the gaps and the short curves of
/// the domain, and from Options::size_at. See docs/sizing.md for what each asks.
///
/// @throws Cancelled when `context` asks for it.
/// @throws InputError  Options::size_at gives what is no length or less than four tolerances, changes from place to
/// place
///                     faster than half a million nodes of the tree can show, or asks for more than Options::max_quads.
/// Cost O(n log n) for n edges along the curves and nodes of the tree; Options::size_at is called nine times for each
/// of these, some 50,000 times where it is smooth.
SizeField make_size_field(const Domain& domain, const Options& options, Context& context);

}  // namespace quadline
