#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "domain/size/size_field.hpp"
#include "domain/size/size_sources.hpp"

namespace quadline {

/// Builds the tree of a size field: refined until each leaf is smaller than the sizes asked in it and shows the size
/// function, balanced two to one, graded from the least size upwards [Persson2006].
class SizeTree {
 public:
  /// @param base_at  the size that the cell at a point asks for; asked once per part of the plane that the border
  ///                 sources cut off, at a point off all curves.
  /// @param asked_at  the size function, for points of the box; may be empty.
  /// @throws InputError  the size function varies too fast.
  SizeTree(const Box& box, const std::vector<SizeSource>& sources, const std::function<double(Point)>& base_at,
           const std::function<double(Point)>& asked_at);

  /// Quads that the size function asks for where `is_inside`, by the middle of each leaf.
  double quads_asked(const std::function<bool(Point)>& is_inside) const { return quads(corner_asked_, is_inside); }
  /// The same for the graded sizes.
  double quads_graded(const std::function<bool(Point)>& is_inside) const { return quads(corner_size_, is_inside); }

  /// Spreads the sizes over the corners: the least of size + slope * distance over all that ask.
  void grade(double slope);
  void write(SizeField& field) const;

 private:
  struct Node {
    std::uint32_t below = 0;     ///< first of four children; 0: a leaf
    std::uint32_t x = 0, y = 0;  ///< lower left corner, in lattice units
    std::uint8_t depth = 0;
    bool is_border = false;             ///< a border source runs through it
    std::uint32_t first = 0, last = 0;  ///< leaves: sources that touch it, into `touching_`
  };

  void refine(const std::function<double(Point)>& asked_at);
  bool is_bent(const Node& node, const std::function<double(Point)>& asked_at) const;
  void take_asked(const std::function<double(Point)>& asked_at);
  double quads(const std::vector<double>& sizes, const std::function<bool(Point)>& is_inside) const;
  Point inside_box(Point p) const;
  void split(std::uint32_t id);
  void balance();
  void number_corners();
  void fill_base(const std::function<double(Point)>& base_at);
  bool halves(std::uint32_t leaf, std::array<double, 9>& h) const;
  const double* corner_at(std::uint64_t x, std::uint64_t y) const;
  Point place(std::uint32_t corner) const;
  double offer(std::uint32_t from, std::uint32_t corner, double slope) const;
  std::uint32_t leaf_at(std::uint32_t x, std::uint32_t y) const;
  Box box_of(const Node& node) const;
  bool touches(const SizeSource& source, const Node& node) const;
  std::uint32_t width(const Node& node) const { return SizeField::kLattice >> node.depth; }

  const std::vector<SizeSource>& sources_;
  Box box_;  ///< of the domain; the root is the square round it
  Point origin_;
  double side_;
  std::vector<Node> nodes_;
  std::vector<std::uint32_t> touching_;      ///< sources
  std::vector<std::uint32_t> leaves_;        ///< node ids
  std::vector<std::uint32_t> leaf_corners_;  ///< four corner ids per leaf
  std::vector<std::uint64_t> corner_key_;    ///< y << 32 | x in lattice units
  std::vector<std::uint32_t> corner_start_;  ///< into `corner_slots_`
  std::vector<std::uint32_t> corner_slots_;  ///< slots (4 * leaf + place) that share a corner
  std::vector<double> corner_base_;          ///< what its own cell asks; infinity beside borders
  std::vector<double> corner_asked_;         ///< what the size function asks; empty without one
  std::vector<double> corner_size_;
};

}  // namespace quadline
