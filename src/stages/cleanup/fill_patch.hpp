#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "quadline/point.hpp"

namespace quadline::cleanup {

/// A node of the rim of a patch, counter-clockwise.
struct PatchNode {
  Point at;
  double size = 1;         ///< target edge length there
  bool is_corner = false;  ///< one quad fits there; else two
};

/// A way to fill a patch.
struct Filling {
  int n_inner = 0;      ///< new nodes: after those of the rim
  int n_irregular = 0;  ///< inner nodes of three or five quads
  std::vector<std::array<std::uint16_t, 4>> quads;
};

/// Fills a patch whose rim has corners and straight sides with rows of quads and as few irregular nodes as can be: none
/// in a patch of four corners with equal opposite sides, one in most of three or five, and two where one cut makes two
/// such patches of it.
///
/// @param most            at most so many fillings, the least irregular and least strained first.
/// @param most_irregular  inner nodes of three or five quads, at most so many.
/// Cost O(n^2 L) for n rim nodes and cuts of up to L edges; n is small. Source: [Bunin2006, Takayama2014].
std::vector<Filling> fill_patch(std::span<const PatchNode> rim, std::size_t most, int most_irregular);

}  // namespace quadline::cleanup
