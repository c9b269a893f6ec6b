#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "base/constants.hpp"
#include "domain/domain.hpp"
#include "domain/size/size_field.hpp"
#include "mesh/work_mesh.hpp"

namespace quadline::smoothing {

/// The three other corners of a quad, counter-clockwise after the node in question; and where the edge to the next
/// goes on straight through a regular node, the end of the edge beyond it, else none.
struct Spoke {
  std::uint32_t next, opposite, previous, beyond;
};

/// The movable nodes of a mesh and the quads round each, in flat arrays: smoothing reads nothing else.
class Stars {
 public:
  Stars(const WorkMesh& mesh, const Domain& domain, const SizeField& size, bool slides = true);

  std::size_t count() const { return node_.size(); }
  std::span<const Spoke> spokes(std::size_t i) const {
    return {spokes_.data() + first_[i], spokes_.data() + first_[i + 1]};
  }
  /// Four quads all round it.
  bool is_regular(std::size_t i) const {
    const std::span<const Spoke> s = spokes(i);
    return s.size() == 4 && s[3].previous == s[0].next;
  }
  Point at(std::size_t i) const { return point_[node_[i]]; }
  Point point(std::uint32_t node) const { return point_[node]; }
  /// Target edge length at the node's first place, model units.
  double size(std::size_t i) const { return size_[i]; }

  /// A node on a curve slides; all others move freely.
  bool slides(std::size_t i) const { return slide_of_[i] != kNone; }
  /// Unit vector from one neighbour along the curve of sliding node i to the other.
  Point tangent(std::size_t i) const;
  /// Its neighbours along the curve.
  std::pair<Point, Point> beside(std::size_t i) const {
    const Slide& slide = slides_[slide_of_[i]];
    return {point_[slide.before], point_[slide.after]};
  }
  struct Place {
    double s;
    Point point;
  };
  /// The place that is nearest to p of those where sliding node i may stand.
  Place slid(std::size_t i, Point p) const;

  /// Moves node i; where it slides, to `slid(i, p)`.
  void move(std::size_t i, Point p);

  // The work list: nodes to look at in the next sweep
  void wake(std::size_t i) {
    if (awake_[i]) return;
    awake_[i] = 1;
    list_.push_back(static_cast<std::uint32_t>(i));
  }
  /// Wakes node i and all that share a quad with it.
  void wake_around(std::size_t i);
  void wake_all();
  /// Those who woke since the last call, in order; valid until the next call.
  std::span<const std::uint32_t> take_awake();

  /// Writes the points back to the mesh.
  void store(WorkMesh& mesh) const;

 private:
  struct Slide {
    CurveId curve;
    double s;                     ///< arc length along the curve
    std::uint32_t before, after;  ///< neighbours along it
    double low, high;             ///< places of the neighbours, as long as they do not slide themselves
    double least, most;           ///< how far it may go
  };
  void add_star(const WorkMesh& mesh, NodeId v, const SizeField& size);
  bool add_slide(const WorkMesh& mesh, NodeId v);
  void limit_slides();
  void find_beyond();
  double place_of(std::uint32_t neighbour, const Slide& slide, bool before) const;

  const Domain& domain_;
  std::vector<Point> point_;            // of all nodes
  std::vector<std::uint32_t> star_of_;  // of all nodes: their star, or none
  std::vector<std::uint32_t> node_;     // of the stars
  std::vector<std::uint32_t> first_;    // of the stars: where their spokes begin
  std::vector<Spoke> spokes_;
  std::vector<std::uint32_t> slide_of_;  // of the stars: their slide, or none
  std::vector<Slide> slides_;
  std::vector<double> size_;
  std::vector<std::uint8_t> awake_;
  std::vector<std::uint32_t> list_, taken_;
};

}  // namespace quadline::smoothing
